#include "calculators/drive/stage.hpp"

#include "calculators/gear/planetary/planetary.hpp"

#include <algorithm>

namespace loadpath::drive {

Set planetary_set(const TrainTypes::Stage& s) {
  using Member = TrainTypes::Member;
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

}  // namespace loadpath::drive
