// Stresses of a section under bending, thrust, torque and shear at once: beside a strip of 1/400000 of the radius, by
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
Section middle_of(double l, double bore, double F, double F_z, double k_max = 1.0) {
  Design::Input in;
  in.E = 210.0 * GPa, in.G = 81.0 * GPa, in.R_e = 500.0 * MPa, in.S_F = 1.5, in.k_max = k_max;
  in.pieces.push_back({{}, l * mm, 40.0 * mm, bore * mm});
  in.supports.push_back({{}, 0.0 * mm, Holds::both});
  in.supports.push_back({{}, l * mm});
  shaft::Seat takes, drives;
  takes.x = l / 2.0 * mm, takes.T = 300.0 * N_m, takes.F_x = F * N, takes.F_z = F_z * N;
  drives.x = 0.0 * mm, drives.T = 300.0 * N_m, drives.way = shaft::Way::drives;
  in.seats.push_back(takes);
  in.seats.push_back(drives);
  const Design::Result r = test::evaluated<Design>(in);
  for (const Section& p : r.sections) {
    if (rel(p.x, l / 2.0 * mm) < 1e-9) return p;
  }
  return {};
}

}  // namespace

TEST_SUITE("shaft design") {
  TEST_CASE("bending, thrust and torque of a bored shaft meet at its surface, whichever way it is pushed") {
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

  TEST_CASE("in a short shaft the neutral axis bears most: shear of the force with that of the torque") {
    CHECK(rel(middle_of(20.0, 20.0, 100e3, 20e3).sigma_v, 216.6725243515099 * MPa) < 1e-8);
    CHECK(rel(middle_of(20.0, 0.0, 100e3, 20e3).sigma_v, 134.18501658695146 * MPa) < 1e-8);
  }
}
