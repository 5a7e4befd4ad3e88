// Teeth and bearings next to the steps that show how long and where they run.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string gears = R"([gears]
calculator = "gear.pair"
z_1 = 21
z_2 = 84
m_n = "3 mm"
x_1 = 0.3
b = "45 mm"
T_1 = "140 N*m"
n_1 = "730 rpm"
K_f = 1.5
sigma_adm_1 = "260 MPa"
sigma_adm_2 = "260 MPa"
)";

std::string rated(const std::string& lines, const std::string& mesh = "mesh = \"=gears.mesh\"\n") {
  return "[rating]\ncalculator = \"gear.rating\"\n" + mesh + lines +
         "grade = 6\nmaterial_1 = \"case\"\nquality_1 = \"MQ\"\nH_1 = 700\nmaterial_2 = \"case\"\nquality_2 = "
         "\"MQ\"\n"
         "H_2 = 700\nS_Hmin = 1.1\nS_Fmin = 1.5\n";
}

/// The pinion 40 mm from the middle of a span of 120 mm, in `x` = 120 mm; 80 mm is midway.
std::string shaft_with(const std::string& x) {
  return R"([shaft]
calculator = "shaft.design"
material = "16MnCr5"
R_e = "440 MPa"
group = "carbon-steel"
pieces = [{ l = "220 mm", d = "50 mm" }]
supports = [{ name = "left", x = "20 mm", holds = "both" }, { name = "right", x = "140 mm" }]
seats = [
  { name = "pinion", x = ")" +
         x + R"(", load = "=gears.gear_1", b = "45 mm", I_p = "0.0012 kg*m^2", integral = true },
  { name = "coupling", x = "200 mm", way = "balances", b = "20 mm", I_p = "0.002 kg*m^2", integral = true },
]
S_F = 1.5
S_D = 1.5
r_T = 0
)";
}

std::string bearing(const std::string& name, const std::string& L_h) {
  return "[" + name + "]\ncalculator = \"bearing.rolling\"\nload = \"=shaft.bearings." + name +
         "\"\nkind = \"deep_groove_ball\"\nC = \"42.3 kN\"\nC_0 = \"24 kN\"\nf_0 = 13\nn_max = \"11000 rpm\"\nL_h = "
         "\"" +
         L_h + "\"\ns_0 = 1.5\n";
}

std::string pitting(const std::string& text) { return mode_of(solved_as_found(text), "rating", "pitting_1"); }

const std::string midway = "place = \"middle\"\n";

std::string place_with(const std::string& lines) { return pitting(gears + rated(lines) + shaft_with("120 mm")); }

}  // namespace

TEST_SUITE("found ratings") {
  TEST_CASE("teeth of one piece with a shaft are case-hardened if its steel can be") {
    const auto state = [](const std::string& steel) {
      std::string shaft = shaft_with("80 mm");
      shaft.replace(shaft.find("16MnCr5"), 7, steel);
      return pitting(gears + rated(midway) + shaft);
    };
    CHECK(state("16MnCr5") == "pass");
    CHECK(state("C45E") == "not-judged");
  }

  TEST_CASE("flanks that the pair has as cut are not rated as ground") {
    const std::string ground = "finish = \"ground\"\nR_z1 = \"4 um\"\nR_z2 = \"4 um\"\n" + midway;
    const auto pair = [](const std::string& cutting) { return gears + "cutting = \"" + cutting + "\"\n"; };
    for (const char* cutting : {"cast", "milled", "hobbed"}) {
      CHECK(first_error_of(pair(cutting) + rated(ground)).find("ground or shaved flanks") != std::string::npos);
      CHECK(first_error_of(pair(cutting) + rated(midway)) == "");
    }
    CHECK(first_error_of(pair("hobbed") + rated(ground + "T_1 = \"140 N*m\"\n")) != "");
    CHECK(first_error_of(pair("ground") + rated(ground)) == "");
    CHECK(first_error_of(gears + rated(ground)) == "");
    CHECK(pitting(pair("cast") + rated(midway)) == "not-judged");  // of grade 6
    CHECK(pitting(pair("hobbed") + rated(midway)) == "pass");
  }

  TEST_CASE("a load that a pair has without a reason is not assessed by its rating") {
    const std::string train =
        "[train]\ncalculator = \"drive.train\"\nP = \"11 kW\"\nn_1 = \"730 rpm\"\n"
        "stages = [{ name = \"gears\", kind = \"gear\", z_1 = 21, z_2 = 84, m_n = \"3 mm\", eta = 0.97 }]\n";
    const auto with = [&](const std::string& T_1, const std::string& more = "") {
      std::string pair = gears;
      pair.replace(pair.find("140 N*m"), 7, T_1).replace(pair.find("730 rpm"), 7, "=train.n_1");
      return mode_of(solved_as_found(train + pair + more + rated(midway)), "gears", "root_1");
    };
    CHECK(with("=train.T_1") == "pass");
    CHECK(with("30 N*m") == "not-judged");
    CHECK(with("30 N*m", "because.T_1 = \"a fifth of the load cycle\"\n") == "pass");
  }

  TEST_CASE("a pinion is rated where its shaft carries it") {
    CHECK(pitting(gears + rated(midway) + shaft_with("80 mm")) == "pass");
    CHECK(place_with(midway) == "not-judged");
    CHECK(place_with(midway + "because.place = \"stiffened by its housing\"\n") == "pass");
    const std::string here = "place = \"a\"\nl = \"120 mm\"\n";
    CHECK(place_with(here + "s = \"40 mm\"\nd_sh = \"50 mm\"\n") == "pass");
    CHECK(place_with(here + "s = \"10 mm\"\nd_sh = \"50 mm\"\n") == "not-judged");
    CHECK(place_with(here + "s = \"40 mm\"\nd_sh = \"54 mm\"\n") == "not-judged");
    CHECK(place_with("place = \"a\"\nl = \"90 mm\"\ns = \"40 mm\"\nd_sh = \"50 mm\"\n") == "not-judged");
  }

  TEST_CASE("the deflection of a shaft is that under the gear of the pair, with its application factor") {
    const std::string of_pinion = "f_sh_1 = \"=shaft.seats.pinion.f_sh\"\n";
    CHECK(place_with(of_pinion) == "pass");
    CHECK(place_with("f_sh_1 = \"=shaft.seats[1].f_sh\"\n") == "pass");
    CHECK(place_with("f_sh_1 = \"=shaft.seats.pinion.delta_s\"\n") == "not-judged");  // a part of it
    CHECK(first_error_of(gears + rated(of_pinion + midway) + shaft_with("120 mm")).find("f_sh_1") != std::string::npos);
    const auto on = [&](const std::string& gear, const std::string& lines, const std::string& more = "") {
      std::string shaft = shaft_with("120 mm");
      shaft.replace(shaft.find("gears.gear_1"), 12, gear);
      return pitting(gears + rated(of_pinion + lines) + shaft + more);
    };
    CHECK(on("gears.gear_2", "f_sh_2 = \"2 um\"\n") == "not-judged");
    std::string other = gears;
    other.replace(1, 5, "other");
    CHECK(on("other.gear_1", "", other) == "not-judged");
    CHECK(on("other.gear_1", "because.f_sh_1 = \"the same gear\"\n", other) == "pass");
    CHECK(on("gears.gear_1", "K_A = 1.1\n") == "not-judged");
    CHECK(on("gears.gear_1", "K_A = 1.1\nbecause.f_sh_1 = \"shocks are short\"\n") == "pass");
    std::string raised = gears;
    raised += "K_A = 1.1\n";
    CHECK(pitting(raised + rated(of_pinion) + shaft_with("120 mm")) == "pass");
    CHECK(pitting(gears + rated(of_pinion + "K_A = 1.1\n") + shaft_with("120 mm") + "K_A = 1.1\n") == "pass");
  }

  TEST_CASE("the deflection of the wheel shaft is taken, too, if the project has it") {
    const std::string of_pinion = "f_sh_1 = \"=shaft.seats.pinion.f_sh\"\n";
    std::string wheel = shaft_with("120 mm");
    wheel.replace(wheel.find("[shaft]"), 7, "[slow]").replace(wheel.find("gears.gear_1"), 12, "gears.gear_2");
    const auto with = [&](const std::string& lines) {
      return pitting(gears + rated(of_pinion + lines) + shaft_with("120 mm") + wheel);
    };
    CHECK(with("") == "not-judged");
    CHECK(with("f_sh_2 = \"=slow.seats.pinion.f_sh\"\n") == "pass");
    CHECK(with("f_sh_2 = \"=shaft.seats.pinion.f_sh\"\n") == "not-judged");
    CHECK(with("because.f_sh_2 = \"three bearings\"\n") == "pass");
  }

  TEST_CASE("a segment that is searched for does not hide the thicker one before it") {
    std::string shaft = shaft_with("120 mm");
    const std::string piece = R"({ l = "220 mm", d = "50 mm" })", fatigue = "S_D = 1.5\nr_T = 0\n";
    shaft.replace(shaft.find(piece), piece.size(),
                  R"({ l = "150 mm", d = "50 mm" }, { l = "10 mm", d = "?" }, { l = "60 mm", d = "40 mm" })");
    shaft.erase(shaft.find(fatigue), fatigue.size());
    const std::string here = "place = \"a\"\nl = \"120 mm\"\ns = \"40 mm\"\nd_sh = \"50 mm\"\n";
    CHECK(pitting(gears + rated(here) + shaft) == "pass");
  }

  TEST_CASE("teeth have the required life of the bearings of their shaft, and these the same among themselves") {
    const auto with = [](const std::string& teeth, const std::string& left, const std::string& right) {
      return solved_as_found(gears + rated(midway + teeth) + shaft_with("80 mm") + bearing("left", left) +
                             bearing("right", right));
    };
    const auto rating = [&](const std::string& teeth) {
      return mode_of(with(teeth, "10000 h", "10000 h"), "rating", "pitting_1");
    };
    CHECK(rating("") == "pass");
    CHECK(rating("L_h = \"10000 h\"\n") == "pass");
    CHECK(rating("L_h = \"20000 h\"\n") == "pass");
    CHECK(rating("L_h = \"500 h\"\n") == "not-judged");
    CHECK(rating("L_h = \"500 h\"\nbecause.L_h = \"exchanged every month\"\n") == "pass");
    const project::Project unequal = with("", "1500 h", "10000 h");
    CHECK(mode_of(unequal, "left", "fatigue") == "not-judged");
    CHECK(mode_of(unequal, "right", "fatigue") == "pass");
    // Loads computed from one of [values] do not make one machine of two.
    const std::string two =
        "[values]\nF = \"1 kN\"\n[a]\ncalculator = \"bearing.rolling\"\nF_r = \"=2*values.F\"\nn = \"500 rpm\"\n"
        "kind = \"deep_groove_ball\"\nC = \"42.3 kN\"\nC_0 = \"24 kN\"\nL_h = \"1500 h\"\n[b]\ncalculator = "
        "\"bearing.rolling\"\nF_r = \"=3*values.F\"\nn = \"500 rpm\"\nkind = \"deep_groove_ball\"\nC = \"42.3 kN\"\n"
        "C_0 = \"24 kN\"\nL_h = \"5000 h\"\n";
    CHECK(mode_of(solved_as_found(two), "a", "fatigue") == "pass");
  }

  TEST_CASE("each planet loads the teeth of the sun once per revolution") {
    const std::string set = R"([set]
calculator = "gear.planetary"
z_s = 24
z_p = 30
N_p = 3
fixed = "ring"
n_s = "1450 rpm"
T_s = "300 N*m"
m_n = "3 mm"
K_gamma = 1.1
[sun]
calculator = "gear.pair"
pair = "=set.sun_mesh"
b = "40 mm"
)";
    const auto with = [&](const std::string& lines) {
      return pitting(set + rated(midway + lines, "mesh = \"=sun.mesh\"\n"));
    };
    CHECK(with("") == "pass");  // endurance
    CHECK(with("L_h = \"2000 h\"\n") == "not-judged");
    CHECK(with("L_h = \"2000 h\"\nq_1 = 2\n") == "not-judged");
    CHECK(with("L_h = \"2000 h\"\nq_1 = 3\n") == "pass");
  }

  TEST_CASE("load cycles per revolution count like a longer life") {
    const auto limit = [](const std::string& lines) {
      const project::Project project = solved_as_found(gears + rated(midway + lines));
      const Value* const found = project.value("rating.sigma_HG1");
      REQUIRE(found != nullptr);
      return found->si.front();
    };
    CHECK(limit("L_h = \"300 h\"\nq_1 = 3\n") == doctest::Approx(limit("L_h = \"900 h\"\n")).epsilon(1e-12));
    CHECK(limit("L_h = \"300 h\"\nq_1 = 3\n") < limit("L_h = \"300 h\"\n"));
  }
}
