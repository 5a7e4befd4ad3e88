// What a sweep reads off every point: expressions over results, and how the modes of failure came out.
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
    expression,   // of results: "rod.mass", "peak(lever.drive.M)"
    state,        // of the project, a step or a mode: a number of account::State
    utilisation,  // the largest of it; of modes that have none NaN
    passes        // 1 where all that applies is judged or accepted, else 0
  };
  Kind kind = Kind::expression;
  std::string name;  // of the column
  std::string text;  // as asked for
  std::string unit;  // that people read it in
  Dimension dimension;
  Expression expression;
  std::string step, mode;  // empty: of all
};

/// "m" and "rod.mass" of "m = rod.mass"; a text without a name is its own.
std::pair<std::string, std::string> name_and_text(const std::string& column);

/// A column from "rod.mass" or "m = rod.mass + pin.mass". Besides expressions there are "state", "utilisation" and
/// "passes" of the whole, of a step ("rod.utilisation") and of a mode of failure ("rod.modes.buckling.utilisation",
/// or "rod.modes.buckling" alone). A Fault tells what is wrong with the text.
Outcome<SweptResult> read_column(const std::string& text, Project& project);

/// What is read off every point: state and utilisation of the whole, then of every mode of failure.
std::vector<SweptResult> verdict_columns(const Project& project);

/// The modes of failure that a step may have, in the order of its calculator.
std::vector<std::string> modes_of(const Step& step);

}  // namespace loadpath::project
