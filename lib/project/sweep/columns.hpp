// The values that a sweep reads at every point: expressions over results, and the states of the failure modes.
#pragma once

#include "lib/account/fold.hpp"
#include "lib/project/project.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

struct SweptResult {
  enum class Kind {
    expression,   // expression over results: "rod.mass", "peak(lever.drive.M)"
    state,        // state of the project, a step or a mode: a number of account::State
    utilisation,  // the largest of it; of modes that have none NaN
    passes        // 1 where all that applies is assessed or accepted, else 0
  };
  Kind kind = Kind::expression;
  std::string name;  // name of the column
  std::string text;  // as requested
  std::string unit;  // display unit
  Dimension dimension;
  Expression expression;
  std::string step, mode;  // empty: of all
};

/// Without blanks at its ends.
std::string trimmed(const std::string& text);

/// "m" and "rod.mass" of "m = rod.mass"; a text without a name is its own.
std::pair<std::string, std::string> name_and_text(const std::string& column);

/// A column from "rod.mass" or "m = rod.mass + pin.mass". Besides expressions there are "state", "utilisation" and
/// "passes" of the project, of a step ("rod.utilisation") and of a failure mode ("rod.modes.buckling.utilisation", or
/// just "rod.modes.buckling"). A Fault describes an error in the text.
Outcome<SweptResult> read_column(const std::string& text, Project& project);

/// The columns read at every point: state and utilisation of the project, then of every failure mode.
std::vector<SweptResult> verdict_columns(const Project& project);

/// The failure modes that a step may have, in the order of its calculator.
std::vector<std::string> modes_of(const Step& step);

}  // namespace loadpath::project
