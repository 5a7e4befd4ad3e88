#include "calculators/gear/sizing/search.hpp"

#include "calculators/gear/sizing/load_bound.hpp"
#include "calculators/gear/sizing/nearest.hpp"
#include "calculators/gear/sizing/rated.hpp"

#include <algorithm>
#include <vector>

namespace loadpath::gear::sizing {

namespace {

/// The points of the range in the order of the ranking.
std::vector<Point> points_of(const Input& in, const Range& range) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < range.options.size(); ++i) {
    const PairResult g = laid_out(range.teeth(i));
    for (const double b : widths_of(in, range.options[i].m, g.d_1 / mm)) points.push_back(point_of(in, i, g, b));
  }
  std::sort(points.begin(), points.end());
  return points;
}

RatingTypes::Input teeth_at(const Range& range, const Point& point) {
  RatingTypes::Input teeth = range.teeth(point.option);
  teeth.b = point.b * mm;
  return teeth;
}

Found tried(const Input& in, const Range& range, const Point& point) {
  const RatingTypes::Input teeth = teeth_at(range, point);
  return is_admissible(teeth) ? rated(in, teeth) : unrated(in, teeth);
}

/// What the walk over the points keeps.
struct Walk {
  Found best;  // the first that passes, else the one nearest to passing
  std::size_t place = 0;
  std::vector<bool> settled;
  std::vector<Found> nearest;  // to passing, until a pair passes
};

void keep_nearest(const Found& one, std::vector<Found>& nearest) {
  const auto place = std::find_if(nearest.begin(), nearest.end(),
                                  [&](const Found& other) { return one.shortfall.less_than(other.shortfall); });
  nearest.insert(place, one);
  if (nearest.size() > most_rows) nearest.pop_back();
}

void keep_rejected(const Found& one, Walk& walk, Result& r) {
  if (r.found > 0.0) return;
  if (r.rejected.size() == most_rows) r.rejected.pop_back();
  r.rejected.insert(r.rejected.begin(), one.row);
  if (one.shortfall.failure != Failure::fit) keep_nearest(one, walk.nearest);
}

/// Keeps one point; its option is settled once it passes, or where no width helps.
void keep(const Found& one, const Point& point, std::size_t place, Walk& walk, Result& r) {
  if (one.shortfall.none()) {
    if (r.found == 0.0) walk.best = one, walk.place = place;
    r.found += 1.0;
    r.candidates.push_back(one.row);
  } else {
    keep_rejected(one, walk, r);
  }
  walk.settled[point.option] = !is_of_load(one.shortfall.failure) || one.shortfall.none();
}

/// Where none passes, the pairs nearest to passing are shown instead of those that rank last.
void show_nearest(Walk& walk, Result& r) {
  if (r.found > 0.0 || walk.nearest.empty()) return;
  walk.best = walk.nearest.front();
  r.rejected.clear();
  for (const Found& one : walk.nearest) r.rejected.push_back(one.row);
}

/// Whether a walk that leaves out nothing comes to this point: no narrower one has settled its option. What settles it
/// without passing, a limit or a rule, holds of every wider one, so that the width before decides.
bool is_reached(const Input& in, const Range& range, const Point& point) {
  const std::vector<double> all =
      widths_of(in, range.options[point.option].m, laid_out(range.teeth(point.option)).d_1 / mm);
  const auto here = std::find(all.begin(), all.end(), point.b);
  if (here == all.begin()) return true;
  Point before = point;
  before.b = *(here - 1);
  return is_of_load(tried(in, range, before).shortfall.failure);
}

/// The rejected pairs ahead of the best one, which a walk by the bounds has left out.
void show_rejected(const Input& in, const Range& range, const std::vector<Point>& points, std::size_t best, Result& r) {
  r.rejected.clear();
  for (std::size_t i = best; i-- > 0 && r.rejected.size() < most_rows;) {
    if (is_reached(in, range, points[i])) r.rejected.push_back(tried(in, range, points[i]).row);
  }
}

/// All points in the order of the ranking, without those that the bounds reject.
Found walk_through(const Input& in, const Range& range, const Bounds& bounds, Result& r) {
  Walk walk{{}, 0, std::vector<bool>(range.options.size(), false), {}};
  const std::vector<Point> points = points_of(in, range);
  for (std::size_t i = 0; i < points.size() && r.candidates.size() < most_rows; ++i) {
    const Point& point = points[i];
    const Option& option = range.options[point.option];
    if (walk.settled[point.option] || bounds.reject(option) || bounds.at(option, point.b) > 1.0) continue;
    keep(tried(in, range, point), point, i, walk, r);
  }
  show_nearest(walk, r);
  if (!bounds.empty() && r.found > 0.0) show_rejected(in, range, points, walk.place, r);
  return walk.best;
}

}  // namespace

double measure_of(const Candidate& c, By by) { return by == By::mass ? in_si(c.mass) : in_si(c.a_w); }

Found search_for(const Input& in, Result& r) {
  Input loaded = in;
  NoTrace quiet;
  loaded.T_1 = torque_of(in, quiet);
  const Range range = range_of(loaded);
  r.tried = static_cast<double>(range.options.size());
  if (!has_one_shape(in)) return walk_through(in, range, {}, r);
  const Bounds bounds(range);
  const Nearest nearest = nearest_of(in, range, bounds);
  if (nearest.one_passes) return walk_through(in, range, bounds, r);
  if (nearest.found.empty()) return walk_through(in, range, {}, r);
  for (const Found& one : nearest.found) r.rejected.push_back(one.row);
  return nearest.found.front();
}

}  // namespace loadpath::gear::sizing
