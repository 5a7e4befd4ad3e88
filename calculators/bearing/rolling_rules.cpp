// Rules of bearing.rolling beyond the bounds of its fields, and its applicable failure modes.
#include "calculators/bearing/rolling.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace loadpath::bearing {

namespace {

constexpr Force none = 0.0 * N.one;

bool has_axial_block(const Rolling::Input& in) {
  return std::any_of(in.blocks.begin(), in.blocks.end(), [](const Block& b) { return is_set(b.F_a) && b.F_a != none; });
}

/// Whether X and Y decide about this load.
bool needs_factors(const Rolling::Input& in) {
  if (in.kind == Kind::unstated || takes_axial_alone(in.kind) || takes_radial_alone(in.kind)) return false;
  return in.F_a != none || has_axial_block(in) || (at_an_angle(in.kind) && in.F_r > none);
}

bool by_f_0(const Rolling::Input& in) { return in.kind == Kind::deep_groove_ball && is_set(in.f_0); }

double sum_of_shares(const Rolling::Input& in) {
  double sum = 0.0;
  for (const Rolling::Block& b : in.blocks) sum += b.q;
  return sum;
}

/// Sums of typed thirds deviate slightly from 1.
constexpr double rounding = 1e-3 * (1.0 + 1e-9);

}  // namespace

AngularSpeed Rolling::highest_speed(const Input& in) {
  AngularSpeed n = in.blocks.empty() ? in.n : 0.0 * rpm.one;
  for (const Block& b : in.blocks) {
    const AngularSpeed own = is_set(b.n) ? b.n : in.n;
    if (!is_set(own)) return own;
    n = std::max(n, own);
  }
  return n;
}

bool Rolling::has_axial(const Input& in) {
  return has_mate(in) || in.F_a != none || has_axial_block(in) || (is_set(in.F_a0) && in.F_a0 != none);
}

bool Rolling::factors_once(const Input& in) {
  if (!is_set(in.f_0) || in.kind == Kind::unstated) return true;
  return in.kind == Kind::deep_groove_ball && !is_set(in.e) && !is_set(in.Y);
}

bool Rolling::factors_given(const Input& in) {
  if (!needs_factors(in)) return true;
  if (by_f_0(in)) return is_set(in.C_0);
  const bool X = is_set(in.X) || is_set(radial_factor(in.kind));
  return is_set(in.e) && is_set(in.Y) && X && (is_set(in.Y_1) || !has_two_rows(in.kind));
}

FieldFault Rolling::missing_factors(const Input& in) {
  if (by_f_0(in)) return {"C_0", say("f_0 gives e and Y by f_0 F_a/C_0"), say("give the static load rating C_0")};
  if (in.kind == Kind::deep_groove_ball)
    return {"F_a", say("an axial load on a deep groove ball bearing needs e and Y"),
            say("give f_0 and C_0 of the manufacturer's table, or e and Y")};
  std::string wanted;
  const auto want = [&](double value, const char* key) {
    if (!is_set(value)) wanted += (wanted.empty() ? "" : ", ") + std::string(key);
  };
  want(in.e, "e");
  if (!is_set(radial_factor(in.kind))) want(in.X, "X");
  if (has_two_rows(in.kind)) want(in.Y_1, "Y_1");
  want(in.Y, has_two_rows(in.kind) ? "Y (Y_2 of the table)" : "Y");
  return {"kind",
          at_an_angle(in.kind) ? say("in an angular contact or tapered bearing every load causes an axial load")
                               : say("an axial load on this bearing needs the factors of the manufacturer's table"),
          say("give {1}", wanted)};
}

bool Rolling::static_factors_given(const Input& in) {
  return !is_set(in.s_0) || is_set(in.Y_0) || in.kind == Kind::unstated || takes_axial_alone(in.kind) ||
         !has_axial(in) || is_set(static_axial_factor(in.kind));
}

bool Rolling::ratings_agree(const Input& in) {
  if (!is_set(in.C_0)) return true;
  const RatioOfRatings usual = ratio_of_ratings(in.kind, in.C / kN);
  const double ratio = in.C_0 / in.C;
  return !(ratio < usual.least) && !(ratio > usual.most);
}

FieldFault Rolling::odd_ratings(const Input& in) {
  const RatioOfRatings usual = ratio_of_ratings(in.kind, in.C / kN);
  return {"C_0",
          say("C_0 is {1} times C; for a bearing of this type and size {2} to {3} is possible",
              format_number(in.C_0 / in.C, 3), format_number(usual.least, 3), format_number(usual.most, 3)),
          say("take both from the same row of the manufacturer's table")};
}

bool Rolling::shares_close(const Input& in) {
  return in.blocks.empty() || std::abs(sum_of_shares(in) - 1.0) <= rounding;
}

FieldFault Rolling::open_shares(const Input& in) {
  return {"blocks", say("the shares q sum to {1}, not to 1", format_number(sum_of_shares(in))),
          say("give every block its fraction of time, and standstill as a block with n = \"0 rpm\"")};
}

/// A bearing without a speed turns, however fast: its life is in revolutions.
Applies Rolling::runs(const Input& in) {
  const AngularSpeed n = highest_speed(in);
  return where(is_set(in.L_m) || !is_set(n) || n > 0.0 * rpm.one);
}

/// Unknown if no speed is given.
Applies Rolling::runs_fast(const Input& in) {
  const AngularSpeed n = highest_speed(in);
  return is_set(n) ? where(n > 0.0 * rpm.one) : Applies::unseen;
}

Applies Rolling::runs_at_an_angle(const Input& in) {
  return at_an_angle(in.kind) && in.F_r > none ? Applies::yes : Applies::no;
}

Applies Rolling::has_axial_bound(const Input& in) {
  const bool shallow = in.kind == Kind::deep_groove_ball || bears_on_ribs(in.kind);
  return where(has_axial(in) && (shallow || is_set(in.F_a_adm)));
}

}  // namespace loadpath::bearing
