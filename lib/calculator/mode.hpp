// The failure modes of a part. A calculator declares them next to its fields; a verdict is about them, not about the
// checks that happened to be computed: a mode that applies and was not assessed does not pass.
#pragma once

#include <array>
#include <cstddef>

namespace loadpath {

/// Whether a mode concerns a part; unseen: the input does not decide it.
enum class Applies : unsigned char { no, unseen, yes };

/// The kind of a mode, which determines its state if it is not assessed.
enum class ModeKind {
  strength,  // worse with load
  service,   // twist, sag: a bound that only the user can set; open until it is given
  shape,     // interference, undercut, room
  special    // critical only in special service: wear, creep; open until an input shows that service
};

/// Data of a mode that do not depend on the type of its input.
struct ModeInfo {
  const char* id = "";     // "root_1": the key of `accept`, and of JSON
  const char* title = "";  // "tooth root of gear 1 in bending"
  ModeKind kind = ModeKind::strength;
  const char* checks = "";   // the checks and limits that assess it, all of them: "u_F1, v_share", "segments.u_tau"
  const char* judge = "";    // the calculator that assesses it, or the rest of its checks; without both nothing does
  const char* taken = "";    // how that assesses it: modes of it, by the record that it takes, "sun_mesh.root_1"
  const char* counter = "";  // a calculator that assesses it too, by its mode of the same name, in steps that count
  const char* counted = "";  // one of these results of the part over a cycle: "sigma_o, sigma_u"
  const char* wants = "";    // inputs needed to assess it, if its checks do not show them
  const char* request = "";  // request for the inputs of its checks, if a list of them does not suffice
  const char* advice = "";   // other remedy if no input is missing
  const char* use = "";      // the calculator that assesses it when it takes the place of this one: "shaft.design"
  const char* add = "";      // calculators of which an additional step assesses it: "shaft.key, shaft.spline"
  const char* each = "";     // the list of the part whose every element an additional step assesses: "stages"
  const char* loads = "";    // the list of results with the loads before and behind each element: "shafts"
  bool is_limit =
      false;  // the same at any load, as a slenderness: it governs where it fails, or where nothing else does
  bool by_record = false;                // without the record that `judge` takes, no calculator assesses it
  bool by_service = false;               // unseen, it applies if the source of the load rotates or the load varies
  bool is_fixed = false;                 // whether it applies does not depend on the input
  bool is_independent_of_loads = false;  // nor on loads: on sizes, factors and choices alone
  bool by_rest = false;                  // unseen, it applies where a load has companions that the step does not take
};

/// Whether anything in the catalogue assesses the mode: this calculator, or another one.
constexpr bool is_assessable(const ModeInfo& mode) {
  return *mode.checks != '\0' || *mode.judge != '\0' || *mode.wants != '\0' || *mode.advice != '\0' ||
         *mode.use != '\0' || *mode.add != '\0';
}

/// Predicates that many modes have.
template <class Input>
constexpr Applies always(const Input&) {
  return Applies::yes;
}
template <class Input>
constexpr Applies unseen(const Input&) {
  return Applies::unseen;
}
/// Yes where it holds, else not at all.
constexpr Applies where(bool holds) { return holds ? Applies::yes : Applies::no; }
/// Yes if an input shows it, else undecided by the input.
constexpr Applies shown_by(bool holds) { return holds ? Applies::yes : Applies::unseen; }

/// A mode of a calculator with this input. `applies` is called with table values set, at every position of a series.
template <class Input>
struct Mode : ModeInfo {
  Applies (*applies)(const Input&);

  constexpr Mode(const char* i, const char* t, Applies (*when)(const Input&))
      : ModeInfo{.id = i, .title = t, .is_fixed = when == &unseen<Input> || when == &always<Input>}, applies(when) {}

  [[nodiscard]] constexpr Mode judged_by(const char* all) const {
    Mode mode = *this;
    mode.checks = all;
    return mode;
  }
  /// Assessed by steps of another calculator that take records of this part: all of `modes`, each after the record,
  /// "sun_mesh.root_2, ring_mesh.root_1". If checks of its own assess it too, the rest is left to these.
  [[nodiscard]] constexpr Mode left_to(const char* calculator, const char* modes) const {
    Mode mode = *this;
    mode.judge = calculator;
    mode.taken = modes;
    return mode;
  }
  /// After left_to: a part that hands over no such record, as a ring gear no mesh, is outside the scope.
  [[nodiscard]] constexpr Mode where_handed_over() const {
    Mode mode = *this;
    mode.by_record = true;
    return mode;
  }
  /// After left_to: also assessed by steps of a calculator that take one of these series, none of the others being
  /// larger.
  [[nodiscard]] constexpr Mode or_counted_by(const char* calculator, const char* series) const {
    Mode mode = *this;
    mode.counter = calculator;
    mode.counted = series;
    return mode;
  }
  /// The inputs to be given so that it is assessed: "sigma_adm_1".
  [[nodiscard]] constexpr Mode wanting(const char* inputs) const {
    Mode mode = *this;
    mode.wants = inputs;
    return mode;
  }
  /// The request for inputs if no check is active, in words: "give tau_adm, or S with R_e".
  [[nodiscard]] constexpr Mode asking(const char* text) const {
    Mode mode = *this;
    mode.request = text;
    return mode;
  }
  /// The remedy if all inputs are given and it is not assessed: "give the hub its length".
  [[nodiscard]] constexpr Mode advising(const char* text) const {
    Mode mode = *this;
    mode.advice = text;
    return mode;
  }
  /// Assessed by another calculator instead of this one.
  [[nodiscard]] constexpr Mode assessed_in(const char* calculator) const {
    Mode mode = *this;
    mode.use = calculator;
    return mode;
  }
  /// Assessed by an additional step of one of these calculators.
  [[nodiscard]] constexpr Mode assessed_additionally_in(const char* calculators) const {
    Mode mode = *this;
    mode.add = calculators;
    return mode;
  }
  /// After assessed_additionally_in: assessed where each element of this list has such a step, which takes a size of
  /// the element and its load, from the elements of `results` before and behind it.
  [[nodiscard]] constexpr Mode for_each_of(const char* list, const char* results) const {
    Mode mode = *this;
    mode.each = list;
    mode.loads = results;
    return mode;
  }
  /// Applies to a part that rotates, or whose load varies.
  [[nodiscard]] constexpr Mode in_service() const {
    Mode mode = *this;
    mode.by_service = true;
    return mode;
  }
  /// Caused by further components of the load that is taken: bending, with the torque of a gear.
  [[nodiscard]] constexpr Mode by_companions() const {
    Mode mode = *this;
    mode.by_rest = true;
    return mode;
  }
  /// Of a ratio that the load does not change, against a limit: shown as governing where it fails, or is the only one.
  [[nodiscard]] constexpr Mode at_any_load() const {
    Mode mode = *this;
    mode.is_limit = true;
    return mode;
  }
  /// Whether it applies depends on no input that is a load: on sizes, factors and choices alone.
  [[nodiscard]] constexpr Mode independent_of_loads() const {
    Mode mode = *this;
    mode.is_independent_of_loads = true;
    return mode;
  }
  [[nodiscard]] constexpr Mode of_service() const { return of(ModeKind::service); }
  [[nodiscard]] constexpr Mode of_shape() const { return of(ModeKind::shape); }
  [[nodiscard]] constexpr Mode special() const { return of(ModeKind::special); }

 private:
  [[nodiscard]] constexpr Mode of(ModeKind k) const {
    Mode mode = *this;
    mode.kind = k;
    return mode;
  }
};

/// The modes of a calculator class without the type of its input.
template <class C>
inline constexpr auto mode_infos = [] {
  std::array<ModeInfo, C::modes.size()> infos{};
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = C::modes[i];
  return infos;
}();
template <class C>
Applies applies_of(std::size_t mode, const void* input) {
  return C::modes[mode].applies(*static_cast<const typename C::Input*>(input));
}

}  // namespace loadpath
