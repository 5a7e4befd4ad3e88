#include "lib/sweep/search/mixed.hpp"

#include "lib/sweep/search/continuous.hpp"
#include "lib/sweep/search/enumeration.hpp"
#include "lib/sweep/search/neighbours.hpp"
#include "lib/sweep/search/spread.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::sweep {

namespace {

constexpr std::uint64_t few_combinations = 64;

bool before(const Trial& a, const Trial& b) { return better(a.standing, b.standing); }

std::vector<Trial> trials_at(std::vector<Places> places) {
  std::vector<Trial> all;
  all.reserve(places.size());
  for (Places& at : places) all.push_back({std::move(at), {}});
  return all;
}

/// The median size of the available objectives; 1 if it would be 0.
double usual_objective(const std::vector<Trial>& scan) {
  std::vector<double> sizes;
  for (const Trial& trial : scan) {
    if (trial.standing.objective != 0.0) sizes.push_back(std::abs(trial.standing.objective));
  }
  if (sizes.empty()) return 1.0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

/// The distance of two points in their continuous variables, as a share of the ranges; 1 if their stocks differ.
double distance(const std::vector<Variable>& variables, const Places& a, const Places& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (variables[i].is_discrete() && a[i] != b[i]) return 1.0;
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}

}  // namespace

MixedSearch::MixedSearch(Trials& at_work) : trials(at_work) {
  for (const Variable& variable : trials.problem().variables) continuous += variable.is_discrete() ? 0 : 1;
}

std::vector<Trial> MixedSearch::scan(std::uint64_t count, const Places* fixed) {
  const auto& variables = trials.problem().variables;
  const Spread spread(variables.size());
  std::vector<Trial> all(std::clamp<std::uint64_t>(count, 1, std::max<std::uint64_t>(trials.left(), 1)));
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].at = fixed != nullptr ? *fixed : Places(variables.size());
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const double share = spread(k, i);
      if (!variables[i].is_discrete()) all[k].at[i] = share;
      if (variables[i].is_discrete() && fixed == nullptr)
        all[k].at[i] = std::floor(share * static_cast<double>(variables[i].values.size()));
    }
  }
  trials.judge(all);
  std::stable_sort(all.begin(), all.end(), before);
  return all;
}

Trial MixedSearch::settled(const Trial& from) {
  Trial found = continuous > 0 ? descended(trials, from, scale, Care::thorough) : from;
  remember(found);
  return found;
}

std::vector<double> MixedSearch::stock_of(const Places& at) const {
  std::vector<double> places;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (trials.problem().variables[i].is_discrete()) places.push_back(at[i]);
  }
  return places;
}

void MixedSearch::remember(const Trial& trial) {
  const auto [known, is_new] = solved.try_emplace(stock_of(trial.at), trial);
  if (!is_new && before(trial, known->second)) known->second = trial;
}

std::vector<Trial> MixedSearch::apart(const std::vector<Trial>& points, std::size_t most) const {
  constexpr double far = 0.15;  // relative to the ranges
  std::vector<Trial> taken;
  for (const Trial& point : points) {
    if (taken.size() == most) break;
    const bool is_far = std::all_of(taken.begin(), taken.end(), [&](const Trial& other) {
      return distance(trials.problem().variables, point.at, other.at) > far;
    });
    if (is_far) taken.push_back(point);
  }
  return taken;
}

/// The best with this stock, from several points of the continuous variables.
void MixedSearch::spread_out(const Places& stock, Trial& best) {
  constexpr std::size_t starts = 3;
  for (const Trial& start : apart(scan(64 * continuous, &stock), starts)) {
    if (trials.left() == 0) return;
    const Trial found = settled(start);
    if (before(found, best)) best = found;
  }
}

void MixedSearch::each_combination(std::uint64_t count, Trial& best) {
  Places stock(best.at.size());
  for (std::uint64_t index = 0; index < count; ++index) {
    set_combination(trials.problem().variables, index, stock);
    spread_out(stock, best);
  }
  every = trials.left() > 0;
}

/// Other valleys of the continuous variables, with the stock of the best and of its neighbours.
bool MixedSearch::widen(Trial& best) {
  const PointRank before_it = best.standing;
  auto stocks = neighbours_of(trials.problem().variables, best.at, 1);
  stocks.insert(stocks.begin(), best.at);
  for (const Places& stock : stocks) spread_out(stock, best);
  return better(best.standing, before_it);
}

Trial MixedSearch::from_scan(std::size_t starts) {
  const auto points = scan(std::min<std::uint64_t>(256 * trials.problem().variables.size(), 8192), nullptr);
  scale = usual_objective(points);
  Trial best = points.front();
  for (const Trial& start : apart(points, starts)) {
    if (trials.left() == 0) break;
    const Trial found = climb(settled(start));
    if (before(found, best)) best = found;
  }
  return best;
}

Trial MixedSearch::run(std::size_t starts) {
  Trial best = from_scan(starts);
  if (continuous == 0) return best;
  const std::uint64_t count = combinations(trials.problem().variables, few_combinations);
  if (count > 1 && count <= few_combinations) {
    each_combination(count, best);
  } else if (count > 1) {
    while (trials.left() > 0 && widen(best)) best = climb(best);
  }
  return settled(best);
}

Trial MixedSearch::climb(Trial from) {
  while (trials.left() > 0 && step(from)) {
  }
  return from;
}

bool MixedSearch::step(Trial& current) {
  const auto& variables = trials.problem().variables;
  return step_to(current, trials_at(neighbours_of(variables, current.at, 2))) ||
         step_to(current, trials_at(across(variables, current.at)));
}

/// Moves to a better neighbour, trying the most promising first. Solved points are not solved again.
bool MixedSearch::step_to(Trial& current, std::vector<Trial> around) {
  std::vector<Trial> known;
  std::erase_if(around, [&](const Trial& trial) {
    const auto found = solved.find(stock_of(trial.at));
    if (found != solved.end()) known.push_back(found->second);
    return found != solved.end();
  });
  trials.judge(around);
  std::stable_sort(around.begin(), around.end(), before);
  const auto best_known = std::min_element(known.begin(), known.end(), before);
  if (best_known != known.end() && before(*best_known, current)) {
    current = *best_known;
    return true;
  }
  for (const Trial& trial : around) {
    if (trials.left() == 0) return false;
    const Trial found = continuous > 0 ? descended(trials, trial, scale, Care::quick) : trial;
    remember(found);
    if (before(found, current)) {
      current = found;
      return true;
    }
  }
  return false;
}

}  // namespace loadpath::sweep
