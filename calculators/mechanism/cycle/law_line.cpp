#include "calculators/mechanism/cycle/law_line.hpp"

#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "lib/mechanism/model/profile.hpp"
#include "lib/mechanism/model/whole_turn.hpp"
#include "lib/quantity/expression/resolved.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace loadpath::planar {

namespace {

constexpr double negligible = 0.02;    // share of the largest magnitude that positions may miss
constexpr double near_enough = 0.005;  // distance of a formula and its line with corners
constexpr double jump_width = 1e-7;    // width of a jump, rad or parts of a range

using Corners = std::vector<std::pair<double, double>>;

/// Jumps become steep: the values on both sides lie next to each other.
void part_jumps(Corners& corners, double apart) {
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    if (corners[k + 1].first > corners[k].first) continue;
    corners[k].first -= apart;
    corners[k + 1].first += apart;
  }
  std::stable_sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

LawLine finished(LawLine watched) {
  for (const auto& [x, y] : watched.corners) {
    if (std::isfinite(y)) watched.most = std::max(watched.most, std::abs(y));
  }
  std::erase_if(watched.corners, [](const auto& corner) { return !std::isfinite(corner.second); });
  return watched;
}

double on_line(const std::pair<double, double>& a, const std::pair<double, double>& b, double x) {
  const double width = b.first - a.first;
  return width > 0.0 ? a.second + (b.second - a.second) * (x - a.first) / width : b.second;
}

LawLine watched_drive(const DriveLaw& law, std::string name, const std::vector<double>& knots) {
  LawLine watched{.name = std::move(name), .by = LawLine::By::law_time};
  if (law.formula() != nullptr) {
    Resolved resolved = resolve(*law.formula(), law.first(), law.last(), near_enough, Followed::second);
    watched.corners = std::move(resolved.corners);
    watched.complete = resolved.complete;
    return finished(std::move(watched));
  }
  const double apart = jump_width * (law.last() - law.first());
  for (const double t : knots) {
    for (const double at : {t - apart, t + apart}) {
      if (at >= law.first() && at <= law.last()) watched.corners.emplace_back(at, law.at(at).second);
    }
  }
  return finished(std::move(watched));
}

template <class Drive>
std::vector<double> knots_of(const Drive& drive) {
  std::vector<double> knots;
  for (const auto& moment : drive.law) knots.push_back(in_si(moment.t));
  return knots;
}

}  // namespace

double LawLine::at(double x) const {
  if (corners.empty()) return 0.0;
  if (period > 0.0) x -= period * std::floor((x - corners.front().first) / period);
  const auto next = std::upper_bound(corners.begin(), corners.end(), x,
                                     [](double place, const auto& corner) { return place < corner.first; });
  if (next == corners.begin()) return corners.front().second;
  if (next != corners.end()) return on_line(*(next - 1), *next, x);
  if (period == 0.0) return corners.back().second;
  return on_line(corners.back(), {corners.front().first + period, corners.front().second}, x);
}

std::optional<LawLine::Miss> LawLine::worst_between(double x_0, double x_1, double beyond) const {
  if (x_1 < x_0) std::swap(x_0, x_1);
  const double y_0 = at(x_0), y_1 = at(x_1), low = x_0 - beyond, high = x_1 + beyond;
  Miss worst;
  const auto look = [&](double x, double y) {
    if (!(x > low && x < high)) return;
    double missed = std::max(y - std::max(y_0, y_1), std::min(y_0, y_1) - y);
    if (has_corners && x > x_0 && x < x_1) missed = std::max(missed, std::abs(y - on_line({x_0, y_0}, {x_1, y_1}, x)));
    if (missed > worst.by) worst = {x, missed};
  };
  const auto first_turn = period > 0.0 ? std::floor((low - corners.front().first) / period) : 0.0;
  const auto last_turn = period > 0.0 ? std::floor((high - corners.front().first) / period) : 0.0;
  for (double turn = first_turn; !corners.empty() && turn <= last_turn; turn += 1.0) {
    const double shift = turn * period;
    auto corner = std::lower_bound(corners.begin(), corners.end(), low - shift,
                                   [](const auto& c, double place) { return c.first < place; });
    for (; corner != corners.end() && corner->first + shift < high; ++corner)
      look(corner->first + shift, corner->second);
  }
  if (!(worst.by > negligible * most)) return std::nullopt;
  worst.by /= most;
  return worst;
}

LawLine watched_shares(const planar::Load& load, double period) {
  LawLine watched{.name = load.name.empty() ? "a load" : "the load '" + std::string(load.name.view()) + "'"};
  for (const auto& share : load.over) watched.corners.emplace_back(share.angle, share.share);
  part_jumps(watched.corners, jump_width);
  watched.period = period;
  watched.has_corners = true;
  return finished(std::move(watched));
}

LawLine watched_course(const Mechanism::Input& in, std::size_t course, const CourseNow& now, const Reach& reach) {
  using By = CourseNow::By;
  LawLine watched{.name = "the course '" + std::string(in.courses[course].name.view()) + "'", .index = course};
  watched.by = now.by() == By::crank_angle ? LawLine::By::crank_angle
               : now.by() == By::time      ? LawLine::By::time
                                           : LawLine::By::stroke;
  if (now.formula() == nullptr) {
    watched.corners = now.points();
    watched.has_corners = true;
    return finished(std::move(watched));
  }
  if (reach.high > reach.low) {
    Resolved resolved = resolve(*now.formula(), reach.low, reach.high, near_enough);
    watched.corners = std::move(resolved.corners);
    watched.complete = resolved.complete;
  }
  return finished(std::move(watched));
}

std::vector<LawLine> watched_drives(const Mechanism::Input& in) {
  std::vector<LawLine> all;
  const DriveLaw crank(in.crank);
  if (!crank.empty()) all.push_back(watched_drive(crank, "the law of the crank", knots_of(in.crank)));
  for (const planar::Cylinder& cylinder : in.cylinders) {
    const DriveLaw law(cylinder);
    if (law.empty()) continue;
    all.push_back(watched_drive(law, "the law of '" + std::string(cylinder.name.view()) + "'", knots_of(cylinder)));
  }
  return all;
}

std::optional<LawLine> watched_cam(const mechanism::Joint& joint, std::size_t index,
                                   const std::vector<double>& ends_of_segments) {
  constexpr int parts = 64;  // of a segment: its laws are few, and no wave of their accelerations is hidden then
  const mechanism::Lift* lift = nullptr;
  double sense = 1.0;
  std::visit(
      [&](const auto& curve) {
        if constexpr (requires { curve.lift; }) {
          lift = &curve.lift;
          sense = curve.sense == mechanism::CamSense::clockwise ? 1.0 : -1.0;
        }
      },
      joint.profile->curve());
  if (lift == nullptr || ends_of_segments.empty()) return std::nullopt;
  LawLine watched{.name = "the lift of '" + joint.name + "'", .by = LawLine::By::cam, .index = index};
  double from = 0.0;
  for (const double to : ends_of_segments) {
    for (int i = 0; i <= parts; ++i) {
      const double share = i == 0 ? jump_width : i == parts ? 1.0 - jump_width : static_cast<double>(i) / parts;
      const double angle = from + (to - from) * share;
      watched.corners.emplace_back(sense * angle, lift->at(angle).second);
    }
    from = to;
  }
  std::sort(watched.corners.begin(), watched.corners.end());
  watched.period = whole_turn;
  return finished(std::move(watched));
}

}  // namespace loadpath::planar
