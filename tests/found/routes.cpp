// Values that reach a step by another path than the checked one: a size, a speed, a sign, a factor.
#include "tests/found/modes.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string thin_shaft =
    "[shaft]\ncalculator = \"shaft.torsion\"\nT = \"200 N*m\"\ntau_adm = \"40 MPa\"\nd = \"30 mm\"\n\n";

std::string key_on(const std::string& T, const std::string& d, const std::string& more = "") {
  return "[key]\ncalculator = \"shaft.key\"\nT = \"" + T + "\"\ntorque = \"one_way\"\nd = \"" + d +
         "\"\nkey = \"14x9\"\nl = \"70 mm\"\nl_n = \"75 mm\"\nR_e_1 = \"370 MPa\"\nR_e_2 = \"300 MPa\"\n"
         "R_e_k = \"420 MPa\"\n" +
         more;
}

const std::string press = R"([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "400 mm"
crank = { speed = "60 rpm", positions = 90 }
loads = [{ name = "F", link = "slider", at = "B", F_x = "-12 kN", F_y = "0 N" }]

)";

std::string rod_with(const std::string& N, const std::string& more = "") {
  return press + "[rod]\ncalculator = \"column.buckling\"\nN = \"" + N +
         "\"\nl = \"400 mm\"\nd = \"30 mm\"\nends = \"pinned_pinned\"\nmaterial = \"S355\"\nmethod = \"johnson\"\n"
         "n_st = 2\nn_t = 1.5\n" +
         more;
}

}  // namespace

TEST_SUITE("found routes") {
  TEST_CASE("a key for a thicker shaft than the one whose torque it takes needs a reason") {
    CHECK(mode_of(solved_as_found(thin_shaft + key_on("=shaft.T", "50 mm")), "key", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(thin_shaft + key_on("=shaft.M_max", "50 mm")), "key", "hub") == "not-judged");
    CHECK(mode_of(solved_as_found(thin_shaft + key_on("200 N*m", "50 mm")), "key", "hub") == "pass");
    const std::string reason = "because.d = \"on the flange of the next shaft\"\n";
    CHECK(mode_of(solved_as_found(thin_shaft + key_on("=shaft.T", "50 mm", reason)), "key", "hub") == "pass");
  }

  TEST_CASE("a bearing that turns slower than the shaft whose force it takes needs a reason") {
    const auto bearing = [](const std::string& n) {
      return "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\nn = \"1450 rpm\"\n"
             "pieces = [{ l = \"300 mm\", d = \"40 mm\" }]\n"
             "supports = [{ name = \"left\", x = \"20 mm\", holds = \"both\" }, { name = \"right\", x = \"280 mm\" }]\n"
             "seats = [{ name = \"load\", x = \"150 mm\", F_x = \"4 kN\" }]\nS_F = 1.5\n\n"
             "[left]\ncalculator = \"bearing.rolling\"\nF_r = \"=shaft.bearings.left.F_r\"\n"
             "kind = \"deep_groove_ball\"\nC = \"29.1 kN\"\nC_0 = \"17.9 kN\"\nf_0 = 14\nL_h = \"5000 h\"\ns_0 = 1\n"
             "n = \"" +
             n + "\"\n";
    };
    CHECK(mode_of(solved_as_found(bearing("10 rpm")), "left", "fatigue") == "not-judged");
    CHECK(mode_of(solved_as_found(bearing("1450 rpm")), "left", "fatigue") == "pass");
    CHECK(mode_of(solved_as_found(bearing("1450 rpm")), "shaft", "bearings") == "not-judged");  // the right one
  }

  TEST_CASE("a service load is not that of a start") {
    const auto ring = [](const std::string& F, const std::string& k_max) {
      return "[shaft]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\nn = \"100 rpm\"\n"
             "pieces = [{ l = \"200 mm\", d = \"18 mm\" }]\n"
             "supports = [{ name = \"left\", x = \"45 mm\", holds = \"both\" }, { name = \"right\", x = \"185 mm\" }]\n"
             "seats = [{ name = \"load\", x = \"100 mm\", F_x = \"50 N\", F_z = \"0.5 kN\" }]\nS_F = 1.2\n" +
             k_max +
             "\n[ring]\ncalculator = \"shaft.circlip\"\ncirclip = \"18x1.2\"\nw = \"3 mm\"\nR_e = \"370 MPa\"\n"
             "c = \"1 mm\"\nF_a = \"" +
             F + "\"\n";
    };
    const std::string start = "k_max = 4\n";
    const auto groove = [&](const std::string& F, const std::string& k_max) {
      return mode_of(solved_as_found(ring(F, k_max)), "ring", "groove");
    };
    CHECK(groove("=shaft.bearings.left.F_a", "") == "pass");
    CHECK(groove("=shaft.bearings.left.F_a", start) == "not-judged");
    CHECK(groove("=shaft.bearings.left.F_a0", start) == "pass");
    CHECK(groove("=shaft.k_max*shaft.bearings.left.F_a", start) == "pass");
  }

  TEST_CASE("the negative of a force of a link is tension for compression") {
    CHECK(mode_of(solved_as_found(rod_with("=press.links.rod.N")), "rod", "buckling") == "pass");
    for (const char* N : {"=-press.links.rod.N", "=-1.2*press.links.rod.N"})
      CHECK(mode_of(solved_as_found(rod_with(N)), "rod", "tension") == "not-judged");
    const std::string reason = "because.N = \"the force on the other half of the bar\"\n";
    CHECK(mode_of(solved_as_found(rod_with("=-press.links.rod.N", reason)), "rod", "tension") == "pass");
  }

  TEST_CASE("a plate on edge buckles laterally, also if given by its second moments") {
    const auto beam = [](const std::string& b) {
      return "[r]\ncalculator = \"section.rectangle\"\nh = \"200 mm\"\nb = \"" + b +
             "\"\n\n[beam]\ncalculator = \"link.member\"\nN = \"0 kN\"\nV = \"1 kN\"\nM_b = \"5 kN*m\"\nl = \"3 m\"\n"
             "A = \"=r.A\"\nI_y = \"=r.I_y\"\nI_z = \"=r.I_z\"\nc_y = \"100 mm\"\nA_v = \"600 mm^2\"\n"
             "ends = \"pinned_pinned\"\nmaterial = \"S235JR\"\nmethod = \"johnson\"\nn_st = 2\nS = 1.2\n";
    };
    CHECK(mode_of(solved_as_found(beam("5 mm")), "beam", "lateral_torsional") == "not-judged");
    CHECK(mode_of(solved_as_found(beam("150 mm")), "beam", "lateral_torsional") == "open");
  }

  TEST_CASE("a modulus of another metal contradicts the material, one of another book does not") {
    const std::string shaft =
        "[s]\ncalculator = \"shaft.torsion\"\nT = \"90 N*m\"\nmaterial = \"C45E\"\nS = 2\n"
        "theta_adm = \"0.25 deg/m\"\n";
    CHECK(first_error_of(shaft + "G = \"26 GPa\"\n").find("contradicts the material") != std::string::npos);
    CHECK(first_error_of(shaft + "G = \"79 GPa\"\n") == "");
  }

  TEST_CASE("strengths of a press fit above its material need a reason") {
    CHECK(mode_with("shaft.press_fit", "material = \"S235JR\"\nR_e_1 = \"900 MPa\"\nR_e_2 = \"900 MPa\"", "hub") ==
          "not-judged");
  }

  TEST_CASE("forces of teeth are nominal whichever way they are taken") {
    const std::string gears =
        "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nT_1 = \"60 N*m\"\nb = \"25 mm\"\n"
        "K_A = 2\n\n";
    for (const char* T : {"=gears.F_t*gears.d_1/2", "=gears.F_bn*gears.d_1/2"}) {
      const auto project = solved_as_found(gears + "[s]\ncalculator = \"shaft.torsion\"\nT = \"" + T +
                                           "\"\ntau_adm = \"30 MPa\"\nd = \"25 mm\"\n");
      CHECK(mode_of(project, "s", "yield") == "not-judged");
    }
  }

  TEST_CASE("teeth whose torque comes from a rotating part have a dynamic load, with or without a speed") {
    const std::string train =
        "[t]\ncalculator = \"drive.train\"\nP = \"5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ z_1 = 20, z_2 = 57 }]\n\n";
    const std::string gears =
        "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nb = \"25 mm\"\n"
        "sigma_adm_1 = \"300 MPa\"\nsigma_adm_2 = \"300 MPa\"\n";
    CHECK(mode_of(solved_as_found(train + gears + "T_1 = \"=t.shafts[1].T\"\n"), "g", "dynamic") == "not-judged");
    CHECK(mode_of(solved_as_found(gears + "T_1 = \"30 N*m\"\n"), "g", "dynamic") == "open");
  }

  TEST_CASE("a planet bends its teeth both ways, also if only its number of teeth is taken") {
    const auto project = solved_as_found(
        "[w]\ncalculator = \"gear.planetary\"\nz_s = 24\nz_p = 30\nz_r = 84\nN_p = 3\nn_s = \"100 rpm\"\nh_ar = 0.9\n\n"
        "[g]\ncalculator = \"gear.pair\"\nz_1 = \"=w.z_s\"\nz_2 = \"=w.z_p\"\nm_n = \"3 mm\"\nb = \"30 mm\"\n"
        "T_1 = \"100 N*m\"\nsigma_adm_1 = \"300 MPa\"\nsigma_adm_2 = \"300 MPa\"\n");
    CHECK(project.find("g")->word("idler") == "gear_2");
  }

  TEST_CASE("a smooth section has no notch radius") {
    CHECK(ExampleStep("fatigue.din743", "notch = \"smooth\"").fault().find("r") != std::string::npos);
  }

  TEST_CASE("an unusual value without which a check fails needs a reason, however it is given") {
    const std::string bearing =
        "[left]\ncalculator = \"bearing.rolling\"\nkind = \"tapered_roller\"\nC = \"60 kN\"\nC_0 = \"30 kN\"\n"
        "F_r = \"4 kN\"\ne = 0.4\nY = 1.5\nn = \"10 rpm\"\nn_max = \"8500 rpm\"\nL_h = \"100 h\"\ns_0 = 3\n";
    const auto static_with = [&](const std::string& Y_0, const std::string& F_a, const std::string& more = "") {
      return mode_of(solved_as_found(more + bearing + "F_a = \"" + F_a + "\"\nY_0 = " + Y_0 + "\n"), "left", "static");
    };
    // P_0 = 0.5 F_r + Y_0 F_a: with 0.2, the least that is usual, 10.2 kN of 41 kN
    CHECK(static_with("0.8", "41 kN") == "fail");
    CHECK(static_with("0.001", "41 kN") == "not-judged");
    CHECK(static_with("\"=0.0005*2\"", "41 kN") == "not-judged");
    CHECK(static_with("\"=values.Y_0\"", "41 kN", "[values]\nY_0 = 0.001\n\n") == "not-judged");
    CHECK(static_with("\"=values.a/values.b\"", "41 kN", "[values]\na = \"1 N\"\nb = \"1 kN\"\n\n") == "not-judged");
    CHECK(static_with("0.001\nbecause.Y_0 = \"the maker's letter of 3 May\"", "41 kN") == "pass");
  }

  TEST_CASE("a pair of gears, a belt, a chain is the stage of the train whose torque or power it takes") {
    const auto pair = [](const std::string& z_2, const std::string& T_1) {
      return first_error_of(
          "[t]\ncalculator = \"drive.train\"\nT_1 = \"60 N*m\"\nn_1 = \"1450 rpm\"\n"
          "stages = [{ z_1 = 25, z_2 = 40 }, { z_1 = 20, z_2 = 57 }]\n\n"
          "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = " +
          z_2 + "\nm_n = \"3 mm\"\nT_1 = \"" + T_1 + "\"\n");
    };
    CHECK(pair("57", "=t.shafts[2].T").empty());
    CHECK(pair("60", "=t.shafts[2].T").find("contradicts 't.stages[2].z_2', which has 57") != std::string::npos);
    CHECK(pair("57", "=t.shafts[1].T").find("contradicts 't.stages[1].z_1', which has 25") != std::string::npos);
    CHECK(pair("60", "90 N*m").empty());

    const auto belt = [](const std::string& P) {
      return mode_of(
          solved_as_found("[t]\ncalculator = \"drive.train\"\nP = \"15 kW\"\nn_1 = \"1460 rpm\"\n"
                          "stages = [{ kind = \"belt\", d_1 = \"140 mm\", d_2 = \"280 mm\" }]\n\n"
                          "[b]\ncalculator = \"belt.v\"\nbasis = \"optibelt\"\nsection = \"SPA\"\nK_A = 1.2\n"
                          "n_1 = \"=t.n_1\"\nd_1 = \"140 mm\"\nd_2 = \"280 mm\"\nL = \"1500 mm\"\nP = \"" +
                          P + "\"\n"),
          "b", "power");
    };
    CHECK(belt("=t.P") == belt("15 kW"));
    CHECK(belt("5 kW") == "not-judged");
  }

  TEST_CASE("a gear runs at the speed of the shaft whose torque it takes") {
    const auto stress = [](const std::string& load) {
      return mode_of(
          solved_as_found(
              "[t]\ncalculator = \"drive.train\"\nP = \"15 kW\"\nn_1 = \"1460 rpm\"\n"
              "stages = [{ kind = \"gear\", i = 2.85 }, { kind = \"gear\", z_1 = 20, z_2 = 57 }]\n\n"
              "[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"4 mm\"\nb = \"60 mm\"\ncutting = "
              "\"ground\"\nK_f = 1.4\nsigma_adm_1 = \"300 MPa\"\nsigma_adm_2 = \"300 MPa\"\n" +
              load),
          "g", "root_1");
    };
    CHECK(stress("T_1 = \"=t.shafts[2].T\"\nn_1 = \"=t.shafts[2].n\"\n") == "pass");
    CHECK(stress("T_1 = \"=t.shafts[2].T\"\nn_1 = \"512.3 rpm\"\n") == "pass");
    CHECK(stress("T_1 = \"=t.shafts[2].T\"\nn_1 = \"51 rpm\"\n") == "not-judged");
    CHECK(stress("T_1 = \"=t.shafts[2].T\"\nn_1 = \"=t.shafts[3].n\"\n") == "not-judged");
    CHECK(stress("P = \"=t.P\"\nn_1 = \"512.28 rpm\"\n") == "pass");  // of the second shaft, whose power is the same
  }

  TEST_CASE("a strength ten times too high needs a reason, whatever the nearest usual value gives") {
    const auto core = [](const std::string& R_e) {
      return mode_with("shaft.torsion", "tau_adm = \nbehaviour = \nR_e = \"" + R_e + "\"\nS = 1.5", "yield");
    };
    CHECK(core("355 MPa") != "not-judged");
    CHECK(core("3550 MPa") == "not-judged");
    CHECK(core("3550 MPa\"\nbecause.R_e = \"test of the wire") == "pass");
  }

  TEST_CASE("an allowable stress by an expression is limited by the material that it refers to") {
    const auto shaft = [](const std::string& tau_adm) {
      return mode_of(solved_as_found(
                         "[tables.materials.Plate]\nsource = \"certificate\"\nE = \"210 GPa\"\nG = \"81 GPa\"\n"
                         "R_e = \"235 MPa\"\nR_m = \"400 MPa\"\n[s]\ncalculator = \"shaft.torsion\"\nT = \"4.5 kN*m\"\n"
                         "d = \"60 mm\"\ntau_adm = \"=tables.materials.Plate." +
                         tau_adm + "\"\n"),
                     "s", "yield");
    };
    CHECK(shaft("R_e") == "not-judged");
    CHECK(shaft("R_m/2") == "not-judged");
    CHECK(shaft("R_e/sqrt(3)/1.01") == "not-judged");
    CHECK(shaft("R_e/sqrt(3)/1.2") == "pass");
  }

  TEST_CASE("a bar under the force of a link is no shorter than the link") {
    const auto column = [](const std::string& l) {
      return mode_of(
          solved_as_found(
              "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
              "crank = { speed = \"60 rpm\", positions = 36 }\n"
              "loads = [{ name = \"F\", link = \"slider\", at = \"B\", F_x = \"-2 kN\", F_y = \"0 N\" }]\n\n"
              "[c]\ncalculator = \"column.buckling\"\nN = \"=press.links.rod.N\"\nd = \"12 mm\"\nends = "
              "\"pinned_pinned\"\n"
              "material = \"S355JR\"\nmethod = \"ec3\"\ngamma_M1 = 1.1\ngamma_F = 1.35\n" +
              l),
          "c", "buckling");
    };
    CHECK(column("l = \"200 mm\"\n") == "pass");
    CHECK(column("l = \"60 mm\"\n") == "not-judged");
  }

  TEST_CASE("a stage that is given by its ratio has no numbers of teeth") {
    CHECK(first_error_of(
              "[t]\ncalculator = \"drive.train\"\nP = \"5 kW\"\nn_1 = \"1450 rpm\"\n"
              "stages = [{ kind = \"gear\", i = 2.85 }]\n\n[g]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\n"
              "m_n = \"3 mm\"\nT_1 = \"=t.T_1\"\n")
              .empty());
  }

  TEST_CASE("the head of a vessel has its pressure and corrosion allowance") {
    const auto head = [](const std::string& lines) {
      return mode_of(
          solved_as_found(
              "[v]\ncalculator = \"vessel.cylinder\"\np = \"1.6 MPa\"\nR = \"600 mm\"\nmeasured = \"inner\"\n"
              "delta = \"14 mm\"\nc = \"2 mm\"\nsigma_adm = \"140 MPa\"\n\n"
              "[head]\ncalculator = \"vessel.sphere\"\nR = \"=v.R\"\nmeasured = \"inner\"\ndelta = \"8 mm\"\n"
              "sigma_adm = \"140 MPa\"\n" +
              lines),
          "head", "strength");
    };
    CHECK(head("p = \"=v.p\"\nc = \"=v.c\"\n") == "pass");
    CHECK(head("p = \"0.16 MPa\"\nc = \"2 mm\"\n") == "not-judged");
    CHECK(head("p = \"1.6 MPa\"\n") == "not-judged");  // without an allowance
    CHECK(head("p = \"1.6 MPa\"\nc = \"0 mm\"\nbecause.c = \"clad\"\n") == "pass");
  }

  TEST_CASE("an eye is not thicker than its pin joint states") {
    const auto eye = [](const std::string& t) {
      return mode_of(
          solved_as_found(
              "[pin]\ncalculator = \"pin.joint\"\nF = \"20 kN\"\nheld = \"loose\"\nloading = \"pulsating\"\n"
              "d = \"25 mm\"\nt_1 = \"20 mm\"\nt_2 = \"10 mm\"\nR_m = \"800 MPa\"\np_adm_1 = \"100 MPa\"\n"
              "p_adm_2 = \"100 MPa\"\n\n[eye]\ncalculator = \"pin.lug\"\nF = \"=pin.F_d\"\nd = \"=pin.d\"\n"
              "b = \"60 mm\"\na = \"25 mm\"\nsigma_adm = \"80 MPa\"\ntau_adm = \"60 MPa\"\np_adm = \"100 MPa\"\n"
              "t = \"" +
              t + "\"\n"),
          "eye", "net");
    };
    CHECK(eye("20 mm") == "pass");
    CHECK(eye("40 mm") == "not-judged");
  }
}
