// A calculator without its C++ types, for the program's commands, readers, searches, sweeps and reports.
#pragma once

#include "lib/calculator/bound.hpp"
#include "lib/calculator/form.hpp"
#include "lib/calculator/meaning.hpp"
#include "lib/calculator/mode.hpp"
#include "lib/calculator/record.hpp"
#include "lib/calculator/sizing.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/figure/figure.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

struct RuleInfo {
  const char* fields;
  const char* text;
  bool only_warns = false;
  const char* modes = "";  // failure modes whose verdicts show the warning of the rule: an assumption
};

/// A result that depends on the model: "drive.M", or "joints.NAME.F", where NAME is a name from the input.
struct ResultPattern {
  const char* path;
  const char* unit;
  const char* doc;
  const char* where;  // when it exists; empty: always
  bool is_load = false;
  const char* companions = "";  // loads acting together with it on the same part: "V, M_b"
};

/// A predefined form of an input: a few parameters in place of many elements. In a project file the key `template`
/// names it, and its parameters are next to the calculator's own fields.
struct Template {
  const char* id = "";       // "slider_crank"
  const char* title = "";    // "Slider-crank, central or offset"
  const char* doc = "";      // topology, and position of the origin
  const char* example = "";  // a project file that runs
  const RecordType* parameters = nullptr;
  /// Puts every element that the template makes into a blank input: names, no values.
  void (*lay_out)(void* input) = nullptr;
};

/// A column of a sweep: where a leaf of the input (or result) lies inside its record, and its values.
struct InputColumn {
  std::size_t offset;  // bytes from the start of the aggregate
  const double* si;
};
struct ResultColumn {
  std::size_t offset;
  double* si;
};

/// `count` evaluations; `input` is the base record, of which only the varying inputs are changed. Allocates nothing.
using SweepLoop = void (*)(void* input, std::span<const InputColumn> in, std::span<const ResultColumn> out,
                           std::size_t count);

/// Indices of the points among `count` that violate one of the given rules, and the modes that concern the part
/// there, mode by mode. `other`: points to be skipped; those that violate a rule are added.
using Survey = void (*)(void* input, std::span<const InputColumn> in, std::span<const char> rules,
                        std::span<Applies* const> modes, std::size_t count, char* other);

struct Calculator {
  const char* id = "";        // "shaft.torsion"
  const char* title = "";     // "Torsion of a shaft"
  const char* scope = "";     // subject, assumptions, exclusions
  const char* synonyms = "";  // search words in English, German and Russian: "feather key, Passfeder, шпонка"
  const char* source = "";    // keys of tables/sources.toml: "[B19]"
  const char* example = "";   // a project file that runs
  /// The size of its part in a phrase: "C = {C}", "{b#}x{h#}x{l}" where # leaves the unit out, "torque {drive.M!}"
  /// where a zero counts as unknown; several behind | where the first has a value that is not known.
  const char* headline = "";
  /// What a user expects after the size, in the same notation: "d_1 = {d_1}, L = {L}"; may be empty.
  const char* details = "";
  const char* subject = "";  // subject of its modes: "torsion"; may be empty
  /// Keys that a step cites only where it uses them (account::Account::sources).
  std::vector<std::string> (*used_sources)() = [] { return std::vector<std::string>(); };
  const RecordType* input = nullptr;
  const RecordType* result = nullptr;
  /// Replaces `result` if names in the input form the paths.
  std::vector<ResultPattern> (*patterns)() = [] { return std::vector<ResultPattern>(); };
  std::span<const Template* const> templates;
  std::span<const RuleInfo> rules;
  bool (*holds)(std::size_t rule, const void* input) = nullptr;
  /// The violation of a rule by an input: the particulars of the rule, else its text.
  FieldFault (*fault_of)(std::size_t rule, const void* input) = nullptr;
  std::span<const ModeInfo> modes;
  Applies (*applies)(std::size_t mode, const void* input) = nullptr;
  void (*evaluate)(const void* input, void* result) = nullptr;
  void (*explain)(const void* input, void* result, Trace& trace) = nullptr;
  std::vector<figure::Figure> (*figures)(const void* input, const void* result) = nullptr;
  /// The fastest loop for the given base, varying inputs and requested results. It serves every block of columns with
  /// these offsets: a sweep of many blocks requests it once.
  SweepLoop (*loop)(const void* input, std::span<const InputColumn> in, std::span<const ResultColumn> out) = nullptr;
  /// `holds` and, if modes are requested, `applies` for a block of points.
  Survey survey = nullptr;
  /// The forms that have a loop of their own.
  std::span<const Form> forms;
  /// Requests that loop and runs it.
  SweepLoop sweep = nullptr;
  Sizing sizing;
  std::span<const Meaning> meanings;
  std::span<const SenseClaim> senses;
  std::span<const NotchClaim> notches;
  std::span<const BoundInfo> bounds;
  double (*bound)(std::size_t bound, const void* input, std::size_t element) = nullptr;
  /// Whether an input may be a series: not where it decides on one thing for all its loads, a belt and its tension, a
  /// section. At every position of a cycle it would find another.
  bool takes_series = true;
  /// Whether its part turns, or moves under loads that vary: those that it gives to others come again and again.
  bool turns = false;
  /// Whether the parts that take its loads are those of one drive, which have one application factor.
  bool is_one_drive = false;
  /// The input with the required life without which the part is rated for endurance: "L_h"; empty: it has none.
  const char* life = "";
  /// Whether `finish` is that of tooth flanks, whose processes leave other roughnesses than those of shafts.
  bool has_flanks = false;

  [[nodiscard]] std::string_view element() const {
    const std::string_view all = id;
    return all.substr(0, all.find('.'));
  }
};

using Calculators = std::span<const Calculator* const>;

/// The erased form of a calculator class: defined by lib/calculator/calculator_of.hpp, instantiated in the calculator's
/// source.
template <class C>
const Calculator& erased();

const Calculator* find_calculator(Calculators calculators, std::string_view id);
/// The groups of tables that its inputs can be taken from, each once, in the order of the fields: "material".
std::vector<std::string> table_groups(const Calculator& calculator);
const Template* find_template(const Calculator& calculator, std::string_view id);

}  // namespace loadpath
