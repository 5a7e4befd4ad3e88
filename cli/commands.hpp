// The commands of the program, one source each: plain options in, an exit code out.
#pragma once

#include "lib/calculator.hpp"

#include <string>
#include <utility>
#include <vector>

namespace loadpath::cli {

/// Exit codes, as the help text tells them.
enum Exit : int { passed = 0, not_passed = 1, wrong_input = 2, fault = 3, interrupted = 130 };

/// What every solving command can write.
struct OutputOptions {
  std::vector<std::string> reports;  // .html, .md, .pdf
  bool json = false;
  std::string csv;  // folder
  bool quiet = false;
};

struct RunOptions {
  std::string file;
  OutputOptions output;
};
int run(const RunOptions& options);

/// One calculator from the shell: its flags are the keys of a project file.
struct CalculateOptions {
  const Calculator* calculator = nullptr;
  std::vector<std::pair<std::string, std::string>> values;  // key, text as typed
  OutputOptions output;
};
int calculate(const CalculateOptions& options);

int list();

struct DescribeOptions {
  std::string id;
};
int describe(const DescribeOptions& options);

struct ConvertOptions {
  std::string quantity;
  std::string unit;
};
int convert(const ConvertOptions& options);

struct VerifyOptions {
  std::vector<std::string> files;
};
int verify(const VerifyOptions& options);

struct TablesOptions {
  std::string table;
  std::string key;
  bool audit = false;
};
int tables(const TablesOptions& options);

int schema();

/// "loadpath 0.1.0"
std::string program();

}  // namespace loadpath::cli
