// Regression tests of gears and trains: faults found in use.
#include "calculators/gear/planetary/planetary.hpp"
#include "tests/found/modes.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string bare = "sigma_adm_1 = \nsigma_adm_2 = \n";
const std::string plain_ring =
    "mesh = \"internal\"\nz_1 = 20\nz_2 = 60\nbeta = \"0 deg\"\na_w = \nx_1 = 0\nsigma_adm_2 = \nm_n = \"2 mm\"";

std::string set_of(int z_s, int z_p, int z_r, int N_p) {
  return "z_s = " + std::to_string(z_s) + "\nz_p = " + std::to_string(z_p) + "\nz_r = " + std::to_string(z_r) +
         "\nN_p = " + std::to_string(N_p);
}

/// Tip circle over the least distance of two neighbours, each planet put where its teeth let it in nearest to its
/// even place.
double crowding(int z_s, int z_p, int N_p) {
  const int steps = 2 * (z_s + z_p);
  double least = 2.0 * pi;
  for (int k = 0; k < N_p; ++k) {
    const auto place = [&](int of) { return std::round(static_cast<double>(of) * steps / N_p); };
    least = std::min(least, 2.0 * pi * (place(k + 1) - place(k)) / steps);
  }
  return (z_p + 2.0) / ((z_s + z_p) * std::sin(least / 2.0));
}

}  // namespace

TEST_SUITE("found gear") {
  TEST_CASE("A7: a load without a strength is not assessed, and one gear does not hide the other") {
    CHECK(mode_with("gear.pair", bare, "root_1") == "not-judged");
    CHECK(mode_with("gear.pair", bare + "T_1 = \"6000 N*m\"", "root_2") == "not-judged");
    CHECK(mode_with("gear.pair", "sigma_adm_2 = ", "root_1") == "pass");
    CHECK(mode_with("gear.pair", "sigma_adm_2 = ", "root_2") == "not-judged");
    CHECK(mode_with("gear.pair", "", "root_2") == "pass");
    CHECK(mode_with("gear.pair", bare + "T_1 = ", "root_1") == "none");  // only geometry
  }

  TEST_CASE("A7: a face 50 times as wide as the pinion is not assessed") {
    CHECK(mode_with("gear.pair", "b = \"2500 mm\"", "width") == "not-judged");
    CHECK(mode_with("gear.pair", "", "width") == "open");
  }

  TEST_CASE("A8: a loaded pair is never without pitting, nor Lewis without the fillet") {
    for (const char* id : {"pitting_1", "pitting_2", "fillet"}) {
      CHECK(mode_with("gear.pair", "", id) == "not-judged");
      CHECK(mode_with("gear.pair", bare + "T_1 = ", id) == "none");
    }
    CHECK(mode_with("gear.pair", "K_f = 1.7", "fillet") == "none");
  }

  TEST_CASE("A9: planets at unequal spacing overlap where their gap is the smaller one") {
    CHECK(mode_with("gear.planetary", set_of(14, 13, 40, 5), "room") == "fail");
    CHECK(std::abs(ExampleStep("gear.planetary", set_of(14, 13, 40, 5))("u_N") - 1.011) < 5e-4);
    CHECK(mode_with("gear.planetary", set_of(24, 30, 84, 3), "room") == "pass");
    int overlooked = 0;
    NoTrace trace;
    for (int z_s = 12; z_s < 40; ++z_s) {
      for (int z_p = 12; z_p <= 60; ++z_p) {
        for (int N_p = 3; N_p <= 6; ++N_p) {
          gear::Planetary::Input in;
          in.z_s = z_s, in.z_p = z_p, in.N_p = N_p, in.n_s = 1000.0 * rpm;
          const double found = gear::Planetary::evaluate(in, trace).u_N, true_one = crowding(z_s, z_p, N_p);
          CHECK(std::abs(found / true_one - 1.0) < 1e-12);
          if ((z_p + 2.0) / ((z_s + z_p) * std::sin(pi / N_p)) <= 1.0 && found > 1.0) ++overlooked;
        }
      }
    }
    CHECK(overlooked == 56);
  }

  TEST_CASE("A10: planet and ring gear interfere as in gear.pair, until the ring gear is cut back") {
    CHECK(mode_with("gear.planetary", set_of(20, 20, 60, 4) + "\nh_ar = ", "mesh_ring") == "fail");
    CHECK(mode_with("gear.planetary", set_of(20, 20, 60, 4) + "\nh_ar = 0.86", "mesh_ring") == "pass");
    const ExampleStep set("gear.planetary", set_of(20, 20, 60, 4) + "\nh_ar = ");
    CHECK(set("f_pr") == doctest::Approx(ExampleStep("gear.pair", plain_ring)("f_int")).epsilon(1e-9));
    CHECK(set("h_clear") == doctest::Approx(0.8703).epsilon(1e-3));  // base circle 56.38, flank radii 6.840 and 0.496
  }

  TEST_CASE("A10: a ring gear with a given tip diameter is not refused") {
    CHECK(mode_with("gear.pair", plain_ring, "interference") == "fail");
    CHECK(mode_with("gear.pair", plain_ring + "\nd_a2 = \"116.6 mm\"", "interference") == "pass");
    CHECK(mode_with("gear.pair", plain_ring, "root_mate") == "not-judged");
    CHECK(mode_with("gear.pair", plain_ring, "trimming") == "open");
    CHECK(mode_with("gear.pair", "", "trimming") == "none");
  }

  TEST_CASE("A11: tips that cut into the roots fail") {
    const std::string tips =
        "z_1 = 30\nz_2 = 60\nm_n = \"3 mm\"\nbeta = \"0 deg\"\na_w = \nx_1 = 0\nh_aP = 1.05\nh_fP = 1\nrho_fP = 0";
    CHECK(std::abs(ExampleStep("gear.pair", tips)("c_1") + 0.15e-3) < 1e-12);
    CHECK(mode_with("gear.pair", tips, "clearance_1") == "fail");
    CHECK(mode_with("gear.pair", tips, "clearance_2") == "fail");
    CHECK(mode_with("gear.pair", tips + "\nh_fP = 1.25", "clearance_1") == "pass");
  }

  TEST_CASE("B11: a base-tangent length is given where the face is wide enough to measure it") {
    const auto length = [](const std::string& lines) { return ExampleStep("gear.pair", lines)("W_2"); };
    CHECK(length("") > 0.05);
    CHECK(std::isnan(length("b = \"11 mm\"")));  // W_2 sin(beta_b): 57.82 mm times sin 11.27 deg
    CHECK(length("b = \"12 mm\"") > 0.05);
    CHECK(length("b = \"1 mm\"\nbeta = \"0 deg\"\na_w = ") > 0.04);
  }

  TEST_CASE("A29: a train in which the worm gear drives the worm is not assessed") {
    const auto worm = [](const std::string& teeth) {
      return mode_with("drive.train", "stages = [{ kind = \"worm\", eta = 0.7, " + teeth + " }]", "self_locking");
    };
    CHECK(worm("z_1 = 40, z_2 = 1") == "not-judged");
    CHECK(worm("i = 0.025") == "not-judged");
    CHECK(worm("z_1 = 1, z_2 = 40") == "none");
  }
}
