// Sound designs that must not be refused or left open, each kind with an unsound neighbour that must.
#include "tests/found/modes.hpp"
#include "tests/lib/project/solved.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// Belts with a service factor of 1.2, and a stub of a shaft with the force F.
std::string stub_with(const std::string& F) {
  return R"([belts]
calculator = "belt.v"
basis = "optibelt"
section = "SPA"
P = "7.5 kW"
K_A = 1.2
n_1 = "1450 rpm"
d_1 = "118 mm"
d_2 = "236 mm"
L = "1500 mm"

[stub]
calculator = "shaft.overhung"
a = "60 mm"
T = "=belts.shaft_2.T"
sigma_adm = "60 MPa"
tau_adm = "40 MPa"
d = "40 mm"
F = ")" + F +
         "\"\n";
}

/// A slider that is pressed from one side: its rod is never pulled.
const std::string press = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "250 mm"
crank = { speed = "90 rpm", positions = 72 }
links.slider.mass = "1 kg"
loads = [{ name = "F", link = "slider", at = "B", F_x = "-6 kN", F_y = "0 N" }]

)";

std::string buckling_of(const std::string& load) {
  const std::string text = press +
                           "[bar]\ncalculator = \"column.buckling\"\nl = \"250 mm\"\nd = \"25 mm\"\nends = "
                           "\"pinned_pinned\"\nmaterial = \"C45E\"\nmethod = \"johnson\"\nn_st = 3\n" +
                           load + "\n";
  return mode_of(solved_as_found(text), "bar", "buckling");
}

std::string pin_wear(const std::string& n) {
  const std::string text = press +
                           "[pin]\ncalculator = \"pin.joint\"\nload = \"=press.joints.B\"\nheld = \"in_fork\"\nloading "
                           "= \"alternating\"\nd = \"25 mm\"\nt_1 = \"30 mm\"\nt_2 = \"12 mm\"\nc = \"0.5 mm\"\n"
                           "material = \"C45E\"\np_adm_1 = \"20 MPa\"\np_adm_2 = \"60 MPa\"\npv_adm = \"3 MPa*m/s\"\n"
                           "n = \"" +
                           n + "\"\n";
  return mode_of(solved_as_found(text), "pin", "wear");
}

/// A torque that two outputs of a shaft share.
std::string outputs_with(const std::string& T_1, const std::string& T_2, const std::string& T_in = "=sh.T") {
  const auto key = [](const std::string& name, const std::string& T) {
    return "[" + name +
           "]\ncalculator = \"shaft.key\"\ntorque = \"one_way\"\nd = \"=sh.d\"\nkey = \"14x9\"\nl = \"63 "
           "mm\"\nl_n = \"70 mm\"\nR_e_1 = \"370 MPa\"\nS_F = 1.5\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\nT = \"" +
           T + "\"\n\n";
  };
  return "[sh]\ncalculator = \"shaft.torsion\"\nT = \"400 N*m\"\nmaterial = \"C45E\"\ntau_adm = \"40 MPa\"\nd = \"45 "
         "mm\"\n\n" +
         key("in", T_in) + key("out_1", T_1) + key("out_2", T_2);
}

std::string combined_with(const std::string& tau_D) {
  return R"([limit]
calculator = "fatigue.endurance"
R_m = "470 MPa"
group = "carbon-steel"
rule = "shigley"
school = "marin"
loading = "bending"
finish = "machined"
turning = "rotating"
d = "42 mm"
P_s = 0.99

[c]
calculator = "fatigue.combined"
sigma_m = "0 MPa"
sigma_a = "60 MPa"
tau_m = "40 MPa"
tau_a = "0 MPa"
sigma_D = "=limit.sigma_D"
K_sigma = 1
R_m = "470 MPa"
R_e = "390 MPa"
S_D = 1.5
S_F = 1.5
tau_D = ")" +
         tau_D + "\"\n";
}

std::string bearing_with(const std::string& F_r, const std::string& more = "") {
  return stub_with("=belts.shaft_2.F") +
         "[bearing]\ncalculator = \"bearing.rolling\"\nkind = \"deep_groove_ball\"\nC = \"35.5 kN\"\nC_0 = \"23.2 "
         "kN\"\nf_0 = 14\nn = \"725 rpm\"\nn_max = \"10000 rpm\"\nL_h = \"20000 h\"\ns_0 = 1\nF_r = \"" +
         F_r + "\"\n" + more;
}

}  // namespace

TEST_SUITE("found sound designs") {
  TEST_CASE("a factor that a step both takes and shows is that factor") {
    CHECK(first_error_of(stub_with("=belts.K_A*900 N")) == "");
    CHECK(first_error_of(stub_with("=belts.shaft_2.F")) == "");
    CHECK(contains(first_error_of(stub_with("=belts.n_1*6 N/(1 rpm)")),
                   "'T' includes belts.K_A = 1.2, and 'F' does not"));
    CHECK(contains(first_error_of(stub_with("=belts.K_A*belts.shaft_2.F")), "K_A would be applied twice"));
  }

  TEST_CASE("one value of a compressive force is accepted like the force, if it is the largest") {
    for (const char* load :
         {"N = \"=press.links.rod.N\"", "N = \"=min(press.links.rod.N)\"", "N = \"=-max(press.joints.B.F)\"",
          "N = \"=-peak(press.links.rod.N)\"", "P = \"=max(-press.links.rod.N)\"", "P = \"=peak(press.joints.B.F)\""})
      CHECK_MESSAGE(buckling_of(load) == "pass", load);
    for (const char* load :
         {"N = \"=max(press.links.rod.N)\"", "N = \"=max(press.joints.B.F)\"", "N = \"=-min(press.joints.B.F)\"",
          "N = \"=0.5*min(press.links.rod.N)\"", "N = \"=mean(press.links.rod.N)\"", "P = \"=min(press.joints.B.F)\""})
      CHECK_MESSAGE(buckling_of(load) != "pass", load);
  }

  TEST_CASE("wear and heating of a pin follow the mean of its speed") {
    // In a turn the rod swings over 4 asin(50/250) = 46.15 deg: in the mean 90 rpm (46.15/360) = 11.54 rpm.
    CHECK(pin_wear("=mean(abs(press.joints.B.omega))") == "pass");
    CHECK(pin_wear("11.6 rpm") == "pass");
    CHECK(pin_wear("11 rpm") == "not-judged");
    CHECK(pin_wear("=abs(mean(press.joints.B.omega))") == "not-judged");
  }

  TEST_CASE("the outputs of a shaft share its torque") {
    const auto state = [](const std::string& T_1, const std::string& T_2, const std::string& T_in = "=sh.T") {
      return mode_of(solved_as_found(outputs_with(T_1, T_2, T_in)), "out_1", "key");
    };
    CHECK(state("=sh.T/2", "=sh.T/2") == "pass");
    CHECK(state("200 N*m", "=0.5*sh.T") == "pass");
    CHECK(state("=sh.T/2", "=0.3*sh.T") == "not-judged");
    CHECK(state("200 N*m", "100 N*m") == "not-judged");
    CHECK(state("=sh.T/2", "=sh.T/2", "=sh.T/2") == "not-judged");
  }

  TEST_CASE("a fatigue limit in shear by the distortion energy") {
    CHECK(first_error_of(combined_with("=0.577*limit.sigma_D")) == "");
    CHECK(first_error_of(combined_with("=0.58*limit.sigma_D")) == "");
    CHECK(contains(first_error_of(combined_with("=limit.sigma_D")), "fatigue limit of a part in shear"));
    CHECK(contains(first_error_of(combined_with("=0.7*limit.sigma_D")), "fatigue limit of a part in shear"));
  }

  TEST_CASE("a bearing takes no torque") {
    const std::string text = bearing_with("=1.4*belts.shaft_2.F");
    CHECK(mode_of(solved_as_found(text), "bearing", "other_loads") != "not-judged");
  }

  TEST_CASE("without a group the message asks for it") {
    const std::string life =
        "[life]\ncalculator = \"fatigue.life\"\nS_D = 1.3\nsigma_max = \"120 MPa\"\nsigma_min = \"0 MPa\"\nsigma_D = "
        "\"150 "
        "MPa\"\nmaterial = \"S355\"\nd_h = \"40 mm\"\n";
    CHECK(contains(first_error_of(life), "give the group, e.g. group = \"carbon-steel\""));
    CHECK(first_error_of(life + "group = \"carbon-steel\"\n") == "");
  }

  TEST_CASE("a hub as long as its key may be longer than the rim of a pulley") {
    const auto overhang = [](const std::string& l_n) {
      return mode_of(solved_as_found(stub_with("=belts.shaft_2.F") +
                                     "[key]\ncalculator = \"shaft.key\"\nT = \"=belts.shaft_2.T\"\ntorque = "
                                     "\"one_way\"\nd = \"40 mm\"\nkey = \"12x8\"\nl = \"70 mm\"\nR_e_1 = \"370 "
                                     "MPa\"\nS_F = 1.5\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\n" +
                                     l_n),
                     "key", "overhang");
    };
    CHECK(overhang("l_n = \"75 mm\"\n") == "none");
    CHECK(overhang("") == "not-judged");
  }
}
