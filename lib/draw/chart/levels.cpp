#include "lib/draw/chart/levels.hpp"

#include <array>
#include <map>

namespace loadpath::draw {
namespace {

/// An edge of the lattice that the level crosses: the node that it starts from, and whether it goes up.
using Edge = std::size_t;
struct Crossing {
  Point at;
  std::vector<Edge> next;  // one or two
};
using Crossings = std::map<Edge, Crossing>;

class Marching {
 public:
  Marching(const Lattice& lattice, const std::vector<double>& values, double level)
      : lattice_(lattice), values_(values), level_(level) {}

  void cross_cell(std::size_t column, std::size_t row);
  std::vector<std::vector<Point>> lines();

 private:
  [[nodiscard]] double value(std::size_t column, std::size_t row) const { return values_[lattice_.node(column, row)]; }
  [[nodiscard]] bool above(std::size_t column, std::size_t row) const { return value(column, row) > level_; }
  Edge cross(std::size_t column, std::size_t row, bool up);
  void join(Edge a, Edge b);
  std::vector<Point> follow(Edge start);

  const Lattice& lattice_;
  const std::vector<double>& values_;
  double level_;
  Crossings crossings_;
};

Edge Marching::cross(std::size_t column, std::size_t row, bool up) {
  const Edge edge = 2 * lattice_.node(column, row) + (up ? 1 : 0);
  const std::size_t column2 = column + (up ? 0 : 1), row2 = row + (up ? 1 : 0);
  const double a = value(column, row), b = value(column2, row2), share = (level_ - a) / (b - a);
  const Point from{lattice_.x[column], lattice_.y[row]}, to{lattice_.x[column2], lattice_.y[row2]};
  crossings_[edge].at = from + share * (to - from);
  return edge;
}

void Marching::join(Edge a, Edge b) {
  crossings_[a].next.push_back(b);
  crossings_[b].next.push_back(a);
}

void Marching::cross_cell(std::size_t column, std::size_t row) {
  const std::size_t right = column + 1, top = row + 1;
  const double sum = value(column, row) + value(right, row) + value(right, top) + value(column, top);
  if (!std::isfinite(sum)) return;
  const std::array<bool, 4> is_above{above(column, row), above(right, row), above(right, top), above(column, top)};
  std::vector<Edge> around;  // from the first side on, counter-clockwise
  for (std::size_t side = 0; side < 4; ++side) {
    if (is_above[side] == is_above[(side + 1) % 4]) continue;
    around.push_back(cross(side == 1 ? right : column, side == 2 ? top : row, side % 2 == 1));
  }
  if (around.size() == 2) join(around[0], around[1]);
  if (around.size() < 4) return;
  const bool cut_first = is_above[0] != (0.25 * sum > level_);  // a saddle: the first corner is separate
  join(around[0], around[cut_first ? 3 : 1]);
  join(around[cut_first ? 1 : 3], around[2]);
}

std::vector<Point> Marching::follow(Edge start) {
  std::vector<Point> line;
  for (Edge at = start;;) {
    Crossing& here = crossings_.at(at);
    line.push_back(here.at);
    if (here.next.empty()) return line;
    const Edge next = here.next.back();
    here.next.pop_back();
    std::erase(crossings_.at(next).next, at);
    at = next;
  }
}

std::vector<std::vector<Point>> Marching::lines() {
  std::vector<std::vector<Point>> all;
  for (const std::size_t ends : {1, 2}) {  // open lines from an end first
    for (const auto& [edge, crossing] : crossings_) {
      if (crossing.next.size() == ends) all.push_back(follow(edge));
    }
  }
  return all;
}

/// The interval of rising or falling values that holds v, or is nearest to it.
std::pair<std::size_t, double> interval(const std::vector<double>& values, double v) {
  const bool rises = values.back() > values.front();
  const auto after = std::partition_point(values.begin() + 1, values.end() - 1,
                                          [&](double here) { return rises ? here <= v : here >= v; });
  const auto i = static_cast<std::size_t>(after - values.begin()) - 1;
  return {i, std::clamp((v - values[i]) / (values[i + 1] - values[i]), 0.0, 1.0)};
}

}  // namespace

InCell cell_at(const Lattice& lattice, Point place) {
  const auto [column, across] = interval(lattice.x, place.x);
  const auto [row, up] = interval(lattice.y, place.y);
  return {column, row, across, up};
}

double between(const Lattice& lattice, const std::vector<double>& values, const InCell& in) {
  const auto along = [&](std::size_t row) {
    const std::size_t node = lattice.node(in.column, row);
    return (1.0 - in.across) * values[node] + in.across * values[node + 1];
  };
  return (1.0 - in.up) * along(in.row) + in.up * along(in.row + 1);
}

std::vector<std::vector<Point>> level_lines(const Lattice& lattice, const std::vector<double>& values, double level) {
  Marching marching(lattice, values, level);
  for (std::size_t row = 0; row + 1 < lattice.y.size(); ++row) {
    for (std::size_t column = 0; column + 1 < lattice.x.size(); ++column) marching.cross_cell(column, row);
  }
  return marching.lines();
}

}  // namespace loadpath::draw
