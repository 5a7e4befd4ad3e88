#include "calculators/drive/train.hpp"

#include "calculators/gear/planetary.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <algorithm>

namespace loadpath::drive {

namespace {

using Stage = Train::Stage;
using StageKind = Train::StageKind;
using Member = Train::Member;

bool has_teeth(const Stage& s) { return s.z_1 > 0 && s.z_2 > 0; }
bool has_diameters(const Stage& s) { return is_set(s.d_1) && is_set(s.d_2); }
bool has_planets(const Stage& s) { return s.z_s > 0 && s.z_r > 0; }

bool is_known(const Stage& s) {
  return s.kind == StageKind::planetary ? has_planets(s) : is_set(s.i) || has_teeth(s) || has_diameters(s);
}

/// The ratio is said in no more than one way; what belongs to another kind of stage is not there.
bool is_single(const Stage& s) {
  const bool planets = s.z_s > 0 || s.z_r > 0, teeth = s.z_1 > 0 || s.z_2 > 0, sizes = is_set(s.d_1) || is_set(s.d_2);
  if (s.kind == StageKind::planetary) return !teeth && !sizes && !is_set(s.i);
  return !planets && static_cast<int>(is_set(s.i)) + teeth + (sizes && !has_teeth(s)) <= 1;
}

bool slip_fits(const Stage& s) {
  return s.slip == 0.0 || (s.kind == StageKind::belt && !(s.eta > (1.0 - s.slip) * (1.0 + 1e-12)));
}

std::string path_of(const Train::Input& in, const Stage* s) {
  return s->name.empty() ? "stages[" + std::to_string(s - in.stages.data() + 1) + "]"
                         : "stages." + std::string(s->name.view());
}

template <class Holds>
FieldFault fault_of(const Train::Input& in, Holds holds, Message message, Message hint) {
  const auto found = std::find_if_not(in.stages.begin(), in.stages.end(), holds);
  if (found == in.stages.end()) return {};
  return {path_of(in, &*found), std::move(message), std::move(hint)};
}

/// What a planetary set makes of its members: ratio and efficiency by Willis, its third member held.
struct Set {
  double i, eta;
};

Set planetary_set(const Stage& s) {
  gear::Planetary::Input set;
  set.z_s = s.z_s, set.z_r = s.z_r, set.z_p = Whole(std::max(1.0, (s.z_r - s.z_s) / 2.0)), set.N_p = 1;
  set.eta_0 = s.eta;
  const auto held = [&](Member member) { return s.in != member && s.out != member; };
  set.fixed = held(Member::sun)       ? gear::Planetary::Member::sun
              : held(Member::carrier) ? gear::Planetary::Member::carrier
                                      : gear::Planetary::Member::ring;
  const AngularSpeed one = from_si<AngularSpeed>(1.0);
  const Moment unit = from_si<Moment>(1.0);
  if (s.in == Member::sun) set.n_s = one, set.T_s = unit;
  if (s.in == Member::carrier) set.n_c = one, set.T_c = unit;
  if (s.in == Member::ring) set.n_r = one, set.T_r = unit;
  NoTrace trace;
  const auto r = gear::Planetary::evaluate(set, trace);
  const AngularSpeed out = s.out == Member::sun ? r.n_s : s.out == Member::carrier ? r.n_c : r.n_r;
  return {one / out, r.eta};
}

struct Usual {
  double low, high;
};

/// The ranges are a warning, no limit: [B40] gives that of chains, [Efficiencies] the others.
Usual usual_of(StageKind kind) {
  switch (kind) {
    case StageKind::gear:
    case StageKind::internal:
      return {0.94, 0.99};
    case StageKind::belt:
      return {0.94, 0.985};
    case StageKind::chain:
      return {0.94, 0.98};
    case StageKind::worm:
      return {0.5, 0.9};
    case StageKind::planetary:
      return {0.94, 0.99};
    case StageKind::other:
      break;
  }
  return {unset<double>, unset<double>};
}

double turn_of(const Stage& s) {
  if (s.sense == Train::Sense::usual) return s.kind == StageKind::gear ? -1.0 : 1.0;
  return s.sense == Train::Sense::same ? 1.0 : -1.0;
}

template <class Tracer>
double ratio_of(const Stage& s, Tracer& trace) {
  const double turn = turn_of(s), z_1 = s.z_1, z_2 = s.z_2, slip = s.slip;
  const auto d_1 = s.d_1, d_2 = s.d_2;
  trace.value("turn", turn, "-1 where the second shaft turns the other way");
  if (is_set(s.i)) {
    const double i_given = s.i;
    trace.value("i_given", i_given, "as given");
    return NAMED_STEP("i", turn * i_given, "ratio of the speeds as given");
  }
  if (has_teeth(s)) {
    trace.value("z_1", z_1, "teeth on the first shaft");
    trace.value("z_2", z_2, "teeth on the second shaft");
    return NAMED_STEP("i", turn * z_2 / z_1, "ratio from the teeth");
  }
  trace.value("slip", slip, "of a belt");
  trace.value("d_1", d_1, "diameter on the first shaft");
  trace.value("d_2", d_2, "diameter on the second shaft");
  return NAMED_STEP("i", turn * d_2 / d_1 / (1.0 - slip), "ratio from the diameters, with the slip of a belt, [B40]");
}

template <class Tracer>
void rate(const Stage& s, Train::StageResult& r, Tracer& trace) {
  const Usual usual = usual_of(s.kind);
  r.eta_low = usual.low, r.eta_high = usual.high;
  if (s.kind == StageKind::planetary) {
    const Set set = planetary_set(s);
    const double turn = s.sense == Train::Sense::opposite ? -1.0 : 1.0;
    r.i = turn * set.i, r.eta = set.eta;
    trace.value("i", r.i, "by Willis, the third member held, [Willis]");
    trace.value("eta", r.eta, "by the rolling power, [Mueller]");
  } else {
    r.i = ratio_of(s, trace);
    r.eta = is_set(s.eta) ? s.eta : 1.0 - s.slip;
    trace.value("eta", r.eta,
                is_set(s.eta) ? "as given, the slip of a belt included" : "no losses but the slip of a belt");
  }
  if (!is_set(usual.low) || !is_set(s.eta)) return;
  r.range = s.eta < usual.low    ? Train::EtaRange::below
            : s.eta > usual.high ? Train::EtaRange::above
                                 : Train::EtaRange::usual;
}

/// Reference diameters of the wheels of a stage, as far as they are known.
struct Diameters {
  Length first = unset<Length>, second = unset<Length>;
};

Diameters diameters_of(const Stage& s) {
  if (is_set(s.d_1)) return {s.d_1, s.d_2};
  if (!has_teeth(s)) return {};
  const bool gears = s.kind == StageKind::gear || s.kind == StageKind::internal;
  const Length tooth = gears ? s.m_n / std::cos(s.beta) : s.kind == StageKind::chain ? s.p / pi : unset<Length>;
  return {tooth * s.z_1, tooth * s.z_2};
}

/// Speed, torque and power behind a stage.
template <class Tracer>
void drive(const Train::Shaft& before, Train::StageResult& stage, Train::Shaft& after, Tracer& trace) {
  const double i = stage.i, eta = stage.eta;
  const auto n_before = before.n;
  const auto T_before = before.T;
  if (is_set(n_before)) {
    trace.value("n_before", n_before, "speed before the stage");
    after.n = NAMED_STEP("n", n_before / i, "speed behind the stage, [B40]");
  }
  if (!is_set(T_before)) return;
  trace.value("T_before", T_before, "torque before the stage");
  STEP(T, T_before * i * eta, "torque behind the stage, [B40]");
  STEP(T_h, T - T_before, "equilibrium of the housing");
  after.T = T, stage.T_h = T_h;
  if (is_set(after.n)) {
    const auto n = after.n;
    STEP(P, T * n, "power behind the stage");
    STEP(P_loss, T_before * n_before * (1.0 - eta), "power that is lost");
    after.P = P, stage.P_loss = P_loss;
  }
}

template <class Tracer>
void first_shaft(const Train::Input& in, Train::Result& r, Tracer& trace) {
  const auto P = in.P;
  const auto n_1 = in.n_1;
  r.T_1 = in.T_1;
  if (is_set(P)) r.T_1 = NAMED_STEP("T_1", P / n_1, "torque that enters");
  Train::Shaft shaft;
  shaft.n = n_1, shaft.T = r.T_1;
  if (is_set(n_1) && is_set(r.T_1)) shaft.P = r.T_1 * n_1;
  r.shafts.push_back(shaft);
}

template <class Tracer>
void whole(const Train::Input& in, Train::Result& r, Tracer& trace) {
  r.i = r.eta = 1.0;
  for (const auto& s : r.stages) r.i *= s.i, r.eta *= s.eta;
  const double size = std::abs(r.i);
  trace.value("i", r.i, "product of the ratios of the stages, [B40]");
  trace.value("eta", r.eta, "product of the efficiencies of the stages, [B40]");
  r.works = size > 1.0 ? Train::Works::reducer : size < 1.0 ? Train::Works::multiplier : Train::Works::neither;
  const Train::Shaft& last = r.shafts.back();
  r.n_out = last.n, r.T_out = last.T, r.P_out = last.P;
  if (is_set(in.n_1) && is_set(r.T_1)) r.P_loss = r.T_1 * in.n_1 * (1.0 - r.eta);
}

}  // namespace

bool Train::ratios_known(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), is_known); }

FieldFault Train::open_ratio(const Input& in) {
  return fault_of(in, is_known, say("the ratio of this stage is not given"),
                  say("give i; or z_1 and z_2; or d_1 and d_2; of a planetary set z_s and z_r"));
}

bool Train::ratios_single(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), is_single); }

FieldFault Train::double_ratio(const Input& in) {
  return fault_of(in, is_single,
                  say("the ratio of this stage is given more than once, or by what its kind does not have"),
                  say("give i, or teeth, or diameters; z_s and z_r belong to kind = \"planetary\" alone"));
}

bool Train::slips_fit(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), slip_fits); }

FieldFault Train::wrong_slip(const Input& in) {
  return fault_of(in, slip_fits, say("slip belongs to a belt, and its efficiency contains it: eta is at most 1 - slip"),
                  say("leave out eta, or lower it; leave out the slip of anything but a belt"));
}

bool Train::members_differ(const Input& in) {
  return std::all_of(in.stages.begin(), in.stages.end(), [](const Stage& s) {
    return s.kind != StageKind::planetary || (s.in != s.out && s.z_r > s.z_s + 1);
  });
}

FieldFault Train::same_member(const Input& in) {
  return fault_of(
      in, [](const Stage& s) { return s.kind != StageKind::planetary || (s.in != s.out && s.z_r > s.z_s + 1); },
      say("power cannot enter and leave by one member, and the ring has more teeth than the sun"),
      say("choose in and out among sun, carrier, ring; z_r is larger than z_s"));
}

template <class Tracer>
Train::Result Train::evaluate(const Input& in, Tracer& trace) {
  Result r;
  first_shaft(in, r, trace);
  for (std::size_t k = 0; k < in.stages.size(); ++k) {
    [[maybe_unused]] const auto here = trace.scope("stages", k);
    StageResult stage;
    Shaft after;
    rate(in.stages[k], stage, trace);
    drive(r.shafts.back(), stage, after, trace);
    const Diameters d = diameters_of(in.stages[k]);
    r.shafts.back().F_out = 2.0 * abs(r.shafts.back().T) / d.first;
    after.F_in = 2.0 * abs(after.T) / d.second;
    r.stages.push_back(stage);
    r.shafts.push_back(after);
  }
  whole(in, r, trace);
  return r;
}

template Train::Result Train::evaluate(const Input&, NoTrace&);
template Train::Result Train::evaluate(const Input&, Trace&);

std::vector<draw::Figure> Train::figures(const Input&, const Result& r) {
  if (!is_set(r.shafts.front().T)) return {};
  draw::Plot plot;
  plot.x = {"k", "shaft, the first to the last", "-"};
  plot.y = {"T", "torque of the shaft, without its sign", "N*m"};
  draw::Curve curve{"T", {}, {}, true};
  for (std::size_t k = 0; k < r.shafts.size(); ++k) {
    const double at = static_cast<double>(k) + 1.0;
    curve.x.insert(curve.x.end(), {at - 0.4, at + 0.4});
    curve.y.insert(curve.y.end(), 2, std::abs(in_si(r.shafts[k].T)));
  }
  plot.curves.push_back(std::move(curve));
  return {{"torques", "Torque of every shaft", std::move(plot)}};
}

}  // namespace loadpath::drive

template const loadpath::Calculator& loadpath::erased<loadpath::drive::Train>();
