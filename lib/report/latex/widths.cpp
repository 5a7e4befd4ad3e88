#include "lib/report/latex/widths.hpp"

#include "lib/report/columns.hpp"

#include <algorithm>
#include <array>

namespace loadpath::report::tex {
namespace {

/// The number of letters in a line of a type size, on A4 and Letter.
struct Type {
  std::string_view name;
  double letters;
};
constexpr std::array types = {Type{"\\small", 105.0}, Type{"\\footnotesize", 114.0},
                              Type{"\\scriptsize", letters_of_line}};

template <class Letters>
double sum(const std::vector<Need>& needs, const Letters& letters) {
  double all = 0.0;
  for (const Need& need : needs) all += letters(need);
  return all;
}

bool fits(const std::vector<Need>& needs, double room) { return sum(needs, comfortable) <= room; }

/// No column is wider than this level, except for its minimum width: so all of them fill the room.
double level_of(const std::vector<Need>& needs, double room) {
  double low = 0.0, high = room;
  for (int i = 0; i < 30; ++i) {
    const double level = 0.5 * (low + high);
    const double all = sum(needs, [&](const Need& need) { return std::max(need.least, std::min(need.all, level)); });
    (all <= room ? low : high) = level;
  }
  return low;
}

}  // namespace

double comfortable(const Need& need) {
  constexpr double ease = 1.25;  // over the least: else columns of words are as high as wide
  return std::min(ease * need.least, need.all);
}

Widths widths_of(const std::vector<Need>& needs) {
  const double between = between_columns * static_cast<double>(needs.size());
  const auto is_wide_enough = [&](const Type& type) { return fits(needs, type.letters - between); };
  const auto* type = std::find_if(types.begin(), types.end() - 1, is_wide_enough);
  const double room = type->letters - between, level = level_of(needs, room);
  Widths out{std::string(type->name), {}};
  for (const Need& need : needs) {
    const double letters = std::max(need.least, std::min(need.all, level));
    out.shares.push_back(letters < need.all - 0.01 ? letters / type->letters : 0.0);
  }
  return out;
}

}  // namespace loadpath::report::tex
