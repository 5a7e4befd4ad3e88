// A size or a cycle by reference belongs to the part of the other step: its bore and its material go with it. And
// drives in a row, chained by their speed alone.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string hollow(const std::string& bore) {
  return "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"600 N*m\"\nd = \"50 mm\"\n" + bore +
         "material = \"C45E\"\nS = 2\n";
}

const std::string key = R"([key]
calculator = "shaft.key"
T = "=shaft.T"
torque = "one_way"
d = "=shaft.d"
key = "14x9"
l = "70 mm"
l_n = "75 mm"
R_e_1 = "370 MPa"
S_F = 1.5
R_e_2 = "370 MPa"
R_e_k = "420 MPa"
)";

const std::string cross = R"([pin]
calculator = "pin.cross"
T = "=shaft.T"
loading = "steady"
d = "12 mm"
d_w = "=shaft.d"
D = "90 mm"
R_m = "600 MPa"
p_adm_1 = "300 MPa"
p_adm_2 = "300 MPa"
tau_adm_1 = "140 MPa"
)";

const std::string rod = R"([rod]
calculator = "link.member"
N = "20 kN"
V = "0 kN"
M_b = "0 N*m"
l = "400 mm"
h = "36 mm"
b = "12 mm"
ends = "pinned_pinned"
material = "S355"
method = "johnson"
n_st = 3
S = 2
)";

std::string eye(const std::string& strength) {
  return "[eye]\ncalculator = \"pin.lug\"\nF = \"=rod.N\"\nd = \"12 mm\"\nb = \"=rod.h\"\nt = \"=rod.b\"\na = \"24 "
         "mm\"\n" +
         strength + "S = 2\np_adm = \"600 MPa\"\n";
}

std::string second_stage(const std::string& P) {
  return R"gears([first]
calculator = "gear.pair"
z_1 = 20
z_2 = 60
m_n = "3 mm"
b = "40 mm"
P = "10 kW"
n_1 = "960 rpm"
K_f = 1.5
sigma_adm_1 = "400 MPa"
sigma_adm_2 = "400 MPa"
[second]
calculator = "gear.pair"
z_1 = 20
z_2 = 60
m_n = "4 mm"
b = "60 mm"
n_1 = "=abs(first.n_2)"
K_f = 1.5
sigma_adm_1 = "400 MPa"
sigma_adm_2 = "400 MPa"
P = ")gears" +
         P + "\"\n";
}

std::string word(const std::string& text, const char* step, const char* mode) {
  return mode_of(solved_as_found(text), step, mode);
}

}  // namespace

TEST_SUITE("found same part") {
  TEST_CASE("the bore of a shaft goes with its diameter") {
    CHECK(word(hollow("") + key, "key", "shaft") == "pass");
    CHECK(word(hollow("d_bore = \"10 mm\"\n") + key, "key", "shaft") == "not-judged");
    CHECK(word(hollow("d_bore = \"10 mm\"\n") + key + "d_bore = \"=shaft.d_bore\"\n", "key", "shaft") == "pass");
    CHECK(word(hollow("d_bore = \"10 mm\"\n") + key + "because.d = \"plugged there\"\n", "key", "shaft") == "pass");
    CHECK(word(hollow("") + cross, "pin", "shaft_bore") == "pass");
    CHECK(word(hollow("d_bore = \"40 mm\"\n") + cross, "pin", "shaft_bore") == "not-judged");
  }

  TEST_CASE("the material of a rod goes with its section") {
    CHECK(word(rod + eye("material = \"S355\"\n"), "eye", "net") == "pass");
    CHECK(word(rod + eye("material = \"42CrMo4\"\n"), "eye", "net") == "not-judged");
    CHECK(word(rod + eye("R_e = \"690 MPa\"\n"), "eye", "net") == "not-judged");
    CHECK(word(rod + eye("R_e = \"300 MPa\"\n"), "eye", "net") == "pass");
  }

  TEST_CASE("the second stage at the speed of the first takes its power") {
    CHECK(word(second_stage("10 kW"), "second", "root_1") == word(second_stage("9.6 kW"), "second", "root_1"));
    CHECK(word(second_stage("9.6 kW"), "second", "root_1") == "pass");
    CHECK(word(second_stage("5 kW"), "second", "root_1") == "not-judged");
    CHECK(word(second_stage("20 kW"), "second", "root_1") != "pass");
  }
}
