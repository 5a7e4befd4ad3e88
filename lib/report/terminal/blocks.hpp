// The blocks of the short answer, each as lines, and how much of each is shown.
#pragma once

#include "lib/report/summary/summary.hpp"
#include "lib/report/terminal/look.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace loadpath::terminal {

using Lines = std::vector<std::string>;

/// How much of each block is shown: lowered step by step until the answer has few enough lines.
class Limits {
 public:
  enum Block { components, next, fixes, scope, names, hints, formulas };
  [[nodiscard]] std::size_t of(Block block) const;
  /// The next step of lowering; false where nothing is left to lower.
  bool lower();
  /// Takes one step of a block back; false where none was taken.
  bool raise(std::size_t block);
  static constexpr std::size_t blocks = 7;

 private:
  std::array<std::size_t, blocks> steps_{};  // taken so far
  std::size_t turn_ = 0;
};

/// The blocks below one another, a line without text between them.
Lines joined(const std::vector<Lines>& blocks);
std::string text_of(const Lines& lines);

/// As many blocks as there are lines for, a line without text between them: at most 25 lines, if that is possible.
std::string fitted(const std::function<std::vector<Lines>(const Limits&)>& blocks, const Look& look);

Lines verdict_lines(const report::Summary& summary, const Look& look);
/// Failing modes without a utilisation.
Lines failure_lines(const report::Summary& summary, const Limits& limits, const Look& look);
Lines next_lines(const report::Summary& summary, const Limits& limits, const Look& look);
/// Not assessed, and outside the scope.
Lines gap_lines(const report::Summary& summary, const Limits& limits, const Look& look);
/// Accepted by the user, for reasons that the report has, and not considered.
Lines open_lines(const report::Summary& summary, const Limits& limits, const Look& look);
Lines more_line(const std::string& command, const Look& look);

}  // namespace loadpath::terminal
