#include "calculators/drive/train.hpp"

#include "calculators/drive/stage.hpp"
#include "lib/calculator/calculator_of.hpp"

#include <cmath>

namespace loadpath::drive {

namespace {

using Stage = Train::Stage;
using StageKind = Train::StageKind;

double turn_of(const Stage& s) {
  if (s.sense == Train::Sense::usual) return s.kind == StageKind::gear ? -1.0 : 1.0;
  return s.sense == Train::Sense::same ? 1.0 : -1.0;
}

template <class Tracer>
double ratio_of(const Stage& s, Tracer& trace) {
  const double turn = trace.value("turn", turn_of(s), "-1 if the second shaft rotates in the opposite direction");
  if (is_set(s.i)) {
    const double i_given = trace.value("i_given", s.i, "as given");
    return NAMED_STEP("i", turn * i_given, "ratio of the speeds as given");
  }
  if (s.has_teeth()) {
    trace.value("z_1", s.z_1, "teeth on the first shaft");
    trace.value("z_2", s.z_2, "number of teeth on the second shaft");
    return NAMED_STEP("i", turn * s.z_2 / s.z_1, "ratio from the teeth");
  }
  trace.value("slip", s.slip, "of a belt");
  trace.value("d_1", s.d_1, "diameter on the first shaft");
  trace.value("d_2", s.d_2, "diameter on the second shaft");
  return NAMED_STEP("i", turn * s.d_2 / s.d_1 / (1.0 - s.slip),
                    "ratio from the diameters, with the slip of a belt, [B40]");
}

template <class Tracer>
void rate(const Stage& s, Train::StageResult& r, Tracer& trace) {
  const Usual usual = usual_of(s.kind);
  r.eta_low = usual.low, r.eta_high = usual.high;
  if (s.kind == StageKind::planetary) {
    const Set set = planetary_set(s);
    const double turn = s.sense == Train::Sense::opposite ? -1.0 : 1.0;
    r.i = trace.value("i", turn * set.i, "by Willis, the third member held, [Willis]");
    r.eta = trace.value("eta", set.eta, "by the rolling power, [Mueller]");
  } else {
    r.i = ratio_of(s, trace);
    r.eta = trace.value("eta", is_set(s.eta) ? s.eta : 1.0 - s.slip,
                        is_set(s.eta) ? "as given, the slip of a belt included" : "no losses but the slip of a belt");
  }
  if (!is_set(usual.low) || !is_set(s.eta)) return;
  r.range = s.eta < usual.low    ? Train::EtaRange::below
            : s.eta > usual.high ? Train::EtaRange::above
                                 : Train::EtaRange::usual;
}

/// A worm that is left without losses, or has next to none.
template <class Tracer>
void bound(const Stage& s, Train::StageResult& r, Tracer& trace) {
  if (s.kind != StageKind::worm) return;
  const auto eta = trace.value("eta", r.eta, "of the worm"), eta_high = trace.value("eta_high", r.eta_high, "usual");
  STEP_TO(r, x_eta, eta / eta_high, "losses of a worm gear within the usual range");
}

/// Reference diameters of the wheels of a stage, as far as they are known.
struct Diameters {
  Length first = unset<Length>, second = unset<Length>;
};

Diameters diameters_of(const Stage& s) {
  if (is_set(s.d_1)) return {s.d_1, s.d_2};
  if (!s.has_teeth()) return {};
  const bool gears = s.kind == StageKind::gear || s.kind == StageKind::internal || s.kind == StageKind::bevel;
  const Length tooth = gears ? s.m_n / std::cos(s.beta) : s.kind == StageKind::chain ? s.p / pi : unset<Length>;
  return {tooth * s.z_1, tooth * s.z_2};
}

/// Speed, torque and power behind a stage.
template <class Tracer>
void drive(const Train::Shaft& before, Train::StageResult& stage, Train::Shaft& after, Tracer& trace) {
  const auto n_before = before.n;
  const auto T_before = before.T;
  if (is_set(n_before)) {
    trace.speed("n_before", n_before, "speed before the stage");
    STEP_TO(after, n, n_before / stage.i, "speed after the stage, [B40]");
  }
  if (!is_set(T_before)) return;
  trace.value("T_before", T_before, "torque before the stage");
  STEP_TO(after, T, T_before * stage.i * stage.eta, "torque after the stage, [B40]");
  STEP_TO(stage, T_h, T - T_before, "equilibrium of the housing");
  if (is_set(after.n)) {
    STEP_TO(after, P, T * after.n, "power after the stage");
    STEP_TO(stage, P_loss, T_before * n_before * (1.0 - stage.eta), "power loss");
  }
}

template <class Tracer>
void first_shaft(const Train::Input& in, Train::Result& r, Tracer& trace) {
  r.T_1 = in.T_1;
  if (is_set(in.P)) r.T_1 = NAMED_STEP("T_1", in.P / in.n_1, "input torque");
  Train::Shaft shaft;
  shaft.n = in.n_1, shaft.T = r.T_1;
  if (is_set(in.n_1) && is_set(r.T_1)) shaft.P = r.T_1 * in.n_1;
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

template <class Tracer>
Train::Result Train::evaluate(const Input& in, Tracer& trace) {
  Result r;
  first_shaft(in, r, trace);
  for (std::size_t k = 0; k < in.stages.size(); ++k) {
    [[maybe_unused]] const auto here = trace.scope("stages", k);
    StageResult stage;
    Shaft after;
    rate(in.stages[k], stage, trace);
    if (Train::loads_a_worm(in) == Applies::yes) bound(in.stages[k], stage, trace);
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

std::vector<figure::Figure> Train::figures(const Input&, const Result& r) {
  if (!is_set(r.shafts.front().T)) return {};
  figure::Plot plot;
  plot.x = {"k", "shaft, the first to the last", "-"};
  plot.y = {"T", "torque of the shaft, without its sign", "N*m"};
  figure::Curve curve{"T", {}, {}, true};
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
