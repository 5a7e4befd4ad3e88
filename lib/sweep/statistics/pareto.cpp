#include "lib/sweep/statistics/pareto.hpp"

#include "lib/sweep/statistics/lanes.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace loadpath::sweep {

namespace {

/// An integer in the order of the doubles, the best first.
std::uint64_t rank_of(double objective, Aim aim) {
  const double x = (aim == Aim::min ? objective : -objective) + 0.0;  // there is one zero
  const auto bits = std::bit_cast<std::uint64_t>(x);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// Whether a is as good as b in each; of two that are not the same.
bool beats(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), std::less_equal<>{});
}

}  // namespace

Pareto::Pareto(std::vector<Aim> aims, unsigned bits)
    : aims_(std::move(aims)), dropped_(52 - std::min(bits, 52U)), objectives_(aims_.size()), keys_(aims_.size()) {}

// Members are in the order of their keys, so only earlier ones may dominate the point. With two objectives the second
// decreases from one to the next: the preceding one decides.
bool Pareto::stays() {
  if (!std::all_of(objectives_.begin(), objectives_.end(), is_finite)) return false;
  for (std::size_t k = 0; k < aims_.size(); ++k) keys_[k] = rank_of(objectives_[k], aims_[k]) >> dropped_;
  if (!beats_.empty() && beats_ != keys_ && beats(beats_, keys_)) return false;
  const auto end = members_.lower_bound(keys_);
  const bool all = aims_.size() > 2;
  for (auto it = all || end == members_.begin() ? members_.begin() : std::prev(end); it != end; ++it) {
    if (!beats(it->first, keys_)) continue;
    beats_ = it->first;
    return false;
  }
  return true;
}

bool Pareto::is_better(std::uint64_t index, const Point& than) const {
  for (std::size_t k = 0; k < aims_.size(); ++k) {
    const std::uint64_t own = rank_of(objectives_[k], aims_[k]), other = rank_of(than.objectives[k], aims_[k]);
    if (own != other) return own < other;
  }
  return index < than.index;
}

Pareto::Point* Pareto::place(std::uint64_t index, std::uint64_t equals) {
  const auto [place, is_new] = members_.try_emplace(keys_);
  for (auto it = std::next(place); is_new && it != members_.end();) {
    if (beats(keys_, it->first))
      it = members_.erase(it);
    else if (aims_.size() > 2)
      ++it;
    else
      break;
  }
  Point& kept = place->second;
  kept.equals += equals;
  if (!is_new && !is_better(index, kept)) return nullptr;
  kept.index = index;
  kept.objectives = objectives_;
  return &kept;
}

void Pareto::merge(const Pareto& other) {
  for (const auto& [keys, point] : other.members_) {
    objectives_ = point.objectives;
    if (!stays()) continue;
    if (Point* const taken = place(point.index, point.equals)) taken->values = point.values;
  }
}

std::vector<Pareto::Point> Pareto::points() const {
  std::vector<Point> found;
  for (const auto& [keys, point] : members_) found.push_back(point);
  return found;
}

void Pareto::store(Writer& writer) const {
  writer.put(std::uint64_t{aims_.size()});
  for (const Aim aim : aims_) writer.put(static_cast<std::uint64_t>(aim));
  writer.put(std::uint64_t{dropped_});
  writer.put(std::uint64_t{members_.size()});
  for (const auto& [keys, point] : members_) {
    writer.put(point.index);
    writer.put(point.equals);
    for (const double objective : point.objectives) writer.put(objective);
    writer.put(std::uint64_t{point.values.size()});
    for (const double value : point.values) writer.put(value);
  }
}

void Pareto::load(Reader& reader) {
  std::vector<Aim> aims(reader.count(1));
  for (Aim& aim : aims) aim = reader.number() == 0 ? Aim::min : Aim::max;
  *this = Pareto(std::move(aims), 52 - static_cast<unsigned>(std::min<std::uint64_t>(reader.number(), 52)));
  for (std::uint64_t left = reader.count(3 + aims_.size()); left > 0 && !reader.failed(); --left) {
    const std::uint64_t index = reader.number(), equals = reader.number();
    for (double& objective : objectives_) objective = reader.real();
    std::vector<double> values(reader.count(1));
    for (double& value : values) value = reader.real();
    if (!stays())
      reader.fail();
    else if (Point* const taken = place(index, equals))
      taken->values = std::move(values);
  }
}

}  // namespace loadpath::sweep
