#include "calculators/drive/stage.hpp"
#include "calculators/drive/train.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace loadpath::drive {

namespace {

using Stage = Train::Stage;
using StageKind = Train::StageKind;

bool has_diameters(const Stage& s) { return is_set(s.d_1) && is_set(s.d_2); }
bool has_planets(const Stage& s) { return s.z_s > 0 && s.z_r > 0; }

/// The diameters of crossed helical gears do not give their ratio.
bool is_known(const Stage& s) {
  if (s.kind == StageKind::planetary) return has_planets(s);
  return is_set(s.i) || s.has_teeth() || (s.kind != StageKind::crossed && has_diameters(s));
}

/// The ratio is given at most once; inputs of other kinds of stage are absent.
bool is_single(const Stage& s) {
  const bool planets = s.z_s > 0 || s.z_r > 0, teeth = s.z_1 > 0 || s.z_2 > 0, sizes = is_set(s.d_1) || is_set(s.d_2);
  if (s.kind == StageKind::planetary) return !teeth && !sizes && !is_set(s.i);
  return !planets && static_cast<int>(is_set(s.i)) + teeth + (sizes && !s.has_teeth()) <= 1;
}

bool slip_fits(const Stage& s) {
  return s.slip == 0.0 || (s.kind == StageKind::belt && !(s.eta > (1.0 - s.slip) * (1.0 + 1e-12)));
}

bool has_two_members(const Stage& s) { return s.kind != StageKind::planetary || (s.in != s.out && s.z_r > s.z_s + 1); }

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

}  // namespace

bool Train::ratios_known(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), is_known); }

FieldFault Train::open_ratio(const Input& in) {
  return fault_of(
      in, is_known, say("the ratio of this stage is not given"),
      say("give i; or z_1 and z_2; or d_1 and d_2 (not of crossed helical gears); of a planetary set z_s and z_r"));
}

bool Train::ratios_single(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), is_single); }

FieldFault Train::double_ratio(const Input& in) {
  return fault_of(in, is_single,
                  say("the ratio of this stage is given more than once, or by values that its kind does not have"),
                  say("give i, or teeth, or diameters; z_s and z_r only with kind = \"planetary\""));
}

bool Train::slips_fit(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), slip_fits); }

FieldFault Train::wrong_slip(const Input& in) {
  return fault_of(in, slip_fits,
                  say("slip applies to belts only, and their efficiency includes it: eta is at most 1 - slip"),
                  say("leave out eta, or lower it; leave out the slip of anything but a belt"));
}

/// With more than twice the losses of such a stage, or of a worm with one thread, the torques behind it would be too
/// small.
double Train::least_efficiency(const Input& in, std::size_t stage) {
  constexpr double of_one_thread = 0.3, most_losses = 2.0;
  const Stage& s = in.stages[stage];
  return s.kind == StageKind::worm ? of_one_thread : 1.0 - most_losses * (1.0 - usual_of(s.kind).low);
}

/// The wheel is on the first shaft: only a worm of many threads can be driven, and none that locks itself.
bool Train::drives_a_worm(const Input& in) {
  return std::any_of(in.stages.begin(), in.stages.end(), [](const Stage& s) {
    return s.kind == StageKind::worm && (is_set(s.i)     ? s.i < 1.0
                                         : s.has_teeth() ? s.z_2 < s.z_1
                                                         : has_diameters(s) && s.d_2 < s.d_1);
  });
}

Applies Train::loads_a_worm(const Input& in) {
  const bool worm =
      std::any_of(in.stages.begin(), in.stages.end(), [](const Stage& s) { return s.kind == StageKind::worm; });
  return where(worm && (is_set(in.P) || is_set(in.T_1)));
}

bool Train::members_differ(const Input& in) { return std::all_of(in.stages.begin(), in.stages.end(), has_two_members); }

FieldFault Train::same_member(const Input& in) {
  return fault_of(in, has_two_members,
                  say("power cannot enter and leave through one member, and the ring has more teeth than the sun"),
                  say("choose in and out among sun, carrier, ring; z_r is larger than z_s"));
}

}  // namespace loadpath::drive
