// Rules of motion.plane beyond the bounds of its fields.
#include "calculators/motion/plane.hpp"
#include "calculators/motion/plane_parts.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::motion {

namespace {

using Input = Plane::Input;

constexpr double rigid = 1e-3;  // share of the larger speed: tolerance for rounded velocities of a rigid body

double projection_of_A(const Input& in) { return in_si(in.v_A) * cosine_to_AB(in, in.alpha_A); }
double projection_of_B(const Input& in) { return rests_in_B(in) ? 0.0 : in_si(in.v_B) * cosine_to_AB(in, in.alpha_B); }

}  // namespace

bool Plane::has_one_way(const Input& in) {
  const bool tells = has_B(in) && (is_set(in.alpha_B) || rests_in_B(in));
  const bool starts = is_set(in.v_B) || is_set(in.alpha_B);
  return is_set(in.omega) ? !starts : tells;
}
bool Plane::is_B_apart(const Input& in) { return !has_B(in) || distance(in) > 0.0; }
bool Plane::has_speed_of_B(const Input& in) {
  if (!uses_B(in) || !has_one_way(in) || !is_B_apart(in) || is_set(in.v_B)) return true;
  return !is_across_AB(in, in.alpha_B);
}
bool Plane::projections_agree(const Input& in) {
  if (!uses_B(in) || !has_one_way(in) || !is_B_apart(in) || !is_set(in.v_B)) return true;
  const double larger = std::max(std::abs(in_si(in.v_A)), std::abs(in_si(in.v_B)));
  return std::abs(projection_of_A(in) - projection_of_B(in)) <= rigid * larger;
}
FieldFault Plane::projections(const Input& in) {
  return {"",
          say("the velocity of A has {1} along AB and that of B {2}: AB would change its length",
              format_quantity(projection_of_A(in), "m/s", 4), format_quantity(projection_of_B(in), "m/s", 4)),
          say("leave out v_B: it follows from the velocity of A")};
}
bool Plane::guide_is_oblique(const Input& in) {
  return !is_set(in.alpha_aB) || (has_B(in) && is_B_apart(in) && !is_across_AB(in, in.alpha_aB));
}

}  // namespace loadpath::motion
