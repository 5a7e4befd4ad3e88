#include "calculators/fatigue/cycle.hpp"

#include "lib/calculator/calculator_of.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::fatigue {

namespace {

using Input = Cycle::Input;
using Result = Cycle::Result;

/// "others[2].", "others.test." or nothing for the first cycle.
std::string place_of(const Input& in, std::size_t i) {
  if (i == 0) return "";
  const Name& name = in.others[i - 1].name;
  return name.empty() ? "others[" + std::to_string(i) + "]." : "others." + std::string(name.view()) + ".";
}

/// The first cycle that breaks a condition: 0 is that of the step, then the others; past the last where none does.
template <class Breaks>
std::size_t first_that(const Input& in, const Breaks& breaks) {
  if (breaks(static_cast<const Given&>(in))) return 0;
  std::size_t i = 0;
  while (i < in.others.size() && !breaks(static_cast<const Given&>(in.others[i]))) ++i;
  return i + 1;
}

std::size_t miscounted(const Input& in) {
  return first_that(in, [](const Given& g) { return count(g) != 2; });
}

std::size_t objected(const Input& in) {
  return first_that(in, [](const Given& g) { return *objection(g).reason != '\0'; });
}

const Given& given(const Input& in, std::size_t i) { return i == 0 ? static_cast<const Given&>(in) : in.others[i - 1]; }

/// Proportional extremes, with one sense: r_1 = r_2 without a division.
bool are_similar(const Characteristics& a, const Characteristics& b) {
  const double a1 = in_si(a.sigma_max), a2 = in_si(a.sigma_min), b1 = in_si(b.sigma_max), b2 = in_si(b.sigma_min);
  const double size = std::hypot(a1, a2) * std::hypot(b1, b2);
  return std::abs(a1 * b2 - a2 * b1) <= same * size && a1 * b1 + a2 * b2 > 0.0;
}

std::string greek(const Input& in) { return in.stress == Stresses::shear ? "tau" : "sigma"; }

/// Two periods of a sine: what happens between the extremes does not matter.
figure::Figure over_time(const Input& in, const Result& r) {
  const std::string s = greek(in);
  figure::Plot plot;
  plot.x = {"t/T", "time over period", "-"};
  plot.y = {s, "stress", "MPa"};
  figure::Curve wave{s, {}, {}};
  for (int i = 0; i <= 96; ++i) {
    const double t = i / 48.0;
    wave.x.push_back(t);
    wave.y.push_back(in_si(r.sigma_m) + in_si(r.sigma_a) * std::sin(2.0 * pi * t));
  }
  plot.curves.push_back(std::move(wave));
  plot.bounds.push_back({in_si(r.sigma_max), s + "_max"});
  plot.bounds.push_back({in_si(r.sigma_min), s + "_min"});
  plot.bounds.push_back({in_si(r.sigma_m), s + "_m"});
  return {"cycle", "The cycle over time", std::move(plot)};
}

/// The cycle in the plane of amplitude over mean stress, where similar cycles lie on a ray.
figure::Figure in_the_plane(const Input& in, const Result& r) {
  const std::string s = greek(in);
  figure::Plot plot;
  plot.x = {s + "_m", "mean stress", "MPa"};
  plot.y = {s + "_a", "amplitude", "MPa"};
  double longest = 1.0;
  plot.marks.push_back({in_si(r.sigma_m), in_si(r.sigma_a), "cycle"});
  for (std::size_t i = 0; i < r.others.size(); ++i) {
    const auto& o = r.others[i];
    const Name& name = in.others[i].name;
    plot.marks.push_back(
        {in_si(o.sigma_m), in_si(o.sigma_a), name.empty() ? std::to_string(i + 1) : std::string(name.view())});
    if (o.similar == Cycle::Similar::yes) {
      const double own = std::hypot(in_si(r.sigma_m), in_si(r.sigma_a));
      longest = std::max(longest, std::hypot(in_si(o.sigma_m), in_si(o.sigma_a)) / own);
    }
  }
  const double reach = 1.2 * longest;
  plot.curves.push_back({"similar cycles", {0.0, reach * in_si(r.sigma_m)}, {0.0, reach * in_si(r.sigma_a)}});
  return {"amplitude-mean", "Amplitude and mean stress; cycles of one stress ratio on a ray", std::move(plot)};
}

/// The limit is that of symmetric cycles: tension lowers it, and so does shear of either sense.
template <class Tracer>
void hold_against_limit(const Input& in, Result& r, Tracer& trace) {
  STEP_TO(r, u_D, in.S_D * r.sigma_a / in.sigma_D,
          "required safety factor times amplitude, over the fatigue limit of fully reversed cycles");
  if (r.kind == Kind::constant) return;
  STEP_TO(r, x_m, max(in.stress == Stresses::shear ? abs(r.sigma_m) : r.sigma_m, 0.0 * MPa) / r.sigma_a,
          "mean stress that lowers the limit; compression does not");
}

}  // namespace

bool Cycle::two_given(const Input& in) { return miscounted(in) > in.others.size(); }

FieldFault Cycle::miscount(const Input& in) {
  const std::size_t i = miscounted(in);
  return wrong_count(given(in, i), place_of(in, i));
}

bool Cycle::sound(const Input& in) { return objected(in) > in.others.size(); }

FieldFault Cycle::objectionable(const Input& in) {
  const std::size_t i = objected(in);
  return unsound(given(in, i), place_of(in, i));
}

/// A static stress causes no fatigue: nothing is assessed by it.
Applies Cycle::varies(const Input& in) {
  NoTrace quiet;
  const bool known = two_given(in) && sound(in);
  return where(!known || cycle_of(in, quiet).kind != Kind::constant);
}

template <class Tracer>
Cycle::Result Cycle::evaluate(const Input& in, Tracer& trace) {
  Result r;
  static_cast<Characteristics&>(r) = cycle_of(in, trace);
  if (is_set(in.R_e)) {
    r.u_y = part_of_yield(in, r, trace);
    if (is_set(in.S_F)) {
      STEP_TO(r, u_F, in.S_F * r.u_y, "with the safety factor S_F");
    }
  }
  if (is_set(in.sigma_D)) hold_against_limit(in, r, trace);
  compare_cycles(in, r, trace);
  r.cycle = {in.stress, r.sigma_max, r.sigma_min};
  for (std::size_t i = 0; i < in.others.size(); ++i) {
    [[maybe_unused]] const auto here = trace.scope("others", i);
    Compared other;
    other.name = in.others[i].name;
    static_cast<Characteristics&>(other) = cycle_of(in.others[i], trace);
    other.similar = are_similar(r, other) ? Similar::yes : Similar::no;
    r.others.push_back(other);
  }
  return r;
}

template Cycle::Result Cycle::evaluate(const Input&, NoTrace&);
template Cycle::Result Cycle::evaluate(const Input&, Trace&);

std::vector<figure::Figure> Cycle::figures(const Input& in, const Result& r) {
  return {over_time(in, r), in_the_plane(in, r)};
}

}  // namespace loadpath::fatigue

template const loadpath::Calculator& loadpath::erased<loadpath::fatigue::Cycle>();
