#include "lib/account/mode.hpp"

#include "lib/account/fold.hpp"
#include "lib/numerics/magnitude.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace loadpath::account {

namespace {

bool is_outside(const Mode& mode) { return mode.state == State::not_judged && !mode.is_assessable; }

/// Whether two are reported together.
bool is_alike(const Mode& a, const Mode& b) { return a.state == b.state && is_outside(a) == is_outside(b); }

/// The place in a list: first the modes that need action, last those not considered.
int place(State state) {
  constexpr std::array order{State::fail,       State::not_available, State::not_covered,
                             State::not_judged, State::pass,          State::accepted};
  return static_cast<int>(std::find(order.begin(), order.end(), state) - order.begin());
}

using Part = Modes::const_iterator;

/// Modes of one state by their names; by their number where these are more than `most`.
Message names_of(Part first, Part last, std::ptrdiff_t most) {
  const auto remote = std::count_if(first, last, is_remote);
  if (last - first - remote > most) return say("{1} failure modes listed above", std::to_string(last - first));
  std::string names;
  for (auto mode = first; mode != last; ++mode) {
    if (!is_remote(*mode)) names += (names.empty() ? "" : ", ") + mode->step + "." + mode->id;
  }
  if (remote > 0) names += (names.empty() ? "" : ", ") + std::to_string(remote) + " more";
  return say("{1}", names);
}

/// State by state; `most`: how many of a state are named.
template <class Most>
Message listed(const Modes& modes, const Most& most) {
  if (modes.empty()) return say("no failure mode is assessed here");
  const Modes sorted = in_order(modes);
  Message all;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(), [&](const Mode& m) { return !is_alike(m, *first); });
    const Message part = say("{1}: {2}", shown(*first), names_of(first, last, most(first->state)));
    all = all.empty() ? part : say("{1}; {2}", all, part);
    first = last;
  }
  return all;
}

Folded folded(const Modes& modes) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Folded all;
  for (const Mode& mode : modes)
    all = all.with_mode(number(mode.state), mode.utilisation.value_or(none), number(State::open));
  return all;
}

}  // namespace

State worst(const Modes& modes) {
  const double state = folded(modes).worst;
  return state < 0.0 ? State::pass : state_of(state);
}

State overall(const Modes& modes) { return state_of(folded(modes).whole()); }

bool passes(const Modes& modes) { return rank(worst(modes)) <= rank(State::open); }

Modes strictly(Modes modes) {
  for (Mode& mode : modes) {
    if (mode.state == State::open) mode.state = State::not_judged;
  }
  return modes;
}

Modes in_order(Modes modes) {
  std::vector<Mode*> order;  // a mode is too large to be moved again and again
  for (Mode& mode : modes) order.push_back(&mode);
  std::stable_sort(order.begin(), order.end(), [](const Mode* a, const Mode* b) {
    if (a->state != b->state) return place(a->state) < place(b->state);
    if (is_outside(*a) != is_outside(*b)) return is_outside(*b);
    return numerics::exceeds(a->utilisation.value_or(-1.0), b->utilisation.value_or(-1.0));
  });
  Modes sorted;
  sorted.reserve(modes.size());
  for (Mode* const mode : order) sorted.push_back(std::move(*mode));
  return sorted;
}

Message shown(const Mode& mode) { return is_outside(mode) ? say("outside the scope") : shown(mode.state); }

Message scope(const Modes& modes) {
  return listed(modes, [](State) { return std::numeric_limits<std::ptrdiff_t>::max(); });
}

Message brief_scope(const Modes& modes) {
  constexpr std::ptrdiff_t most_passing = 8, most_open = 4, all = std::numeric_limits<std::ptrdiff_t>::max();
  return listed(modes, [](State state) {
    return state == State::pass ? most_passing : state == State::open ? most_open : all;
  });
}

Message reason(const Mode& mode) {
  if (!mode.governs.empty())
    return mode.note.empty() ? say("{1}", mode.governs) : say("{1} {2}", mode.governs, mode.note);
  if (!mode.note.empty()) return mode.note;
  if (!mode.wants.empty() && !mode.add.empty()) return say("give {1} (by a step of {2})", mode.wants, mode.add);
  if (!mode.wants.empty()) return say("give {1}", mode.wants);
  if (!mode.judge.empty()) return say("add a step of {1}", mode.judge);
  if (!mode.use.empty()) return say("replace with a step of {1}", mode.use);
  if (!mode.add.empty()) return say("add a step of {1}", mode.add);
  return say("no calculator assesses it");
}

bool is_remote(const Mode& mode) {
  return mode.state == State::open && mode.wants.empty() && mode.judge.empty() && mode.note.empty();
}

}  // namespace loadpath::account
