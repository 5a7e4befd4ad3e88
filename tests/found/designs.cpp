// Single designs that an engineer must reject, found by use: sizes that do not fit, searches without a result, factors
// that a load lost. Each kind with a sound neighbour.
#include "lib/account/conclusion.hpp"
#include "tests/found/modes.hpp"

#include <cmath>

using namespace loadpath;
using namespace loadpath::test;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string screw(const std::string& lines) {
  return "[p]\ncalculator = \"shaft.set_screw\"\nload_case = \"static\"\nS = 2\n" + lines;
}

const std::string slider_crank_of_press = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm", positions = 90 }
loads = [{ name = "F", link = "slider", at = "B", F_x = "-10 kN", F_y = "0 N" }]
)";

const std::string nominal_pair = R"([gears]
calculator = "gear.pair"
z_1 = 20
z_2 = 60
m_n = "3 mm"
b = "40 mm"
T_1 = "110 N*m"
n_1 = "1000 rpm"
K_A = 1.75
K_f = 1.2
cutting = "hobbed"
sigma_adm_1 = "400 MPa"
sigma_adm_2 = "400 MPa"
x_1 = 0.2
x_2 = 0.1
)";

std::string keyed(const std::string& lines) {
  return nominal_pair +
         "[k]\ncalculator = \"shaft.key\"\ntorque = \"one_way\"\nd = \"50 mm\"\nkey = \"14x9\"\nl = \"45 mm\"\n"
         "l_n = \"50 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"200 MPa\"\nR_e_k = \"420 MPa\"\n" +
         lines;
}

std::string two_pairs(const std::string& lines) {
  return R"([first]
calculator = "gear.pair"
z_1 = 20
z_2 = 40
m_n = "3 mm"
b = "40 mm"
T_1 = "110 N*m"
n_1 = "1000 rpm"
K_f = 1.2
cutting = "hobbed"
sigma_adm_1 = "230 MPa"
sigma_adm_2 = "165 MPa"
x_1 = 0.2
x_2 = 0.1
[second]
calculator = "gear.pair"
z_2 = 60
x_2 = 0.1
m_n = "3 mm"
b = "40 mm"
K_f = 1.2
cutting = "hobbed"
sigma_adm_1 = "165 MPa"
sigma_adm_2 = "165 MPa"
)" + lines;
}

}  // namespace

TEST_SUITE("found sizes") {
  TEST_CASE("G3: a set screw that is too thick for its shaft, and a torque that shears the shaft") {
    const auto large = solved_as_found(screw("T = \"40 N*m\"\nset_screw = \"1\"\nd = \"8 mm\"\n"));
    CHECK(mode_of(large, "p", "slip") == "not-covered");
    CHECK(mode_of(large, "p", "core") == "not-judged");
    // 16 T/(pi d^3) = 75 MPa of 40 N m at 14 mm, by Mises 130 MPa
    const std::string thin =
        "T = \"40 N*m\"\nset_screw = \"1/4\"\nd = \"14 mm\"\ni = 2\nphi = 0.9\nS_F = 1.5\nR_e_1 = ";
    CHECK(mode_of(solved_as_found(screw(thin + "\"120 MPa\"\n")), "p", "core") == "fail");
    CHECK(mode_of(solved_as_found(screw(thin + "\"235 MPa\"\n")), "p", "core") == "pass");
    CHECK(mode_of(solved_as_found(screw("T = \"8 N*m\"\nset_screw = \"3/8\"\nd = \"20 mm\"\n")), "p", "core") ==
          "open");
  }

  TEST_CASE("a key, a press fit: the shaft itself carries the torque or fails") {
    // 4 kN m in the 44.5 mm inside of the seat: 231 MPa, by Mises 400 MPa
    CHECK(mode_with("shaft.key", "T = \"4 kN*m\"\nK_A = 1", "core") == "fail");
    CHECK(mode_with("shaft.key", "", "core") == "pass");
    CHECK(mode_with("shaft.press_fit", "T = \"10 kN*m\"", "core") == "fail");
    CHECK(mode_with("shaft.press_fit", "", "core") == "pass");
  }

  TEST_CASE("a non-standard key that is as wide as its shaft does not belong to it") {
    const std::string typed = "key = \nb = \"40 mm\"\nh = \"22 mm\"\nt_1 = \"13 mm\"\nt_2 = \"9.4 mm\"";
    CHECK(mode_with("shaft.key", typed, "fit") == "not-covered");
    CHECK(mode_with("shaft.key", "key = \nb = \"14 mm\"\nh = \"9 mm\"\nt_1 = \"5.5 mm\"\nt_2 = \"3.8 mm\"", "fit") ==
          "pass");
    CHECK(mode_with("shaft.spline", "spline = \nz = 8\nd_1 = \"20 mm\"\nd_2 = \"60 mm\"\nb = \"5 mm\"", "form") ==
          "not-covered");
  }

  TEST_CASE("G6: a shallow dish bends: membrane stresses do not apply") {
    const std::string dish =
        "[lid]\ncalculator = \"vessel.shell\"\np = \"0.1125 MPa\"\nsigma_adm = \"140 MPa\"\ndelta = \"4.5 mm\"\n";
    const auto flat = solved_as_found(
        dish +
        "points = [[\"0 mm\", \"0 mm\"], [\"100 mm\", \"0.5 mm\"], [\"200 mm\", \"2 mm\"], [\"300 mm\", \"4.5 mm\"]]");
    CHECK(mode_of(flat, "lid", "strength") == "not-covered");
    CHECK(mode_with("vessel.shell", "", "strength") == "pass");
    CHECK(mode_with("vessel.cone", "alpha = \"75 deg\"\nh_l = \"0.2 m\"\ndelta = \"40 mm\"", "strength") ==
          "not-covered");
  }

  TEST_CASE("F7: flat ends of a cylinder are assessed where their thickness is given") {
    // 1.24 p (R/t)^2 with p 1.6 MPa, 604 mm and 9 mm: 8.9 GPa
    CHECK(mode_with("vessel.cylinder", "delta = \"12 mm\"\ndelta_e = \"10 mm\"", "ends") == "fail");
    CHECK(mode_with("vessel.cylinder", "delta_e = \"10 mm\"", "ends") == "not-available");  // with no wall
    CHECK(mode_with("vessel.cylinder", "delta_e = \"80 mm\"", "ends") == "pass");
    CHECK(mode_with("vessel.cylinder", "", "ends") == "open");
  }

  TEST_CASE("F15: the rim between the root of a gear and its bore") {
    CHECK(mode_of(solved_as_found(nominal_pair + "bore_1 = \"45 mm\"\nt_k1 = \"3.8 mm\"\n"), "gears", "rim_1") ==
          "not-covered");
    CHECK(mode_of(solved_as_found(nominal_pair + "bore_1 = \"25 mm\"\nt_k1 = \"3.3 mm\"\n"), "gears", "rim_1") ==
          "pass");
    CHECK(mode_of(solved_as_found(nominal_pair), "gears", "rim_1") == "open");
  }
}

TEST_SUITE("found searches") {
  TEST_CASE("C2: below the limit of Euler's formula there is no size") {
    const std::string bar =
        "[c]\ncalculator = \"column.buckling\"\nP = \"149 kN\"\nl = \"840 mm\"\nd = \"?\"\nE = \"210 GPa\"\nn_st = "
        "3.5\n"
        "ends = \"pinned_pinned\"\n";
    const auto project = solved_as_found(bar + "method = \"euler\"\nsigma_P = \"290 MPa\"\n");
    CHECK(mode_of(project, "c", "buckling") == "not-available");
    const account::Mode& inputs = project.steps[0]->account().modes.front();
    CHECK(inputs.id == "search");
    CHECK(account::conclude(project::modes(project)).headline == account::Headline::no_solution);
    // pi sqrt(E/sigma_P) = 84.54; 840 mm over 40 mm/4 is 84
    CHECK_MESSAGE(holds(inputs.note.text(), "nearest is 40 mm: r_1 = 1.006"), inputs.note.text());
    CHECK(holds(inputs.note.text(), "johnson"));
    const auto found = solved_as_found(bar + "method = \"johnson\"\nR_e = \"355 MPa\"\n");
    CHECK(mode_of(found, "c", "buckling") == "pass");
  }

  TEST_CASE("C3: a thick wall is not a size of a thin-walled vessel, and nothing is passed on") {
    const auto project = solved_as_found(
        "[v]\ncalculator = \"vessel.cylinder\"\nR = \"80 mm\"\nmeasured = \"inner\"\np = \"40 MPa\"\n"
        "sigma_adm = \"120 MPa\"\nhypothesis = \"membrane\"\n"
        "[w]\ncalculator = \"vessel.sphere\"\nR = \"800 mm\"\np = \"1 MPa\"\nsigma_adm = \"120 MPa\"\ndelta = "
        "\"=v.delta\"\n");
    CHECK(mode_of(project, "v", "strength") == "not-available");
    CHECK(mode_of(project, "w", "strength") == "not-available");
  }

  TEST_CASE("Q1: the rating of one chain is refused while the chain is searched for") {
    const std::string chain =
        "[c]\ncalculator = \"chain.roller\"\nz_1 = 21\nz_2 = 57\nP = \"8 kW\"\nn_1 = \"1000 rpm\"\nK_A = 1.75\n"
        "a = \"1 m\"\np_adm = \"45 MPa\"\nS_min = 7\nlubrication = \"bath\"\n";
    CHECK(holds(first_error_of(chain + "chain = \"?\"\nP_R = \"60 kW\"\n"), "'P_R' is given"));
    CHECK(first_error_of(chain + "chain = \"16B\"\nP_R = \"60 kW\"\n").empty());
  }

  TEST_CASE("Q3: no belt is wider than its pulleys, typed or found") {
    const std::string belt =
        "[b]\ncalculator = \"belt.flat\"\nK_A = 1.2\nn_1 = \"1450 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"500 mm\"\nmu = 0.4\n"
        "kind = \"synthetic\"\ndelta = \"2.5 mm\"\nrho = \"1100 kg/m^3\"\nsigma_adm = \"6 MPa\"\nE_b = \"40 MPa\"\n"
        "a = \"1200 mm\"\n";
    CHECK(mode_of(solved_as_found(belt + "P = \"500 kW\"\n"), "b", "strength") == "not-available");
    CHECK(mode_of(solved_as_found(belt + "P = \"500 kW\"\nb = \"4500 mm\"\n"), "b", "width") == "not-covered");
    CHECK(mode_of(solved_as_found(belt + "P = \"15 kW\"\n"), "b", "width") == "pass");
  }
}

TEST_SUITE("found factors") {
  TEST_CASE("the parts of one drive carry its loads with one application factor, by whichever way it is given") {
    const auto drive = [](const std::string& own, const std::string& other) {
      return "[values]\nlow = 1\n[train]\ncalculator = \"drive.train\"\nP = \"2 kW\"\nn_1 = \"1450 rpm\"\n"
             "stages = [{ name = \"g\", z_1 = 20, z_2 = 80, m_n = \"3 mm\", eta = 0.97 }, { name = \"c\", kind = "
             "\"chain\", "
             "z_1 = 21, z_2 = 57, p = \"25.4 mm\", eta = 0.96 }]\n[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 80\n"
             "m_n = \"3 mm\"\nb = \"20 mm\"\nT_1 = \"=train.shafts[1].T\"\nn_1 = \"=train.shafts[1].n\"\nK_f = 1.5\n"
             "cutting = \"hobbed\"\nsigma_adm_1 = \"67 MPa\"\nsigma_adm_2 = \"67 MPa\"\n" +
             own +
             "[o]\ncalculator = \"section.circle\"\nd = \"2 mm\"\n[c]\ncalculator = \"chain.roller\"\nchain = \"16B\"\n"
             "z_1 = 21\nz_2 = 57\na = \"1 m\"\nn_1 = \"=abs(train.shafts[2].n)\"\nT_1 = "
             "\"=abs(train.shafts[2].T)\"\np_adm = \"35 MPa\"\nS_min = 7\nK_A = " +
             other + "\n";
    };
    for (const char* other : {"1.8", "\"=1.8*values.low\"", "\"=1.8*o.d/o.d\""}) {
      for (const char* own : {"", "K_A = 1\n", "K_A = \"=values.low\"\n"}) {
        CAPTURE(other);
        CAPTURE(own);
        CHECK(mode_of(solved_as_found(drive(own, other)), "g", "root_1") == "not-judged");
      }
    }
    const std::string because = "K_A = 1\nbecause.K_A = \"a soft coupling\"\n";
    CHECK(mode_of(solved_as_found(drive(because, "1.8")), "g", "root_1") == "pass");
    CHECK(mode_of(solved_as_found(drive("K_A = 1.8\n", "1.8")), "g", "root_1") == "fail");
  }

  TEST_CASE("a load that is a fixed fraction of another needs a reason, however the fraction is written") {
    const auto rod = [](const std::string& N) {
      return "[values]\npart = 0.3\nbars = 4\n" + slider_crank_of_press +
             "[rod]\ncalculator = \"column.buckling\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nR_e = \"355 MPa\"\n"
             "method = \"johnson\"\nn_st = 3\nn_t = 1.5\nl = \"200 mm\"\nd = \"9 mm\"\n" +
             N;
    };
    for (const char* N : {"0.3*press.links.rod.N", "values.part*press.links.rod.N",
                          "press.links.rod.N - 0.7*press.links.rod.N", "press.links.rod.N/values.bars"}) {
      CAPTURE(N);
      const std::string line = std::string("N = \"=") + N + "\"\n";
      CHECK(mode_of(solved_as_found(rod(line)), "rod", "buckling") == "not-judged");
      CHECK(mode_of(solved_as_found(rod(line + "because.N = \"parallel bars\"\n")), "rod", "buckling") != "not-judged");
    }
    CHECK(mode_of(solved_as_found(rod("N = \"=press.links.rod.N\"\n")), "rod", "buckling") == "fail");
  }

  TEST_CASE("a start counts for the key in whichever way it is given, and T_max may include it") {
    const auto shaft = [](const std::string& k_max, const std::string& T_max) {
      return "[values]\nk = 2\n[other]\ncalculator = \"section.circle\"\nd = \"20 mm\"\n[key]\ncalculator = "
             "\"shaft.key\"\nT = \"90 N*m\"\ntorque = \"one_way\"\nd = \"45 mm\"\nkey = \"14x9\"\nl = \"63 mm\"\n"
             "R_e_1 = \"370 MPa\"\nS_F = 1.5\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\n" +
             T_max + "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\nn = \"300 rpm\"\nk_max = " + k_max +
             "\npieces = [{ l = \"80 mm\", d = \"45 mm\" }, { l = \"120 mm\", d = \"50 mm\" }]\n"
             "supports = [{ x = \"100 mm\", holds = \"both\" }, { x = \"180 mm\" }]\n"
             "seats = [{ name = \"hub\", x = \"40 mm\", T = \"90 N*m\", connection = "
             "\"=key.connection\" }, { "
             "x = \"150 mm\", way = \"balances\", integral = true }]\n";
    };
    for (const char* k_max : {"2", "\"=2\"", "\"=values.k\"", "\"=2*other.d/other.d\""}) {
      CAPTURE(k_max);
      CHECK(mode_of(solved_as_found(shaft(k_max, "")), "key", "core") == "not-judged");
    }
    CHECK(mode_of(solved_as_found(shaft("2", "T_max = \"180 N*m\"\n")), "key", "core") == "pass");
  }

  TEST_CASE("K1: a nominal torque of gears that have a K_A is not the torque of a key") {
    const auto bare = solved_as_found(keyed("T = \"=gears.T_2\"\n"));
    for (const char* id : {"shaft", "hub", "key", "shear"}) CHECK(mode_of(bare, "k", id) == "not-judged");
    CHECK(mode_of(bare, "k", "fit") == "pass");
    CHECK(mode_of(solved_as_found(keyed("T = \"=gears.T_2\"\nK_A = 1.75\n")), "k", "hub") == "fail");
    CHECK(mode_of(solved_as_found(keyed("T = \"=gears.K_A*gears.T_2\"\n")), "k", "hub") == "fail");
    CHECK(mode_of(solved_as_found(keyed("load = \"=gears.gear_2\"\n")), "k", "hub") == "fail");
    CHECK(mode_of(solved_as_found(keyed("T = \"=gears.T_2\"\nK_A = 1\n")), "k", "shaft") == "not-judged");
    const std::string because = "because.K_A = \"a slip clutch limits it\"\n";
    CHECK(mode_of(solved_as_found(keyed("T = \"=gears.T_2\"\nK_A = 1\n" + because)), "k", "shaft") == "pass");
  }

  TEST_CASE("K1: it is lost in an intermediate step, too") {
    const auto project = solved_as_found(nominal_pair +
                                         "[train]\ncalculator = \"drive.train\"\nT_1 = \"=gears.T_2\"\n"
                                         "stages = [{ kind = \"gear\", i = 2, eta = 0.97 }]\n"
                                         "[axle]\ncalculator = \"shaft.torsion\"\nT = \"=abs(train.T_out)\"\n"
                                         "d = \"80 mm\"\ntau_adm = \"30 MPa\"\n");
    CHECK(mode_of(project, "axle", "yield") == "not-judged");
  }

  TEST_CASE("K3: a gear that is also the pinion of the next pair has teeth bent both ways") {
    const std::string torque = "T_1 = \"=abs(first.T_2)\"\nn_1 = \"=abs(first.n_2)\"\n";
    const auto idler = solved_as_found(two_pairs(torque + "z_1 = \"=first.z_2\"\nx_1 = \"=first.x_2\"\n"));
    CHECK(mode_of(idler, "first", "root_2") == "fail");
    CHECK(mode_of(idler, "second", "root_1") == "fail");
    CHECK(mode_of(idler, "first", "root_1") == "pass");
    const auto apart = solved_as_found(two_pairs(torque + "z_1 = 40\nx_1 = 0.1\nidler = \"none\"\n"));
    CHECK(mode_of(apart, "second", "root_1") == "pass");
    CHECK(holds(first_error_of(two_pairs(torque + "z_1 = \"=first.z_2\"\nidler = \"none\"\n")),
                "reversed tooth bending"));
    const std::string same_gear = "the same module and number of teeth";
    for (const char* teeth : {"z_1 = 40\n", "z_1 = \"=40\"\n", "z_1 = \"=2*20\"\n"})
      CHECK(holds(first_error_of(two_pairs(torque + teeth)), same_gear));
    // The speed alone or the torque alone says which pair drives.
    CHECK(holds(first_error_of(two_pairs("T_1 = \"50 N*m\"\nn_1 = \"=abs(first.n_2)\"\nz_1 = 40\n")), same_gear));
    CHECK(holds(first_error_of(two_pairs("T_1 = \"=abs(first.T_2)\"\nn_1 = \"500 rpm\"\nz_1 = 40\n")), same_gear));
  }

  TEST_CASE("F13: factors that are not plausible for any machine are refused") {
    CHECK(holds(first_error_of(keyed("T = \"100 N*m\"\nK_A = 0.001\n")), "K_A = 0.001"));
    CHECK(holds(first_error_of("[c]\ncalculator = \"column.buckling\"\nl = \"3 m\"\nd = \"40 mm\"\nbeta_y = 0\n"),
                "beta_y = 0"));
  }

  TEST_CASE("F3: a worm without losses, or almost without, is not assessed") {
    const auto worm = [](const std::string& eta) {
      return mode_with("drive.train", "stages = [{ kind = \"worm\", z_1 = 2, z_2 = 40" + eta + " }]", "efficiency");
    };
    CHECK(worm("") == "not-covered");
    CHECK(worm(", eta = 0.99") == "not-covered");
    CHECK(worm(", eta = 0.73") == "pass");
  }

  TEST_CASE("F2: a pulley driven by the back of a V-belt has its own friction") {
    const auto course = [](const std::string& mu) {
      return "[c]\ncalculator = \"belt.course\"\nn_1 = \"1450 rpm\"\nmu = 1.5\nS_adm = \"2 kN\"\nq = \"0.2 kg/m\"\n"
             "S_0 = \"100 N\"\nturns = \"cw\"\npulleys = [\n"
             "{ name = \"motor\", x = \"0 mm\", y = \"0 mm\", d = \"160 mm\" },\n"
             "{ name = \"roller\", x = \"60 mm\", y = \"280 mm\", d = \"80 mm\", side = \"outside\", P = \"4 kW\"" +
             mu + " },\n{ name = \"fan\", x = \"300 mm\", y = \"480 mm\", d = \"200 mm\", P = \"1 kW\" }]\n";
    };
    CHECK(holds(first_error_of(course("")), "its friction is different"));
    CHECK(mode_of(solved_as_found(course(", mu = 0.3")), "c", "grip") == "fail");
  }
}

TEST_SUITE("found columns and bearings") {
  TEST_CASE("F17, C7: missing input of a method is reported all at once") {
    const std::string bar =
        "[c]\ncalculator = \"column.buckling\"\nP = \"100 kN\"\nl = \"3 m\"\nends = \"pinned_pinned\"\n"
        "section = \"HEA 140\"\nmaterial = \"S235JR\"\n";
    CHECK(first_error_of(bar).empty());                         // a section of the tables goes by EN 1993-1-1
    CHECK(first_error_of(bar + "method = \"ec3\"\n").empty());  // its factors are assumed, with a warning
    const std::string both = first_error_of(bar + "method = \"euler\"\n");
    CHECK_MESSAGE(holds(both, "sigma_P"), both);
    CHECK_MESSAGE(holds(both, "n_st"), both);
  }

  TEST_CASE("F10, F11: a link in tension needs no buckling method, slenderness alone needs no material") {
    const auto tie = solved_as_found(
        "[t]\ncalculator = \"link.member\"\nN = \"50 kN\"\nV = \"0 kN\"\nM_b = \"0 N*m\"\nl = \"1 m\"\nh = \"30 mm\"\n"
        "b = \"15 mm\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nR_e = \"235 MPa\"\nS = 1.5\n");
    CHECK(mode_of(tie, "t", "yield") == "pass");
    CHECK(mode_of(tie, "t", "buckling") == "none");
    const auto bar = solved_as_found(
        "[c]\ncalculator = \"column.buckling\"\nl = \"1 m\"\nd = \"40 mm\"\nends = \"pinned_pinned\"\n");
    CHECK(bar.value("c.lambda")->si[0] == doctest::Approx(100.0));
  }

  TEST_CASE("C6: the web of a rolled section carries the shear, and a given S is used") {
    const auto link = solved_as_found(
        "[t]\ncalculator = \"link.member\"\nN = \"50 kN\"\nV = \"5 kN\"\nM_b = \"3 kN*m\"\nl = \"1.6 m\"\n"
        "section = \"IPE 120\"\nends = \"pinned_pinned\"\nmaterial = \"S355\"\nmethod = \"ec3\"\ngamma_M1 = 1.1\n"
        "gamma_F = 1\nS = 1.5\n");
    CHECK(mode_of(link, "t", "shear") == "pass");
    // IPE 120: (120 - 2 x 6.3) x 4.4 = 472.6 mm^2
    CHECK(link.value("t.tau")->si[0] / 1e6 == doctest::Approx(5000.0 / 472.56).epsilon(1e-3));
    for (const account::Mode& mode : project::modes(link)) CHECK(mode.wants != "S");
  }

  TEST_CASE("F6: the walls of a W16X36 by AISC 360, E7: the full area counts up to 60.0") {
    const auto bar = solved_as_found(
        "[c]\ncalculator = \"column.buckling\"\nsection = \"W16X36\"\nl = \"15 ft\"\nbeta_y = 0.6667\nbeta_z = 1\n"
        "P = \"100 kip\"\nE = \"29000 ksi\"\nR_e = \"50 ksi\"\nmethod = \"aisc\"\n");
    CHECK(mode_of(bar, "c", "local") == "pass");
    CHECK(bar.value("c.r_class")->si[0] == doctest::Approx(48.1 / 60.0).epsilon(0.01));
  }

  TEST_CASE("F10: a life in revolutions needs no speed; without either the bearing is not assessed") {
    const std::string ball =
        "[b]\ncalculator = \"bearing.rolling\"\nkind = \"deep_groove_ball\"\nC = \"29.1 kN\"\nC_0 = \"17.9 kN\"\n"
        "F_r = \"4 kN\"\ns_0 = 1\n";
    // (29.1/4)^3 = 385 millions
    CHECK(mode_of(solved_as_found(ball + "L_m = 300\n"), "b", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(ball + "L_m = 500\n"), "b", "fatigue") == "fail");
    CHECK(mode_of(solved_as_found(ball), "b", "fatigue") == "not-judged");
  }
}
