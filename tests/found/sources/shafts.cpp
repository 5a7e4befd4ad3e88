// Steps next to the drive that their loads come from: the stage of a train, the wheels of a mechanism, the shaft under
// a component.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string train = R"([train]
calculator = "drive.train"
P = "5.5 kW"
n_1 = "1450 rpm"
stages = [
  { name = "belt", kind = "belt", d_1 = "125 mm", d_2 = "315 mm", slip = 0.015, eta = 0.95 },
  { name = "gears", kind = "gear", z_1 = 20, z_2 = 80, m_n = "3 mm", eta = 0.97 },
  { name = "chain", kind = "chain", z_1 = 21, z_2 = 57, p = "25.4 mm", eta = 0.96 },
]
)";

std::string gears_on(const std::string& shaft, const std::string& more = "", const std::string& z_2 = "80") {
  return train + "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = " + z_2 +
         "\nm_n = \"3 mm\"\nb = \"40 mm\"\nT_1 = \"=train.shafts[" + shaft + "].T\"\nn_1 = \"=train.shafts[" + shaft +
         "].n\"\nK_A = 1.2\nK_f = 1.5\ncutting = \"hobbed\"\nsigma_adm_1 = \"260 MPa\"\nsigma_adm_2 = \"240 MPa\"\n" +
         more;
}

std::string chain_with(const std::string& chain) {
  return train + "[c]\ncalculator = \"chain.roller\"\nchain = \"" + chain +
         "\"\nz_1 = 21\nz_2 = 57\na = \"1 m\"\nT_1 = \"=abs(train.shafts[3].T)\"\nn_1 = \"=abs(train.shafts[3].n)\"\n"
         "K_A = 1.2\np_adm = \"30 MPa\"\nS_min = 7\n";
}

std::string key_with(const std::string& T, const std::string& more) {
  return "[k]\ncalculator = \"shaft.key\"\nT = \"" + T +
         "\"\nK_A = 1.2\ntorque = \"one_way\"\nkey = \"18x11\"\nl = \"90 mm\"\nl_n = \"95 mm\"\nR_e_1 = \"370 MPa\"\n"
         "R_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\nS_F = 1.2\n" +
         more;
}

std::string geared(const std::string& gears) {
  return R"toml([press]
calculator = "mechanism.planar"
crank = { joint = "O", speed = "300 rpm", turns = 2, positions = 360 }
[press.ground]
O = ["0 mm", "0 mm"]
C = ["75 mm", "0 mm"]
B = ["75 mm", "0 mm"]
[press.links.pinion]
points = { O = ["0 mm", "0 mm"] }
angle = "10 deg"
[press.links.wheel]
points = { C = ["0 mm", "0 mm"], A = ["30 mm", "0 mm"] }
angle = "40 deg"
[press.links.rod]
points = { A = ["0 mm", "0 mm"], B = ["150 mm", "0 mm"] }
angle = "-10 deg"
[press.links.slider]
points = { B = ["0 mm", "0 mm"] }
angle = "0 deg"
mass = "2 kg"
[press.joints]
O = { type = "revolute", links = ["pinion", "ground"] }
C = { type = "revolute", links = ["wheel", "ground"] }
mesh = { type = "gear", links = ["pinion", "wheel"], points = ["O", "C"], radii = ["25 mm", "50 mm"] }
A = { type = "revolute", links = ["wheel", "rod"] }
B = { type = "revolute", links = ["rod", "slider"] }
guide = { type = "prismatic", links = ["slider", "ground"], points = ["B", "B"] }
[[press.loads]]
link = "slider"
at = "B"
F_x = "1 kN"
F_y = "0 N"
[g]
calculator = "gear.pair"
T_1 = "=peak(press.drive.M)"
n_1 = "300 rpm"
K_A = 1.5
K_f = 1.5
cutting = "hobbed"
idler = "both"
b = "25 mm"
sigma_adm_1 = "160 MPa"
sigma_adm_2 = "160 MPa"
)toml" + gears;
}

std::string wheels_confirmed(const std::string& gears) {
  return mode_of(solved_as_found(geared(gears)), "g", "typed_values");
}

}  // namespace

TEST_SUITE("found shafts") {
  TEST_CASE("a gear pair with the teeth of a stage carries the torque of that stage") {
    CHECK(mode_of(solved_as_found(gears_on("1")), "g", "root_1") == "not-judged");
    CHECK(mode_of(solved_as_found(gears_on("2")), "g", "root_1") == "pass");
    CHECK(mode_of(solved_as_found(gears_on("1", "", "60")), "g", "root_1") == "pass");  // a pair that is not a stage
    CHECK(
        mode_of(solved_as_found(gears_on("1", "because = { T_1 = \"drives the pump\", n_1 = \"drives the pump\" }\n")),
                "g", "root_1") == "pass");
  }

  TEST_CASE("a chain has the pitch of its stage") {
    CHECK(mode_of(solved_as_found(chain_with("20B")), "c", "typed_values") == "not-judged");
    CHECK(mode_of(solved_as_found(chain_with("16B")), "c", "typed_values") == "none");
  }

  TEST_CASE("a key under a sprocket carries the torque of its shaft") {
    const auto key = [](const std::string& shaft) {
      return chain_with("16B") +
             key_with("=abs(train.shafts[" + shaft + "].T)", "d = \"60 mm\"\nd_f = \"=c.shaft_1.d_f\"\n");
    };
    CHECK(mode_of(solved_as_found(key("2")), "k", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(key("3")), "k", "hub") == "pass");
  }

  TEST_CASE("a connection carries the torque of the shaft that its diameter comes from") {
    const std::string shaft =
        "[values]\nT = \"900 N*m\"\n[s]\ncalculator = \"shaft.torsion\"\nT = \"=values.T\"\n"
        "d = \"63 mm\"\ntau_adm = \"40 MPa\"\n";
    CHECK(mode_of(solved_as_found(shaft + key_with("=values.T/10", "d = \"=s.d\"\n")), "k", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(shaft + key_with("90 N*m", "d = \"=s.d\"\n")), "k", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(shaft + key_with("90 N*m", "d = \"=s.d\"\nbecause.T = \"drives the fan\"\n")), "k",
                  "hub") == "pass");
    CHECK(mode_of(solved_as_found(shaft + key_with("=s.T", "d = \"=s.d\"\n")), "k", "hub") == "pass");
    // Two connections on one shaft may carry different torques.
    const std::string two = key_with("900 N*m", "d = \"63 mm\"\n") +
                            "[k_2]\ncalculator = \"shaft.key\"\nT = \"90 N*m\"\nK_A = 1.2\ntorque = \"one_way\"\n"
                            "key = \"18x11\"\nd = \"=k.d\"\nl = \"90 mm\"\nl_n = \"95 mm\"\nR_e_1 = \"370 MPa\"\n"
                            "R_e_2 = \"300 MPa\"\nR_e_k = \"420 MPa\"\nS_F = 1.2\n";
    CHECK(mode_of(solved_as_found(two), "k_2", "hub") == "pass");
  }

  TEST_CASE("a belt turns its shaft as the stage of the train does") {
    const auto slip = [](const std::string& arrangement, const std::string& more = "") {
      const std::string belt = train +
                               "[b]\ncalculator = \"belt.flat\"\nP = \"=train.P\"\nK_A = 1.2\nn_1 = \"=train.n_1\"\n"
                               "d_1 = \"125 mm\"\nd_2 = \"315 mm\"\nepsilon = 0.015\na = \"900 mm\"\nmu = 0.4\n"
                               "kind = \"synthetic\"\ndelta = \"2 mm\"\nb = \"140 mm\"\nrho = \"1100 kg/m^3\"\n"
                               "sigma_adm = \"6 MPa\"\nE_b = \"40 MPa\"\narrangement = \"" +
                               arrangement + "\"\n" + more;
      return mode_of(solved_as_found(belt), "b", "grip");
    };
    CHECK(slip("open") == "pass");
    CHECK(slip("crossed") == "not-judged");
    CHECK(slip("crossed", "because.arrangement = \"reversing drive\"\n") == "pass");
  }

  TEST_CASE("a belt with the pulleys of a stage turns with the shaft before it") {
    const auto rating = [](const std::string& n_1) {
      return mode_of(solved_as_found(train +
                                     "[b]\ncalculator = \"belt.v\"\nbasis = \"optibelt\"\nsection = \"SPA\"\n"
                                     "P = \"=train.P\"\nK_A = 1.2\nd_1 = \"125 mm\"\nd_2 = \"315 mm\"\nL = \"2000 "
                                     "mm\"\nz = 4\nn_1 = \"" +
                                     n_1 + "\"\n"),
                     "b", "rim");
    };
    CHECK(rating("1450 rpm") == rating("=train.n_1"));
    CHECK(rating("575 rpm") == "not-judged");  // of the second shaft
  }

  TEST_CASE("gears and sprockets fit around the shaft whose torque they take") {
    const auto shaft = [](const std::string& d) {
      return "[s]\ncalculator = \"shaft.torsion\"\nT = \"30 N*m\"\nd = \"" + d + "\"\ntau_adm = \"30 MPa\"\n";
    };
    const auto gear = [&](const std::string& d, const std::string& more = "") {
      return mode_of(solved_as_found(shaft(d) +
                                     "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 80\nm_n = \"3 mm\"\nb = \"30 "
                                     "mm\"\nT_1 = \"=s.T\"\nn_1 = \"500 rpm\"\n" +
                                     more),
                     "g", "typed_values");
    };
    CHECK(gear("50 mm") == "none");  // root circle 52.5 mm
    CHECK(gear("56 mm") == "not-judged");
    CHECK(gear("56 mm", "because.T_1 = \"the shaft steps down to 40 mm\"\n") == "none");
    const auto chain = [&](const std::string& d) {
      return mode_of(
          solved_as_found(shaft(d) + "[c]\ncalculator = \"chain.roller\"\nchain = \"08B\"\nz_1 = 17\nz_2 = 38\n"
                                     "a = \"500 mm\"\nT_1 = \"=s.T\"\nn_1 = \"100 rpm\"\n"),
          "c", "typed_values");
    };
    CHECK(chain("40 mm") == "none");
    CHECK(chain("75 mm") == "not-judged");
  }

  TEST_CASE("gears on the shaft of the crank are the wheels of the mechanism") {
    CHECK(wheels_confirmed("z_1 = 20\nz_2 = 40\nm_n = \"2.5 mm\"\n") == "none");
    CHECK(wheels_confirmed("z_1 = 20\nz_2 = 100\nm_n = \"2.5 mm\"\n") == "not-judged");
    CHECK(wheels_confirmed("z_1 = 20\nz_2 = 40\nm_n = \"5 mm\"\n") == "not-judged");
    CHECK(wheels_confirmed("z_1 = 20\nz_2 = 40\nm_n = \"2.5 mm\"\na_w = \"76.2 mm\"\n") == "not-judged");
    CHECK(wheels_confirmed("z_1 = 20\nz_2 = 100\nm_n = \"2.5 mm\"\nbecause.T_1 = \"a second pair on this shaft\"\n") ==
          "none");
  }
}
