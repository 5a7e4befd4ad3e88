#include "calculators/mechanism/cycle/equilibria.hpp"

#include "calculators/mechanism/cycle/either_way.hpp"
#include "calculators/mechanism/input/law.hpp"
#include "calculators/mechanism/input/names.hpp"
#include "lib/mechanism/model/spring.hpp"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace loadpath::planar {

namespace {

using mechanism::Status;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double nothing = 1e-9;  // fraction of the largest effort that counts as zero
constexpr double nearby = 1e-3;   // distance of the neighbouring places that show the slope, fraction of a step
constexpr double same = 1e-7;     // places closer than this are one position
constexpr int finest = 52;        // precision of a place, bits

struct Sample {
  double place = 0.0, coordinate = 0.0, effort = unknown;
  [[nodiscard]] bool is_known() const { return !std::isnan(effort); }
};

/// The effort that holds the mechanism at rest at any place, followed from the place asked for before.
class Holding {
 public:
  Holding(const Mechanism::Input& in, const mechanism::Model& model, bool redundant, const Assembled& assembled)
      : in_(in),
        model_(model),
        redundant_(redundant),
        assembled_(assembled),
        courses_(in),
        system_(model, redundant),
        position_(mechanism::blank_position(model)) {
    stands_ = system_.assemble() == Status::closed;
  }

  Sample at(double place) {
    const Schedule schedule = schedule_of(in_, assembled_, {place});
    const auto& drives = schedule.drives.front();
    Sample here{place, schedule.at.front(), unknown};
    if (!stands_) return here;
    const CycleTask task{in_, model_, redundant_, schedule, true, courses_};
    set_loads(task, system_, drives, 0, position_);
    const Status status = system_.solve(drives, position_, true);
    const bool directed = !mechanism::some_spring_has_no_direction(model_, position_);
    if (status == Status::closed && directed && std::isfinite(position_.effort[0])) here.effort = position_.effort[0];
    closes_ = status == Status::closed || status == Status::jams || status == Status::singular;
    return here;
  }

  /// Whether the mechanism could be followed to the last place.
  [[nodiscard]] bool closes() const { return closes_; }

 private:
  const Mechanism::Input& in_;
  const mechanism::Model& model_;
  bool redundant_;
  const Assembled& assembled_;
  LoadCourses courses_;
  mechanism::ReleasedSystem system_;
  mechanism::Position position_;
  bool stands_ = false, closes_ = true;
};

class Search {
 public:
  Search(const Mechanism::Input& in, const mechanism::Model& model, bool redundant, const Assembled& assembled)
      : in_(in), model_(model), redundant_(redundant), assembled_(assembled) {}

  /// Places of a full revolution end with that of the first position.
  Equilibria run(const std::vector<double>& places, bool whole_turn) {
    turn_ = whole_turn ? places.back() - places.front() : 0.0;
    std::vector<Sample> ahead = followed(places);
    if (ahead.empty()) return {};
    // What lies beyond a gap is reached backward: from the last place, of a revolution from the first.
    std::vector<Sample> behind;
    if (ahead.size() < places.size()) {
      std::vector<double> back(places.rbegin(), places.rend() - static_cast<std::ptrdiff_t>(ahead.size()));
      for (double& place : back) place -= turn_;
      behind = followed(back);
    }
    for (const auto* const samples : {&ahead, &behind}) {
      for (const Sample& sample : *samples)
        if (sample.is_known()) most_ = std::max(most_, std::abs(sample.effort));
    }
    look_through(ahead);
    look_through(behind);
    finish({ahead, behind});
    return std::move(all_);
  }

 private:
  /// Up to the first place that the mechanism does not reach.
  std::vector<Sample> followed(const std::vector<double>& places) {
    Holding holding = start();
    std::vector<Sample> samples;
    for (const double place : places) {
      const Sample sample = holding.at(place);
      if (!holding.closes()) break;
      samples.push_back(sample);
    }
    return samples;
  }

  [[nodiscard]] Holding start() const { return {in_, model_, redundant_, assembled_}; }
  [[nodiscard]] bool is_none(const Sample& sample) const { return std::abs(sample.effort) <= nothing * most_; }

  void look_through(const std::vector<Sample>& samples) {
    Holding holding = start();
    for (std::size_t k = 0; k < samples.size(); ++k) {
      (void)holding.at(samples[k].place);
      if (!samples[k].is_known()) continue;
      if (is_none(samples[k])) {
        const bool inside = k > 0 && k + 1 < samples.size() && is_none(samples[k - 1]) && is_none(samples[k + 1]);
        if (!inside) keep(samples[k].place);  // of a stretch without effort the ends
      } else if (k > 0 && samples[k - 1].is_known() && !is_none(samples[k - 1])) {
        if (samples[k - 1].effort * samples[k].effort < 0.0) keep_root(holding, samples[k - 1], samples[k]);
      }
      if (k > 1) look_for_a_touch(holding, samples[k - 2], samples[k - 1], samples[k]);
      (void)holding.at(samples[k].place);
    }
  }

  /// Between a place with an effort forward and one backward; none where the effort jumps or grows without bound.
  void keep_root(Holding& holding, const Sample& one, const Sample& other) {
    const bool ascends = one.place < other.place;  // behind a gap the places fall
    const Sample &left = ascends ? one : other, &right = ascends ? other : one;
    const auto effort = [&](double place) { return holding.at(place).effort; };
    std::uintmax_t most = 200;
    const auto fine = boost::math::tools::eps_tolerance<double>(finest);
    const auto [low, high] =
        boost::math::tools::toms748_solve(effort, left.place, right.place, left.effort, right.effort, fine, most);
    const double place = std::abs(effort(low)) < std::abs(effort(high)) ? low : high;
    if (std::abs(effort(place)) <= 1e-6 * most_) keep(place);
  }

  /// Efforts of one sign may vanish between the places, twice or just once.
  void look_for_a_touch(Holding& holding, const Sample& a, const Sample& b, const Sample& c) {
    const bool known = a.is_known() && b.is_known() && c.is_known();
    if (!known || is_none(a) || is_none(b) || is_none(c) || a.effort * b.effort < 0.0 || b.effort * c.effort < 0.0)
      return;
    if (std::abs(b.effort) > std::abs(a.effort) || std::abs(b.effort) > std::abs(c.effort)) return;
    const double sign = b.effort > 0.0 ? 1.0 : -1.0;
    (void)holding.at(b.place);
    const auto effort = [&](double place) {
      const double here = sign * holding.at(place).effort;
      return std::isnan(here) ? std::numeric_limits<double>::infinity() : here;
    };
    const auto [low, high] = std::minmax(a.place, c.place);
    std::uintmax_t most = 100;
    const auto [place, least] = boost::math::tools::brent_find_minima(effort, low, high, finest / 2, most);
    const Sample bottom{place, 0.0, sign * least};
    if (is_none(bottom)) {
      keep(place);
    } else if (least < 0.0) {
      keep_root(holding, a, bottom);
      keep_root(holding, bottom, c);
    }
  }

  void keep(double place) { all_.found.push_back({place, 0.0, Stability::neutral}); }

  /// Sorts what is found, each once, and judges its stability.
  void finish(const std::vector<std::vector<Sample>>& samples) {
    for (const auto& part : samples) {
      for (const Sample& s : part) {
        if (!s.is_known() || std::abs(s.effort) >= std::abs(all_.least)) continue;
        all_.least = s.effort, all_.least_at = s.coordinate;
      }
    }
    all_.everywhere = most_ == 0.0;
    if (all_.everywhere) return all_.found.clear();
    for (Equilibrium& e : all_.found) judge(e);
    if (turn_ != 0.0) {
      for (Equilibrium& e : all_.found) e.place -= turn_ * std::floor(e.place / turn_ + same / turn_);
    }
    std::sort(all_.found.begin(), all_.found.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
    const auto is_one = [](const Equilibrium& a, const Equilibrium& b) { return b.place - a.place <= same; };
    all_.found.erase(std::unique(all_.found.begin(), all_.found.end(), is_one), all_.found.end());
  }

  /// From the efforts at neighbouring places; at the end of the range, on one side only.
  void judge(Equilibrium& e) {
    Holding holding = start();
    const Sample middle = holding.at(e.place);
    Sample left = middle, right = middle;
    int rising = 0, falling = 0;  // sides on which the effort rises, or falls, with the coordinate
    for (Sample* const side : {&left, &right}) {
      const Sample there = holding.at(e.place + (side == &left ? -nearby : nearby));
      (void)holding.at(e.place);
      if (!there.is_known() || there.coordinate == middle.coordinate) continue;
      *side = there;
      if (is_none(there)) continue;
      const bool rises = (there.effort > 0.0) == (there.coordinate > middle.coordinate);
      (rises ? rising : falling) += 1;
    }
    if (left.coordinate == right.coordinate) return;
    e.stiffness = (right.effort - left.effort) / (right.coordinate - left.coordinate);
    e.stability = rising > 0 && falling > 0 ? Stability::one_sided
                  : rising > 0              ? Stability::stable
                  : falling > 0             ? Stability::unstable
                                            : Stability::neutral;
  }

  const Mechanism::Input& in_;
  const mechanism::Model& model_;
  bool redundant_;
  const Assembled& assembled_;
  double turn_ = 0.0;  // places of a revolution; 0: none
  double most_ = 0.0;  // largest effort
  Equilibria all_;
};

/// With further places between those that were asked for: two angles may be the ends of a range.
std::vector<double> densely(const std::vector<double>& places) {
  constexpr std::size_t least = 180;
  const std::size_t parts = places.size() < 2 ? 1 : (least + places.size() - 2) / (places.size() - 1);
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    for (std::size_t n = 0; n < parts; ++n) {
      const double share = static_cast<double>(n) / static_cast<double>(parts);
      all.push_back(places[k] + share * (places[k + 1] - places[k]));
    }
  }
  if (!places.empty()) all.push_back(places.back());
  return all;
}

FieldFault not_covered(std::string path, Message message, Message hint) {
  return {std::move(path), std::move(message), std::move(hint)};
}

template <class Drive>
bool moves(const Drive& drive) {
  return in_si(drive.speed) != 0.0 || in_si(drive.acceleration) != 0.0;
}

}  // namespace

Equilibria equilibria_of(const Mechanism::Input& in, const mechanism::Model& model, bool redundant,
                         const std::vector<double>& places, const Assembled& assembled) {
  std::vector<double> all = places;
  const bool whole_turn = has_crank(in) && in.crank.at.empty();
  if (whole_turn) all.push_back(static_cast<double>(positions_of(in)));
  return Search(in, model, redundant, assembled).run(densely(all), whole_turn);
}

std::vector<FieldFault> check_equilibrium(const Mechanism::Input& in, const mechanism::Model& model) {
  if (!stays_in_equilibrium(in)) return {};
  std::vector<FieldFault> faults;
  if (model.drivers.size() != 1)
    faults.push_back(not_covered("analysis", say("positions of equilibrium are sought along the motion of one drive"),
                                 say("name the joint that drives the mechanism as a crank, or one cylinder with "
                                     "'from' and 'to'; the other cylinders get a given force F")));
  if (has_law(in))
    faults.push_back(not_covered("analysis", say("a law of motion does not apply at rest"),
                                 say("give the crank its joint only, or angles at = [...] to search between them")));
  if (moves(in.crank))
    faults.push_back(not_covered("crank.speed", say("in equilibrium the crank is at rest"), say("leave it out")));
  for (const planar::Cylinder& cylinder : in.cylinders) {
    if (moves(cylinder))
      faults.push_back(not_covered(path_of("cylinders", cylinder.name, "speed"),
                                   say("in equilibrium the cylinder is at rest"), say("leave it out")));
  }
  if (has_dry_friction(model))
    faults.push_back(not_covered("analysis", say("with friction the mechanism stays at rest over a range of positions"),
                                 say("leave the friction out; analysis = \"static\" gives the range, at rest without "
                                     "its drive")));
  if (positions_of(in) < 2)
    faults.push_back(not_covered("analysis", say("positions of equilibrium are sought between several positions"),
                                 say("leave out crank.at for a full revolution, or give angles to search between; "
                                     "with a cylinder give 'to' and 'positions'")));
  return faults;
}

}  // namespace loadpath::planar
