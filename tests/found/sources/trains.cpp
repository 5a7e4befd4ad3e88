// Regression tests of trains next to the steps of their stages, and of friction wheels behind one another.
#include "tests/found/modes.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string wheels(const std::string& name, const std::string& load, const std::string& n_1) {
  return "[" + name + "]\ncalculator = \"drive.friction_wheels\"\n" + load + "\nn_1 = \"" + n_1 +
         "\"\nd_1 = \"200 mm\"\nd_2 = \"600 mm\"\nepsilon = 0.02\nb = \"80 mm\"\npair = \"leather\"\n"
         "q_adm = \"30 N/mm\"\n\n";
}

std::string train(const std::string& P, const std::string& i) {
  return "[tr]\ncalculator = \"drive.train\"\nP = \"" + P +
         "\"\nn_1 = \"700 rpm\"\nstages = [{ name = \"wheels\", kind = \"other\", i = " + i + ", eta = 0.9 }]\n\n";
}

std::string contact(const std::string& text, std::string_view step) {
  return mode_of(solved_as_found(text), step, "contact");
}

}  // namespace

TEST_SUITE("found trains") {
  TEST_CASE("friction wheels behind others take the torque of the driven wheel") {
    const std::string first = wheels("w", "P = \"1.5 kW\"\nK_A = 1.25", "700 rpm");
    CHECK(contact(first + wheels("w2", "T_1 = \"=w.shaft_2.T\"", "=w.n_2"), "w2") != "not-judged");
    CHECK(contact(first + wheels("w2", "T_1 = \"=w.shaft_1.T\"", "=w.n_2"), "w2") == "not-judged");
    CHECK(contact(first + wheels("w2", "T_1 = \"=w.shaft_1.T\"\nbecause.T_1 = \"rest drives a pump\"", "=w.n_2"),
                  "w2") != "not-judged");
  }

  TEST_CASE("friction wheels between the speeds of a stage have its power") {
    const std::string own = wheels("w", "P = \"1.5 kW\"", "700 rpm");
    CHECK(contact(own + train("15 kW", "3.0612"), "w") == "not-judged");
    CHECK(contact(own + train("1.5 kW", "3.0612"), "w") == "pass");
    CHECK(contact(own + train("15 kW", "5"), "w") == "pass");  // another machine
  }

  TEST_CASE("friction wheels with the torque of a shaft turn the next one") {
    const std::string own = wheels("w", "T_1 = \"=tr.shafts[1].T\"", "700 rpm");
    CHECK(contact(own + train("1.5 kW", "2"), "w") == "not-judged");
    CHECK(contact(own + train("1.5 kW", "3"), "w") == "pass");
  }

  TEST_CASE("a worm stage has about the efficiency of its mesh") {
    // tan(gamma) = 8/40 and mu = 0.027: by [AGMA6034] the mesh has 0.87
    const auto strength = [](const std::string& eta, const std::string& more = "") {
      return mode_of(
          solved_as_found("[x]\ncalculator = \"drive.train\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nstages = [{ name = "
                          "\"worm\", kind = \"worm\", z_1 = 2, z_2 = 40, eta = " +
                          eta + " }]\n" + more +
                          "\n[w]\ncalculator = \"gear.worm\"\nz_1 = \"=x.stages.worm.z_1\"\nz_2 = "
                          "\"=x.stages.worm.z_2\"\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 mm\"\nT_1 = "
                          "\"=x.shafts[1].T\"\nn_1 = \"=x.shafts[1].n\"\ncasting = \"chill\"\nS_Wmin = 1\n"
                          "sigma_adm = \"60 MPa\"\nA_h = \"0.25 m^2\"\ndT_adm = \"60 K\"\n"),
          "x", "strength");
    };
    CHECK(strength("0.8") == "pass");
    CHECK(strength("0.87") == "pass");
    CHECK(strength("0.5") == "not-judged");
    CHECK(strength("0.9") == "pass");  // 3 % above
    CHECK(strength("0.95") == "not-judged");
    CHECK(strength("0.5", "because.stages = \"measured with its seals\"\n") == "pass");
  }

  TEST_CASE("the efficiency of a worm stage in front of another drive is that of its mesh") {
    const auto strength = [](const std::string& eta) {
      return mode_of(
          solved_as_found(
              "[x]\ncalculator = \"drive.train\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nstages = [{ name = "
              "\"worm\", kind = \"worm\", z_1 = 2, z_2 = 40, eta = " +
              eta +
              " }, { name = \"chain\", kind = \"chain\", z_1 = 19, z_2 = 38, p = \"12.7 mm\", eta = 0.97 }]\n"
              "\n[w]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\n"
              "b_2 = \"30 mm\"\nT_1 = \"=x.shafts[1].T\"\nn_1 = \"=x.shafts[1].n\"\ncasting = "
              "\"chill\"\nS_Wmin = 1\nsigma_adm = \"60 MPa\"\nA_h = \"0.25 m^2\"\ndT_adm = \"60 K\"\n\n"
              "[sh]\ncalculator = \"shaft.torsion\"\nT = \"=x.shafts[2].T\"\nd = \"40 mm\"\ntau_adm = "
              "\"40 MPa\"\n"),
          "x", "strength");
    };
    CHECK(strength("0.87") == "open");
    CHECK(strength("0.8") == "not-judged");
  }

  TEST_CASE("a belt or a worm gear has the ratio of the stage whose load it takes") {
    const auto state = [](const std::string& stage, const std::string& step, std::string_view mode) {
      return mode_of(solved_as_found("[x]\ncalculator = \"drive.train\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\nstages = "
                                     "[{ name = \"s\", " +
                                     stage + " }]\n\n[s]\nP = \"=x.shafts[1].P\"\nn_1 = \"=x.shafts[1].n\"\n" + step),
                     "s", mode);
    };
    const std::string worm =
        "calculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = \"30 mm\"\ncasting = "
        "\"chill\"\nS_Wmin = 1\nsigma_adm = \"60 MPa\"\nA_h = \"0.25 m^2\"\ndT_adm = \"60 K\"\n";
    CHECK(state("kind = \"worm\", i = 20, eta = 0.87", worm, "wear") == "pass");
    CHECK(state("kind = \"worm\", i = 40, eta = 0.87", worm, "wear") == "not-judged");
    CHECK(state("kind = \"worm\", i = 40, eta = 0.87", worm + "because.z_2 = \"two drives in turn\"\n", "wear") ==
          "pass");
    const std::string belt =
        "calculator = \"belt.synchronous\"\nsynchronous_belt = \"H\"\nK_A = 1.5\nz_1 = 20\nz_2 = 40\na = "
        "\"500 mm\"\nb = \"50.8 mm\"\n";
    CHECK(state("kind = \"belt\", z_1 = 20, z_2 = 40, eta = 0.98", belt, "power") ==
          state("kind = \"belt\", i = 2, eta = 0.98", belt, "power"));
    CHECK(state("kind = \"belt\", d_1 = \"80 mm\", d_2 = \"240 mm\", eta = 0.98", belt, "power") == "not-judged");
  }

  TEST_CASE("of two stages of one module, the one with the larger torque is rated too") {
    const auto strength = [](const std::string& m_n, const std::string& more) {
      return mode_of(
          solved_as_found("[x]\ncalculator = \"drive.train\"\nP = \"5 kW\"\nn_1 = \"1450 rpm\"\nstages = [{ name = "
                          "\"a\", kind = \"gear\", z_1 = 20, z_2 = 60, m_n = \"3 mm\", eta = 0.97 }, { name = \"b\", "
                          "kind = \"gear\", z_1 = 20, z_2 = 60, m_n = \"" +
                          m_n +
                          "\", eta = 0.97 }]\n\n[g]\ncalculator = \"gear.pair\"\nz_1 = \"=x.stages.a.z_1\"\nz_2 = "
                          "\"=x.stages.a.z_2\"\nm_n = \"=x.stages.a.m_n\"\nb = \"40 mm\"\nT_1 = \"=x.shafts[1].T\"\n"
                          "n_1 = \"=x.shafts[1].n\"\ncutting = \"hobbed\"\nK_f = 1.6\nsigma_adm_1 = \"220 MPa\"\n"
                          "sigma_adm_2 = \"200 MPa\"\n" +
                          more),
          "x", "strength");
    };
    CHECK(strength("3 mm", "") == "not-judged");
    CHECK(strength("5 mm", "") == "open");
  }

  TEST_CASE("a train takes torque and speed of the same shaft of a worm gear") {
    const auto strength = [](const std::string& T_1, const std::string& more = "") {
      return mode_of(
          solved_as_found("[w]\ncalculator = \"gear.worm\"\nz_1 = 2\nz_2 = 40\nm_x = \"4 mm\"\nd_1 = \"40 mm\"\nb_2 = "
                          "\"30 mm\"\nP = \"0.6 kW\"\nn_1 = \"1400 rpm\"\ncasting = \"chill\"\nS_Wmin = 1\nsigma_adm "
                          "= \"60 MPa\"\nA_h = \"0.25 m^2\"\ndT_adm = \"60 K\"\n\n[x]\ncalculator = \"drive.train\"\n"
                          "T_1 = \"" +
                          T_1 +
                          "\"\nn_1 = \"=w.n_1\"\nstages = [{ name = \"c\", kind = \"chain\", z_1 = 20, z_2 = 50, p = "
                          "\"12.7 mm\", eta = 0.95 }]\n" +
                          more),
          "x", "strength");
    };
    CHECK(strength("=w.T_1") == "open");
    CHECK(strength("=w.T_2") == "not-judged");
    CHECK(strength("=w.T_2", "because.T_1 = \"at a stop\"\n") == "open");
  }

  TEST_CASE("a belt behind bevel gears takes their power, or states why not") {
    const auto power = [](const std::string& P, const std::string& more = "") {
      return mode_of(
          solved_as_found(
              "[g]\ncalculator = \"gear.bevel\"\nz_1 = 20\nz_2 = 40\nm_et = \"4 mm\"\nb = \"28 mm\"\nx_1 = "
              "0.3\nh_fP = 1.188\nP = \"5 kW\"\nn_1 = \"900 rpm\"\n\n[b]\ncalculator = "
              "\"belt.synchronous\"\nsynchronous_belt = \"H\"\nP = \"" +
              P + "\"\nK_A = 1.5\nn_1 = \"450 rpm\"\nz_1 = 24\nz_2 = 24\na = \"500 mm\"\nb = \"76.2 mm\"\n" + more),
          "b", "power");
    };
    const std::string all = power("=g.P");
    CHECK(all != "not-judged");
    CHECK(power("=0.97*g.P") == all);
    CHECK(power("=g.P/2") == "not-judged");
    CHECK(power("=g.P/2", "because.P = \"two belts of one width\"\n") != "not-judged");
  }

  TEST_CASE("the two gears of a helical pair have opposite hands, from whichever shaft a step describes them") {
    const auto pair = [](const std::string& name, const std::string& teeth, const std::string& load,
                         const std::string& more) {
      return "[" + name + "]\ncalculator = \"gear.pair\"\n" + teeth +
             "m_n = \"3 mm\"\nb = \"40 mm\"\ncutting = \"hobbed\"\nK_f = 1.6\nsigma_adm_1 = \"250 MPa\"\nsigma_adm_2 = "
             "\"250 MPa\"\n" +
             load + more + "\n";
    };
    const std::string forward = "z_1 = 20\nz_2 = 60\n", back = "z_1 = 60\nz_2 = 20\n";
    const std::string fast = "T_1 = \"100 N*m\"\nn_1 = \"1500 rpm\"\n", slow = "T_1 = \"300 N*m\"\nn_1 = \"500 rpm\"\n";
    const auto shaft = [](const std::string& name, const std::string& seats) {
      return "[" + name +
             "]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\npieces = [{ l = \"200 mm\", d = \"50 "
             "mm\" }]\nsupports = [{ name = \"left\", x = \"15 mm\", holds = \"both\" }, { name = \"right\", x = \"150 "
             "mm\" "
             "}]\nS_F = 1.2\nseats = [" +
             seats + "]\n";
    };
    const auto reason = [&](const std::string& second, const std::string& gear) {
      const std::string driven = shaft("one",
                                       "{ x = \"185 mm\", way = \"drives\", T = \"100 N*m\" }, { x = \"80 mm\", load "
                                       "= \"=a.gear_1\" }");
      const std::string driving = shaft("two", "{ x = \"80 mm\", way = \"drives\", load = \"=b." + gear +
                                                   "\" }, { x = \"185 mm\", T = \"300 N*m\" }");
      const std::string first = pair("a", forward, fast, "beta = \"15 deg\"\nhand = \"left\"\n");
      return mode_of(solved_as_found(first + second + driven + driving), "b", "root_1");
    };
    const std::string helix = "beta = \"15 deg\"\n", left = "hand = \"left\"\n", right = "hand = \"right\"\n";
    const std::string as_left = reason(pair("b", forward, fast, helix + left), "gear_2");
    CHECK(as_left == "pass");
    CHECK(reason(pair("b", forward, fast, helix + right), "gear_2") == "not-judged");
    CHECK(reason(pair("b", forward, fast, helix), "gear_2") == "not-judged");  // right by default
    CHECK(reason(pair("b", back, slow, helix + left), "gear_1") == "not-judged");
    CHECK(reason(pair("b", back, slow, helix + right), "gear_1") == as_left);
    CHECK(reason(pair("b", back, slow, helix + left + "because.hand = \"drawing 12\"\n"), "gear_1") == as_left);
    CHECK(reason(pair("b", back, slow, "beta = \"0 deg\"\n" + left), "gear_1") == as_left);  // spur gears
  }
}
