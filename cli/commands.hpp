// The commands of the program, one source each: plain options in, an exit code out.
#pragma once

#include "cli/exit.hpp"
#include "cli/options.hpp"
#include "cli/version.hpp"
#include "lib/calculator/calculator.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::cli {

struct RunOptions {
  std::vector<std::string> files;      // and folders of them
  std::optional<std::uint64_t> point;  // index of a point of a sweep
  PointOptions points;
  /// Fields that replace those of the file: "shaft.d=45 mm".
  std::vector<std::string> settings;
  OutputOptions output;
};
int run(const RunOptions& options);

struct SweepOptions {
  std::string file;
  std::vector<std::string> results;
  PointOptions points;
  /// Fields that replace those of the file: "shaft.d=45 mm".
  std::vector<std::string> settings;
  unsigned jobs = 0;                 // threads; 0: as many as the machine has
  std::size_t worst = 5;             // number of points listed
  std::string pareto;                // "m:min,u:min"
  std::string csv;                   // file
  std::string hdf5;                  // file
  std::vector<std::string> reports;  // .html, .md, .tex, .pdf
  std::string out;                   // folder of columns and state
  std::string shard;                 // "2/10"
  std::vector<std::string> merge;    // folders of shards
  bool resume = false;
  std::string status;       // folder of the sweep whose status is shown
  double save_every = 2.0;  // seconds between states on the disk
  bool no_columns = false;
  std::string minimise, maximise;      // a result to be optimised; only the best design instead of all points
  std::vector<std::string> such_that;  // "every mode passes", "rod.mass <= 5 kg"
  double quantile = 0.0;               // of uncertain results; 0: 0.99 of designs, the mean of an optimum
  std::string seek;                    // "shaft.u_tau = 0.9"
  bool influence = false;              // tornado, slopes, budget of the scatter
  std::uint64_t sobol = 0;             // rows; 0: no Sobol indices
  bool full = false;                   // every table instead of the answer
  bool json = false;
  bool quiet = false;
  bool strict = false;
};
int sweep(const SweepOptions& options);

/// Why a project, a step, a result or a failure mode came out as it did.
struct WhyOptions {
  std::string file;
  std::string of;                      // "rod", "rod.u", "rod.buckling"; empty: the step that decides the verdict
  std::optional<std::uint64_t> point;  // index of a point of a sweep
  PointOptions points;
  /// Fields that replace those of the file: "shaft.d=45 mm".
  std::vector<std::string> settings;
};
int why(const WhyOptions& options);

/// One calculator from the shell: its flags are the keys of a project file. With a file the steps of this calculator
/// in it, and those that they refer to; the flags then replace values of these steps.
struct CalculateOptions {
  const Calculator* calculator = nullptr;
  std::string file;
  std::string at;                                           // crank angles that replace those of the file
  std::vector<std::pair<std::string, std::string>> values;  // key, text as typed
  /// Fields of any step of the file: "shaft.d=45 mm".
  std::vector<std::string> settings;
  std::vector<std::string> because;   // inputs with reasons: "R_e=certificate 4711"
  std::vector<std::string> accepted;  // failure modes with reasons: "pitting=rated by the manufacturer"
  OutputOptions output;
};
int calculate(const CalculateOptions& options);

struct ListOptions {
  std::vector<std::string> words;  // an element, or what is searched for; none: all
  bool all = false;                // those found by failure mode or scope as well
  bool json = false;
};
int list(const ListOptions& options);

struct DescribeOptions {
  std::string id;
  std::string name;  // behind an element: shaft torsion; else a field or a failure mode, or a part: modes
  std::string part;  // behind both
  bool full = false;
  bool toml = false;  // the example only, as a project file
  bool json = false;
};
int describe(const DescribeOptions& options);

struct ConvertOptions {
  std::string quantity;
  std::string unit;
};
int convert(const ConvertOptions& options);

struct VerifyOptions {
  std::vector<std::string> files;
  bool json = false;
  bool full = false;                 // every value of the built-in cases too
  std::vector<std::string> reports;  // .html, .md, .tex, .pdf
};
int verify(const VerifyOptions& options);

struct TablesOptions {
  std::string table;
  std::string key;
  std::string where;  // "I_min >= 300 cm^4 and h <= 200 mm"
  std::string sort;   // "m", "-m"
  bool audit = false;
  bool json = false;
};
int tables(const TablesOptions& options);

/// A project that is solved whenever it is saved, its report in a browser.
struct WatchOptions {
  std::string file;
  unsigned short port = 0;  // 0: a free one
  bool open = false;
  bool strict = false;
};
int watch(const WatchOptions& options);

/// A completion script for a shell; or the candidates that the script requests.
struct CompletionOptions {
  std::string shell;               // bash, zsh, fish; candidates
  std::vector<std::string> words;  // up to the one that is begun
};
int completion(const CompletionOptions& options);

/// The manual page, as roff.
int man();

int schema();

/// A language server on standard input and output, for editors, until it receives the exit request.
int language_server();

}  // namespace loadpath::cli
