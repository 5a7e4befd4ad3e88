#include "lib/draw/drawing/fit.hpp"

#include "lib/draw/canvas/ticks.hpp"
#include "lib/draw/canvas/typeset.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <limits>

namespace loadpath::draw {
namespace {

using View = figure::Drawing::View;
using Side = figure::Drawing::Side;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double title_height = 20.0, scale_height = 24.0, note_height = 16.0;
constexpr double edge_of_page = 10.0;  // around all
constexpr double force_reach = 62.0;

bool has(const figure::Drawing::Value& value) { return drawable(value.si); }

template <class Items, class Keeps>
void keep(Items& items, const Keeps& keeps) {
  std::erase_if(items, [&](const auto& item) { return !keeps(item); });
}

bool all_drawable(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [](Point p) { return drawable(p); });
}

void include(Box& box, Point p) { box.include({p.x, p.y, p.x, p.y}); }

void include(Box& box, const std::vector<Point>& points) {
  for (const Point p : points) include(box, p);
}

/// The extent of the parts, in metres, y upwards.
Box extent_of(const View& view) {
  Box box{infinite, infinite, -infinite, -infinite};
  if (view.window) return {view.window->low.x, view.window->low.y, view.window->high.x, view.window->high.y};
  for (const auto& area : view.areas) include(box, area.outline);
  for (const auto& path : view.paths) include(box, path.points);
  for (const auto& c : view.circles) box.include(Box::around(c.centre, 2.0 * c.radius, 2.0 * c.radius));
  for (const auto& name : view.names) include(box, name.at);
  for (const auto& force : view.forces) include(box, force.at);
  return box;
}

struct Margins {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

bool is_upright(Side side) { return side == Side::left || side == Side::right; }

double text_width(const figure::Drawing::Value& value) { return width(typeset(words_of(value)), 1.05 * text_size); }

/// The occupied stretches of the rows on one side.
class Taken {
 public:
  /// The first row with space for the line, and for its text if that is outside.
  std::size_t row_of(Range line, Range text, bool beyond) {
    std::size_t row = 0;
    while (!is_free(row, line) || (beyond && !is_free(row + 1, text))) ++row;
    take(row, line);
    if (beyond) take(row + 1, text);
    return row;
  }

 private:
  [[nodiscard]] bool is_free(std::size_t row, Range of) const {
    return row >= rows_.size() || std::none_of(rows_[row].begin(), rows_[row].end(),
                                               [&](Range t) { return of.low < t.high - 0.5 && t.low < of.high - 0.5; });
  }
  void take(std::size_t row, Range range) {
    if (row >= rows_.size()) rows_.resize(row + 1);
    rows_[row].push_back(range);
  }
  std::vector<std::vector<Range>> rows_;
};

/// Dimension lines by their side, the shorter ones nearer to the parts, at this scale. A text that does not fit
/// between the extension lines is placed outside, and takes a row of its own.
std::vector<Row> rows_of(const View& view, double scale) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < view.lengths.size(); ++i) {
    if (view.lengths[i].side != Side::in_place) order.push_back(i);
  }
  const auto measured = [&](std::size_t i) {
    const auto& l = view.lengths[i];
    return is_upright(l.side) ? std::fabs(l.to.y - l.from.y) : std::fabs(l.to.x - l.from.x);
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return measured(a) < measured(b); });
  std::array<Taken, 4> sides;
  std::vector<Row> rows;
  for (const std::size_t i : order) {
    const auto& l = view.lengths[i];
    const bool upright = is_upright(l.side);
    const double a = scale * (upright ? l.from.y : l.from.x), b = scale * (upright ? l.to.y : l.to.x);
    const double low = std::min(a, b), high = std::max(a, b), half = 0.5 * text_width(l.value);
    const double lead = high - low < short_dimension ? short_lead : 0.0, middle = 0.5 * (low + high);
    const bool narrow = high - low < 2.0 * half + 6.0;
    const std::size_t row = sides[static_cast<std::size_t>(l.side)].row_of(
        {low - lead, high + lead}, {middle - half - 3.0, middle + half + 3.0}, narrow);
    rows.push_back({i, row, narrow});
  }
  return rows;
}

Margins margins_of(const View& view, const std::vector<Row>& rows) {
  const bool named = !view.names.empty() || !view.forces.empty() || !view.turns.empty();
  const double around = named && !view.window ? view.room : edge_of_page;
  Margins m{around, around, around, around};
  for (const Row& row : rows) {
    const auto& l = view.lengths[row.length];
    const bool text_outside = row.narrow || l.side == Side::left || l.side == Side::above;
    const double reach =
        first_row + dimension_row * static_cast<double>(row.row) + (text_outside ? line_height + 4.0 : 6.0);
    double& of = l.side == Side::left    ? m.left
                 : l.side == Side::right ? m.right
                 : l.side == Side::above ? m.top
                                         : m.bottom;
    of = std::max(of, reach + (named && !text_outside ? 4.0 : 0.0));
  }
  return m;
}

double strongest(const View& view) {
  double most = 0.0;
  for (const auto& f : view.forces) most = std::max(most, length(f.force));
  return most;
}

/// The parts with the tips of the arrows, in view units, y downwards, with the origin of the parts at zero.
Box on_page(const View& view, const Box& parts, double scale) {
  Box box{scale * parts.left, -scale * parts.bottom, scale * parts.right, -scale * parts.top};
  const double most = strongest(view);
  for (const auto& f : view.forces) {
    const double reach = (f.towards ? -1.0 : 1.0) * force_reach / most;
    include(box, Point{scale * f.at.x, -scale * f.at.y} + reach * Point{f.force.x, -f.force.y});
  }
  return box;
}

}  // namespace

int digits_of(const figure::Drawing::Value& value) { return value.unit == "mm" && std::fabs(value.si) >= 1.0 ? 5 : 4; }

std::string words_of(const figure::Drawing::Value& value) {
  const std::string number = format_quantity(value.si, value.unit, digits_of(value));
  return value.symbol.empty() ? number : say("{1} = {2}", symbol(value.symbol), number).text();
}

figure::Drawing::View without_gaps(const View& view) {
  View kept = view;
  keep(kept.areas,
       [](const auto& a) { return a.outline.size() > 2 && all_drawable(a.outline) && all_drawable(a.hole); });
  keep(kept.paths, [](const auto& p) { return p.points.size() > 1 && all_drawable(p.points); });
  keep(kept.circles, [](const auto& c) { return drawable(c.centre) && drawable(c.radius) && c.radius > 0.0; });
  keep(kept.surfaces, [](const auto& s) { return drawable(s.from) && drawable(s.to); });
  keep(kept.lengths, [](const auto& l) { return drawable(l.from) && drawable(l.to) && has(l.value); });
  keep(kept.radii, [](const auto& r) { return drawable(r.centre) && drawable(r.radius) && has(r.value); });
  keep(kept.angles, [](const auto& a) { return drawable(a.corner) && drawable(a.sweep) && has(a.value); });
  keep(kept.forces,
       [](const auto& f) { return drawable(f.at) && drawable(f.force) && has(f.value) && length(f.force) > 0.0; });
  keep(kept.supports, [](const auto& s) { return drawable(s.at) && drawable(s.into); });
  keep(kept.turns,
       [](const auto& t) { return drawable(t.centre) && drawable(t.radius) && (!t.value || has(*t.value)); });
  keep(kept.pressures, [](const auto& p) { return drawable(p.label) && has(p.value) && p.value.si != 0.0; });
  for (auto& p : kept.pressures)
    keep(p.arrows, [](const auto& a) { return drawable(a.foot) && drawable(a.direction); });
  keep(kept.names, [](const auto& n) { return drawable(n.at) && (!n.value || has(*n.value)); });
  return kept;
}

ViewFit fit(const View& view, Point corner, double width) {
  Box parts = extent_of(view);
  if (!(parts.right >= parts.left)) parts = {0.0, 0.0, 1.0, 1.0};
  const double size = std::max({parts.width(), parts.height(), 1e-12});
  ViewFit result;
  const double head = view.title.empty() ? 0.0 : title_height;
  const double foot = (view.is_scaled ? scale_height : 8.0) + (view.note.empty() ? 0.0 : note_height);
  Margins m = margins_of(view, rows_of(view, width / size));
  Box box;
  for (int pass = 0; pass < 3; ++pass) {  // texts that find no room between their heads need rows, which need room
    double low = 0.0, high = view_width / size;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      const Box trial = on_page(view, parts, middle);
      const bool fits =
          trial.width() <= width - m.left - m.right && trial.height() <= view.most_height - m.top - m.bottom;
      (fits ? low : high) = middle;
    }
    result.scale = std::max(low, 1e-3 * view_width / size);
    box = on_page(view, parts, result.scale);
    result.rows = rows_of(view, result.scale);
    const Margins needed = margins_of(view, result.rows);
    m = {std::max(m.left, needed.left), std::max(m.top, needed.top), std::max(m.right, needed.right),
         std::max(m.bottom, needed.bottom)};
  }
  const double spare = std::max(0.0, width - m.left - m.right - box.width());
  result.origin = {corner.x + m.left + 0.5 * spare - box.left, corner.y + head + m.top - box.top};
  const double most = strongest(view);
  result.newton = most > 0.0 ? force_reach / most : 0.0;
  result.extent = {result.at({parts.left, parts.bottom}).x, result.at({parts.left, parts.bottom}).y,
                   result.at({parts.right, parts.top}).x, result.at({parts.right, parts.top}).y};
  const double bottom = corner.y + head + m.top + box.height() + m.bottom;
  result.words = {corner.x + 2.0, corner.y + head + 1.0, corner.x + width - 2.0, bottom + 4.0};
  result.area = {corner.x, corner.y, corner.x + width, bottom + foot};
  return result;
}

}  // namespace loadpath::draw
