#include "lib/account/mode.hpp"

#include <algorithm>
#include <array>

namespace loadpath::account {

namespace {

/// Where it stands in a list: what needs a hand first.
int place(State state) {
  constexpr std::array order{State::fail, State::not_available, State::not_covered, State::not_judged,
                             State::pass, State::accepted,      State::open};
  return static_cast<int>(std::find(order.begin(), order.end(), state) - order.begin());
}

}  // namespace

State worst(const Modes& modes) {
  State state = State::pass;
  for (const Mode& mode : modes) state = worse(state, mode.state);
  return state;
}

State overall(const Modes& modes) {
  const State state = worst(modes);
  if (rank(state) > rank(State::open)) return state;
  const bool judged = std::any_of(modes.begin(), modes.end(), [](const Mode& m) { return m.state != State::open; });
  return judged ? State::pass : State::open;
}

Modes strictly(Modes modes) {
  for (Mode& mode : modes) {
    if (mode.state == State::open) mode.state = State::not_judged;
  }
  return modes;
}

Modes in_order(Modes modes) {
  std::stable_sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) {
    if (a.state != b.state) return place(a.state) < place(b.state);
    return a.utilisation.value_or(-1.0) > b.utilisation.value_or(-1.0);
  });
  return modes;
}

Message scope(const Modes& modes) {
  if (modes.empty()) return say("nothing is judged here");
  const Modes sorted = in_order(modes);
  Message all;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::find_if(first, sorted.end(), [&](const Mode& m) { return m.state != first->state; });
    std::string names;
    for (auto mode = first; mode != last; ++mode) {
      if (!is_remote(*mode)) names += (names.empty() ? "" : ", ") + mode->step + "." + mode->id;
    }
    const auto remote = std::count_if(first, last, is_remote);
    if (remote > 0) names += (names.empty() ? "" : ", ") + std::to_string(remote) + " judged by nothing here";
    const Message part = say("{1}: {2}", word(first->state), names);
    all = all.empty() ? part : say("{1}; {2}", all, part);
    first = last;
  }
  return all;
}

Message reason(const Mode& mode) {
  if (!mode.governs.empty())
    return mode.note.empty() ? say("{1}", mode.governs) : say("{1} {2}", mode.governs, mode.note);
  if (!mode.note.empty()) return mode.note;
  if (!mode.wants.empty()) return say("give {1}", mode.wants);
  if (!mode.judge.empty()) {
    return mode.state == State::open ? say("left to {1}", mode.judge)
                                     : say("left to {1}, and no step takes the whole part", mode.judge);
  }
  return say("nothing in loadpath judges it");
}

bool is_remote(const Mode& mode) {
  return mode.state == State::open && mode.wants.empty() && mode.judge.empty() && mode.note.empty();
}

}  // namespace loadpath::account
