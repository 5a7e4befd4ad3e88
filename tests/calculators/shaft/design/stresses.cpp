// Stresses of a section under bending, thrust, torque and shear at once: against strips of 1/400000 of the radius, by
// which an independent program finds the shear at the neutral axis.
#include "calculators/shaft/design/design.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using shaft::Design;
using shaft::Holds;
using shaft::Section;
using test::rel;

/// 40 mm between rigid bearings at its ends, the force in the middle, the thrust held on the left; half of the shaft
/// under torque.
Design::Input loaded_in_the_middle(double l, double bore, double F, double F_z) {
  Design::Input in;
  in.E = 210.0 * GPa, in.G = 81.0 * GPa, in.R_e = 500.0 * MPa, in.R_m = 700.0 * MPa, in.S_F = 1.5;
  in.pieces.push_back({{}, l * mm, 40.0 * mm, bore * mm});
  in.supports.push_back({{}, 0.0 * mm, Holds::both});
  in.supports.push_back({{}, l * mm});
  shaft::Seat takes, drives;
  takes.x = l / 2.0 * mm, takes.T = 300.0 * N_m, takes.F_x = F * N, takes.F_z = F_z * N;
  drives.x = 0.0 * mm, drives.T = 300.0 * N_m, drives.way = shaft::Way::drives;
  in.seats.push_back(takes);
  in.seats.push_back(drives);
  return in;
}

template <class Elements>
const auto& middle_of(const Elements& all, const Design::Input& in) {
  for (const auto& p : all) {
    if (rel(p.x, in.pieces[0].l / 2.0) < 1e-9) return p;
  }
  FAIL("nothing is in the middle");
  return all[0];
}

Section middle_of(double l, double bore, double F, double F_z, double k_max = 1.0) {
  Design::Input in = loaded_in_the_middle(l, bore, F, F_z);
  in.k_max = k_max;
  return middle_of(test::evaluated<Design>(in).sections, in);
}

}  // namespace

TEST_SUITE("shaft design") {
  TEST_CASE("bending, thrust and torque of a bored shaft meet at its surface, in either direction of the thrust") {
    for (const double thrust : {20e3, -20e3}) {
      const Section p = middle_of(200.0, 20.0, 10e3, thrust);
      CHECK(rel(p.M, 500.0 * N_m) < 1e-9);
      CHECK(rel(p.sigma_b, 84.88263631567752 * MPa) < 1e-9);
      CHECK(rel(p.sigma_n, (thrust > 0.0 ? 21.22065907891938 : -21.22065907891938) * MPa) < 1e-9);
      CHECK(rel(p.tau, 25.464790894703253 * MPa) < 1e-9);
      CHECK(rel(p.sigma_v, 114.90550909127887 * MPa) < 1e-9);
      CHECK(rel(p.u_v, 1.5 * 114.90550909127887 / 500.0) < 1e-9);
    }
    CHECK(rel(middle_of(200.0, 20.0, 10e3, 20e3, 2.0).sigma_v, 229.81101818255774 * MPa) < 1e-9);
  }

  TEST_CASE("in a short shaft the neutral axis has the highest stress: shear of the force with that of the torque") {
    CHECK(rel(middle_of(20.0, 20.0, 100e3, 20e3).sigma_v, 216.6725243515099 * MPa) < 1e-8);
    CHECK(rel(middle_of(20.0, 0.0, 100e3, 20e3).sigma_v, 134.18501658695146 * MPa) < 1e-8);
  }

  TEST_CASE("of a torque that drops to a fifth, two fifths alternate and three fifths are constant, next to bending") {
    Design::Input in = loaded_in_the_middle(200.0, 20.0, 10e3, 20e3);
    in.S_D = 1.5, in.r_T = 0.2, in.n = 100.0 * rpm;
    const shaft::Safety s = middle_of(test::evaluated<Design>(in).safeties, in);
    CHECK(rel(s.sigma_a, 86.69671633948334 * MPa) < 1e-9);
    CHECK(rel(s.sigma_m, 33.92120860287207 * MPa) < 1e-9);
  }

  TEST_CASE("a cross hole removes a strip of the section") {
    Design::Input in = loaded_in_the_middle(200.0, 0.0, 10e3, 20e3);
    shaft::Notched hole;
    hole.x = 100.0 * mm, hole.kind = shaft::Notch::cross_hole, hole.r = 5.0 * mm;
    in.notches.push_back(hole);
    const Section p = middle_of(test::evaluated<Design>(in).sections, in);
    CHECK(rel(p.sigma_b, 138.25450652981746 * MPa) < 1e-9);
    CHECK(rel(p.sigma_n, 23.347110346212993 * MPa) < 1e-9);
    CHECK(rel(p.tau, 30.303936520235656 * MPa) < 1e-9);
  }
}
