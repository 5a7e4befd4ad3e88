// Regression tests of drives, and what must not be refused: ratings beyond the chain, spans without sag, belts
// without mass, gears that turn back.
#include "tests/found/modes.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string chain(const std::string& lines) {
  return "[c]\ncalculator = \"chain.roller\"\nchain = \"08B\"\nedition = \"maker\"\nz_1 = 25\nz_2 = 75\nn_1 = \"300 "
         "rpm\"\nP = \"1.5 kW\"\nK_A = 1\na = \"500 mm\"\nlubrication = \"bath\"\np_adm = \"45 MPa\"\nS_min = 5\n" +
         lines + "\n";
}

std::string chain_mode(const std::string& lines, const char* id) {
  return mode_of(solved_as_found(chain(lines)), "c", id);
}

std::string belt(const std::string& lines) {
  return "[c]\ncalculator = \"belt.course\"\nmu = 0.5\nS_adm = \"2 kN\"\npulleys = [{ name = \"motor\", x = \"0 mm\", "
         "y = \"0 mm\", d = \"200 mm\" }, { name = \"fan\", x = \"600 mm\", y = \"100 mm\", d = \"250 mm\", P = \"5 "
         "kW\" }]\n" +
         lines + "\n";
}

std::string gears(const std::string& lines) {
  return "z_1 = 20\nz_2 = 57\nm_n = \"4 mm\"\nbeta = \"15 deg\"\nb = \"40 mm\"\nx_1 = 0\nx_2 = \na_w = \ncutting = "
         "\"hobbed\"\nK_f = 1.6\nT_1 = \nP = \nn_1 = \n" +
         lines;
}

}  // namespace

TEST_SUITE("found drives") {
  TEST_CASE("a rating far above that of the pitch and the speed needs a reason") {
    for (const char* id : {"plates", "rollers"}) {
      CHECK_MESSAGE(chain_mode("P_R = \"8 kW\"", id) == "not-judged", id);
      CHECK_MESSAGE(chain_mode("P_R = \"2.5 kW\"", id) == "pass", id);
      CHECK_MESSAGE(chain_mode("P_R = \"8 kW\"\nbecause.P_R = \"maker\"", id) == "pass", id);
      CHECK_MESSAGE(chain_mode("P_R = \"8 kW\"\nstrands = 6", id) == "pass", id);
    }
  }

  TEST_CASE("a long chain without a sag force needs a reason") {
    const std::string far = "P_R = \"2.5 kW\"\na = \"20 m\"\nbecause.a = \"guided\"\n";
    const auto with = [&](const std::string& K_f) {
      std::string text = chain(far + K_f);
      return text.replace(text.find("a = \"500 mm\"\n"), 13, "");
    };
    CHECK(mode_of(solved_as_found(with("K_f = 0")), "c", "breaking") == "not-judged");
    CHECK(mode_of(solved_as_found(with("K_f = 1")), "c", "breaking") == "pass");
    CHECK(mode_of(solved_as_found(with("")), "c", "breaking") == "pass");
    CHECK(mode_of(solved_as_found(with("K_f = 0\nbecause.K_f = \"on a rail\"")), "c", "breaking") == "pass");
  }

  TEST_CASE("a fast belt has a mass") {
    const auto state = [](const std::string& lines) {
      return mode_of(solved_as_found(belt(lines)), "c", "centrifugal");
    };
    CHECK(state("n_1 = \"9000 rpm\"") == "not-judged");
    CHECK(state("n_1 = \"9000 rpm\"\nq = \"0 kg/m\"") == "not-judged");
    CHECK(state("n_1 = \"9000 rpm\"\nq = \"0.1 kg/m\"") == "none");
    CHECK(state("n_1 = \"900 rpm\"") == "none");
  }

  TEST_CASE("gears after an odd number of meshes turn backwards: as with turns = \"cw\", mirrored") {
    for (const char* const hand : {"right", "left"}) {
      for (const char* const sense : {"cw", "ccw"}) {
        const bool is_cw = std::string(sense) == "cw";
        const std::string of = "hand = \"" + std::string(hand) + "\"\nturns = \"";
        const std::string forward = gears(of + sense + "\"\nn_1 = \"500 rpm\"\n");
        const std::string back = gears(of + (is_cw ? "ccw" : "cw") + "\"\nn_1 = \"-500 rpm\"\n");
        for (const char* const load : {"P = \"10 kW\"", "T_1 = \"190 N*m\""}) {
          const ExampleStep a("gear.pair", forward + load), b("gear.pair", back + load);
          REQUIRE_MESSAGE(b.fault().empty(), b.fault());
          for (const char* const key :
               {"v", "K_v", "F_t", "F_x1", "F_y1", "F_z1", "F_y2", "F_z2", "T_2", "sigma_F1", "sigma_F2", "gear_1.T",
                "gear_1.n", "gear_1.F_y", "gear_1.F_z", "gear_2.n", "gear_2.F_y", "gear_2.F_z"})
            CHECK_MESSAGE(a(key) == doctest::Approx(b(key)).epsilon(1e-12), key);
          CHECK(a("n_2") == doctest::Approx(-b("n_2")).epsilon(1e-12));
        }
        const ExampleStep negative("gear.pair", back + "T_1 = \"-190 N*m\""),
            same("gear.pair", back + "T_1 = \"190 N*m\"");
        CHECK(negative("F_y1") == same("F_y1"));  // a train gives torque and speed their sign
      }
    }
    CHECK(!ExampleStep("gear.pair", gears("n_1 = \"0 rpm\"\nT_1 = \"1 N*m\"")).fault().empty());
  }

  TEST_CASE("speed and torque of a train are passed on to the gears of its stages") {
    const std::string train =
        "[train]\ncalculator = \"drive.train\"\nP = \"5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = \"a\", kind = "
        "\"gear\", z_1 = 20, z_2 = 60 }, { name = \"b\", kind = \"gear\", z_1 = 19, z_2 = 61 }]\n";
    const auto pair = [](const std::string& load) {
      return "[g]\ncalculator = \"gear.pair\"\nz_1 = 19\nz_2 = 61\nm_n = \"4 mm\"\nb = \"40 mm\"\ncutting = "
             "\"hobbed\"\n"
             "K_f = 1.6\nsigma_adm_1 = \"250 MPa\"\nsigma_adm_2 = \"250 MPa\"\n" +
             load;
    };
    const std::string signed_ones = "T_1 = \"=train.shafts[2].T\"\nn_1 = \"=train.shafts[2].n\"\n";
    CHECK(first_error_of(train + pair(signed_ones)).empty());
    CHECK(mode_of(solved_as_found(train + pair(signed_ones)), "g", "root_1") == "pass");
    CHECK(first_error_of(train + pair("P = \"=train.shafts[2].P\"\nn_1 = \"=train.shafts[2].n\"\n")).empty());
  }
}
