// Assessment of a part: modes that apply, may apply, are assessed, accepted, or left out.
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace {

using namespace loadpath;
using account::State;
using test::contains;
using test::press_of_heavy_rod;
using test::Solved;

const std::string gears =
    "[gears]\ncalculator = \"gear.pair\"\nz_1 = 20\nz_2 = 57\nm_n = \"2.5 mm\"\nT_1 = \"60 N*m\"\nb = \"25 mm\"\n";
const std::string strength = "sigma_adm_1 = \"200 MPa\"\nsigma_adm_2 = \"200 MPa\"\n";
const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n";
const std::string rod =
    "[rod]\ncalculator = \"column.buckling\"\nl = \"200 mm\"\nd = \"20 mm\"\nends = \"pinned_pinned\"\nE = \"210 "
    "GPa\"\n"
    "R_e = \"235 MPa\"\nmethod = \"johnson\"\nn_st = 2\n";

}  // namespace

TEST_SUITE("project modes") {
  TEST_CASE("a load without a strength is not assessed, and the missing input is named") {
    Solved bare(gears), judged(gears + strength), one(gears + "sigma_adm_1 = \"200 MPa\"\n");
    CHECK(bare.mode("gears.root_1").state == State::not_judged);
    CHECK(bare.mode("gears.root_1").wants == "sigma_adm_1");
    CHECK(judged.mode("gears.root_1").state == State::pass);
    CHECK(judged.mode("gears.root_1").governs == "u_F1");
    CHECK(one.mode("gears.root_1").state == State::pass);
    CHECK(one.mode("gears.root_2").state == State::not_judged);                    // one wheel does not hide the other
    CHECK(account::overall(project::modes(judged.project)) == State::not_judged);  // pitting
  }

  TEST_CASE("a limit without the value that it compares names the input") {
    Solved belts(
        "[belts]\ncalculator = \"belt.grooved\"\nP = \"150 W\"\nn_1 = \"1400 rpm\"\nd_1 = \"80 mm\"\nd_2 = \"160 mm\"\n"
        "a = \"300 mm\"\nmu = 0.4\nd_b = \"6 mm\"\nrho = \"1200 kg/m^3\"\nsigma_adm = \"4 MPa\"\nd_min = \"60 mm\"\n");
    CHECK(belts.mode("belts.pulley").state == State::pass);
    CHECK(account::reason(belts.mode("belts.speed")).text() == "give v_max");
  }

  TEST_CASE("without a load no strength mode applies") {
    CHECK_FALSE(Solved(gears.substr(0, gears.find("T_1"))).has("gears.root_1"));
  }

  TEST_CASE("the user accepts modes that nothing assesses, and never a failure") {
    const std::string reason = "accept.pitting_1 = \"rated by the maker, drawing 12\"\n";
    Solved accepted(gears + strength + reason);
    CHECK(accepted.mode("gears.pitting_1").state == State::accepted);
    CHECK(account::reason(accepted.mode("gears.pitting_1")).text() == "rated by the maker, drawing 12");
    Solved failing(gears + "sigma_adm_1 = \"20 MPa\"\nsigma_adm_2 = \"20 MPa\"\naccept.root_1 = \"it will hold\"\n");
    CHECK(failing.mode("gears.root_1").state == State::fail);
    CHECK(contains(Solved(gears + "accept.piting_1 = \"x\"\n").messages(),
                   "has no failure mode 'piting_1' = did you mean 'pitting_1'?"));
    CHECK(contains(Solved(gears + "accept.pitting_1 = \" \"\n").messages(), "needs a reason"));
    for (const std::string consent : {"ok", "OK", "n/a", "not needed", "none"})
      CHECK_MESSAGE(contains(Solved(gears + "accept.pitting_1 = \"" + consent + "\"\n").messages(), "needs a reason"),
                    consent);
    CHECK_FALSE(contains(Solved(gears + "accept.pitting_1 = \"not loaded\"\n").messages(), "needs a reason"));
    CHECK(contains(Solved(gears + "accept.pitting_1 = true\n").messages(), "needs a reason"));
    CHECK(contains(Solved(gears + "accept = \"pitting_1\"\n").messages(), "is a table of reasons, not a text"));
  }

  TEST_CASE("a typed torque may be static, one from gears rotates, and brings their forces") {
    Solved typed(axle + "T = \"100 N*m\"\n"), taken(gears + strength + axle + "T = \"=gears.T_2\"\n");
    CHECK(account::overall(project::modes(typed.project)) == State::pass);  // apart from open modes
    CHECK(typed.mode("axle.fatigue").state == State::open);
    CHECK(typed.mode("axle.bending").state == State::open);
    CHECK(taken.mode("axle.fatigue").state == State::not_judged);
    CHECK(taken.mode("axle.bending").state == State::not_covered);
  }

  TEST_CASE("a link's force comes with its bending, which a column under a force alone does not assess") {
    Solved column(press_of_heavy_rod + rod + "N = \"=press.links.rod.N\"\n");
    REQUIRE_MESSAGE(!has_errors(column.issues), column.messages());
    CHECK(column.mode("rod.buckling").state == State::pass);
    CHECK(column.mode("rod.lateral").state == State::not_judged);
    CHECK(contains(account::reason(column.mode("rod.lateral")).text(), "press.links.rod.V, press.links.rod.M_b"));
    CHECK_FALSE(contains(account::reason(column.mode("rod.lateral")).text(), "press.links.rod.N"));
  }

  TEST_CASE("a magnitude is refused for a load whose sign decides, unless its sign is given") {
    CHECK(contains(Solved(press_of_heavy_rod + rod + "N = \"=peak(press.links.rod.N)\"\n").messages(),
                   "the sign of 'N' matters, and 'peak' is a magnitude"));
    CHECK(contains(Solved(press_of_heavy_rod + rod + "N = \"=2*abs(press.links.rod.N)\"\n").messages(),
                   "'abs' is a magnitude"));
    for (const char* sound : {"=-peak(press.links.rod.N)", "=min(press.links.rod.N)", "=press.links.rod.N"}) {
      CAPTURE(sound);
      CHECK_FALSE(has_errors(Solved(press_of_heavy_rod + rod + "N = \"" + sound + "\"\n").issues));
    }
  }

  TEST_CASE("links and pins that no step takes are one open line") {
    Solved alone(press_of_heavy_rod), taken(press_of_heavy_rod + rod + "N = \"=press.links.rod.N\"\n");
    CHECK(alone.mode("press.strength").state == State::open);
    CHECK(contains(account::reason(alone.mode("press.strength")).text(), "rod"));
    CHECK_FALSE(contains(account::reason(taken.mode("press.strength")).text(), " rod,"));
  }

  TEST_CASE("an acceptance without effect is reported, with the state of the mode") {
    const auto warnings = [](const std::string& text) {
      std::string all;
      const Solved solved(text);
      for (const Message& warning : solved.project.steps[0]->account().warnings) all += warning.text() + "\n";
      return all;
    };
    CHECK(warnings(gears + "accept.pitting_1 = \"rated\"\n").empty());
    CHECK(warnings(gears + strength + "accept.root_1 = \"it holds\"\n") ==
          "accept.root_1 has no effect: root_1 is assessed and passes\n");
    CHECK(warnings(gears + "sigma_adm_1 = \"20 MPa\"\nsigma_adm_2 = \"20 MPa\"\naccept.root_1 = \"it holds\"\n") ==
          "accept.root_1 has no effect: root_1 fails, and a failure is never accepted\n");
    CHECK(warnings(gears.substr(0, gears.find("T_1")) + "accept.root_1 = \"it holds\"\n") ==
          "accept.root_1 has no effect: root_1 does not apply here\n");
    CHECK(warnings(axle + test::no_torque + "accept.yield = \"it holds\"\n" + test::relay) ==
          "accept.yield has no effect: yield: no result, which cannot be accepted\n");
  }

  TEST_CASE("a step without results because of a missing input has not passed") {
    Solved step(axle + test::no_torque + test::relay);
    CHECK(step.mode("axle.inputs").state == State::not_available);
    CHECK(account::worst(project::modes(step.project)) == State::not_available);
  }

  TEST_CASE("a pass is never reported without its modes") {
    CHECK(contains(account::scope(project::modes(Solved(gears + strength).project)).text(), "; pass: gears."));
    CHECK(account::scope({}).text() == "no failure mode is assessed here");
    CHECK(account::brief_scope({}).text() == "no failure mode is assessed here");
    CHECK(account::overall({}) == State::open);
  }

  TEST_CASE("below a list many passing or open modes are counted, and those that need input are named") {
    account::Modes modes;
    const auto add = [&](State state, const std::string& id) {
      account::Mode mode;
      mode.step = "part", mode.id = id, mode.state = state, mode.wants = "S";
      modes.push_back(mode);
    };
    for (int k = 1; k <= 8; ++k) add(State::pass, std::to_string(k));
    for (int k = 1; k <= 4; ++k) add(State::open, std::to_string(k));
    CHECK(account::brief_scope(modes).text() == account::scope(modes).text());
    add(State::pass, "9");
    add(State::open, "5");
    for (int k = 1; k <= 9; ++k) add(State::not_judged, "n" + std::to_string(k));
    CHECK(account::brief_scope(modes).text() ==
          "not assessed: part.n1, part.n2, part.n3, part.n4, part.n5, part.n6, part.n7, part.n8, part.n9; pass: 9 "
          "failure "
          "modes listed above; not considered: 5 failure modes listed above");
  }

  TEST_CASE("departures from common practice are shown with the step") {
    Solved odd(axle + "T = \"100 N*m\"\nK_A = 9\n");
    REQUIRE(odd.project.steps[0]->account().warnings.size() == 1);
    CHECK(contains(odd.project.steps[0]->account().warnings[0].text(), "K_A"));
  }

  TEST_CASE("a typed input that no result depends on is reported") {
    const std::string unloaded = gears.substr(0, gears.find("T_1"));
    CHECK_FALSE(contains(Solved(unloaded).messages(), "no effect"));
    CHECK(contains(Solved(unloaded + "K_A = 1.5\n").messages(), "'K_A' has no effect here"));
    CHECK_FALSE(contains(Solved(gears + "K_A = 1.5\n").messages(), "no effect"));
    CHECK_FALSE(contains(Solved(axle + "T = \"100 N*m\"\nG = \"80 GPa\"\nl = \"1 m\"\n").messages(), "no effect"));
  }
}

TEST_SUITE("project unused") {
  const std::string bar =
      "[rod]\ncalculator = \"column.buckling\"\nl = \"200 mm\"\nd = \"12 mm\"\nends = \"pinned_pinned\"\n"
      "material = \"S355JR\"\nmethod = \"johnson\"\nn_st = 2\n";
  const std::string engine =
      "[m]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"60 mm\"\nl = \"200 mm\"\n"
      "crank = { speed = \"3000 rpm\", positions = 24 }\nlinks.slider = { mass = \"0.4 kg\" }\n";

  TEST_CASE("a typed number or word that no result depends on is reported") {
    const auto says = [&](const std::string& more) { return Solved(bar + "P = \"5 kN\"\n" + more).messages(); };
    CHECK_FALSE(contains(says("a_R = 1e-4\n"), "no effect"));  // it moves a row of another method
    CHECK(contains(says("gamma_M1 = 1.1\n"), "'gamma_M1' has no effect here"));
    CHECK_FALSE(contains(says("n_t = 2\n"), "'n_st' has no effect"));
    CHECK_FALSE(contains(says("e_y = \"3 mm\"\n"), "no effect"));  // its mode is not judged, which says it
  }

  TEST_CASE("where a check has no value its dependence is not reported") {
    const std::string below = "sigma_P = \"190 MPa\"\nP = \"10 kN\"\n";  // Euler is not covered there
    std::string euler = bar;
    euler.replace(euler.find("johnson"), 7, "euler");
    CHECK_FALSE(contains(Solved(euler + below).messages(), "no effect"));
  }

  TEST_CASE("over a series an input is varied at several positions") {
    const std::string moving = engine + bar + "N = \"=m.links.rod.N\"\n";
    CHECK(contains(Solved(moving + "gamma_M1 = 1.1\n").messages(), "'gamma_M1' has no effect here"));
    CHECK_FALSE(contains(Solved(moving + "n_t = 2\n").messages(), "no effect"));  // pulled in half of them
  }

  TEST_CASE("inputs inside lists are varied too, also those that come from expressions") {
    const std::string lift =
        "[l]\ncalculator = \"dynamics.lift\"\ns = \"2 m\"\nweights = [{ m = \"60 kg\", i = -1 }, { m = "
        "\"100 kg\", mu = 0.1";
    CHECK(contains(Solved(lift + " }]\n").messages(), "'weights[2].mu' has no effect here"));  // it hangs
    CHECK_FALSE(contains(Solved(lift + ", alpha = \"60 deg\" }]\n").messages(), "no effect"));
    const std::string axle_and_bar = axle + "T = \"100 N*m\"\n" + bar + "P = \"5 kN\"\n";
    CHECK(contains(Solved(axle_and_bar + "gamma_M1 = \"=1 + axle.u_tau\"\n").messages(),
                   "'gamma_M1' has no effect here"));
  }

  TEST_CASE("a word that a rule requires is not reported, though no other word changes a result") {
    const Solved belt(
        "[b]\ncalculator = \"belt.v\"\nbasis = \"iso\"\nsection = \"C\"\nbelt_class = \"III\"\nP = \"10 kW\"\nn_1 = "
        "\"800 rpm\"\nd_1 = \"200 mm\"\nd_2 = \"200 mm\"\nL = \"3750 mm\"\n");
    CHECK_FALSE(contains(belt.messages(), "no effect"));
  }
}

TEST_SUITE("project angles") {
  TEST_CASE("inside expressions, too, an angle is not a bare number, and an angular velocity not a frequency") {
    const auto says = [](const std::string& text) { return Solved(text).messages(); };
    const std::string motion = "[m]\ncalculator = \"motion.compound\"\nxi = \"1 m\"\nv_eta = \"2 m/s\"\n";
    CHECK(contains(says(motion + "omega = \"=50 Hz\"\n"), "'omega' takes a value of angular velocity"));
    CHECK(contains(says(motion + "omega = \"=3000/(1 min)\"\n"), "rpm, rev/s or rad/s"));
    CHECK_FALSE(contains(says(motion + "omega = \"=2*1450 rpm\"\n"), "omega"));
    CHECK_FALSE(contains(says(motion + "omega = \"=2*pi*1 rad*50 Hz\"\n"), "omega"));
    CHECK(contains(says(motion + "omega = \"5 rad/s\"\nphi = \"=12\"\n"), "write its unit: deg or rad"));
    CHECK(
        contains(says(motion + "omega = \"=10 rad/s*sin(30)\"\n"), "'sin' needs an angle, and '30' is a bare number"));
    CHECK_FALSE(contains(says(motion + "omega = \"=10 rad/s*sin(pi/6)\"\n"), "bare number"));
    CHECK_FALSE(contains(says(motion + "omega = \"=10 rad/s*sin(30 deg)\"\n"), "bare number"));
  }

  TEST_CASE("a mode that is left to another calculator has its state there, where its record is taken whole") {
    const std::string turning = axle + "d = \"40 mm\"\nT = \"100 N*m\"\nK_A = 1.5\n";
    const std::string life = "[life]\ncalculator = \"fatigue.cycle\"\nr = -1\n";
    const std::string limit = "sigma_D = \"60 MPa\"\nS_D = 1.5\n", taken = "cycle = \"=axle.cycle\"\n";
    Solved alone(turning), apart(turning + life + limit + "stress = \"shear\"\nsigma_max = \"=axle.tau_max\"\n");
    CHECK(alone.mode("axle.fatigue").state == State::not_judged);
    CHECK(account::reason(alone.mode("axle.fatigue")).text() == "add a step of fatigue.cycle that takes =axle.cycle");
    CHECK(apart.mode("axle.fatigue").state == State::not_judged);
    Solved judged(turning + life + limit + taken);
    REQUIRE_MESSAGE(!has_errors(judged.issues), judged.messages());
    CHECK(judged.mode("axle.fatigue").state == State::pass);
    CHECK(judged.mode("axle.fatigue").utilisation == judged.mode("life.fatigue").utilisation);
    CHECK(account::reason(judged.mode("axle.fatigue")).text() == "by life.fatigue: u_D");
    CHECK(judged.word("life.stress") == "shear");
    CHECK(Solved(turning + life + "sigma_D = \"10 MPa\"\nS_D = 1.5\n" + taken).mode("axle.fatigue").state ==
          State::fail);
    CHECK(contains(account::reason(Solved(turning + life + taken).mode("axle.fatigue")).text(), "give sigma_D"));
  }

  TEST_CASE("a cycle without variation does not assess a shaft whose load varies") {
    const std::string turning = axle + "d = \"40 mm\"\nT = \"100 N*m\"\nK_A = 1.5\n";
    const std::string still =
        "[life]\ncalculator = \"fatigue.cycle\"\nr = 1\nsigma_D = \"60 MPa\"\nS_D = 1.5\ncycle = "
        "\"=axle.cycle\"\n";
    CHECK(Solved(turning + still).mode("axle.fatigue").state == State::not_judged);
  }

  TEST_CASE("a record that is taken and then changed assesses nothing") {
    const std::string turning = axle + "d = \"40 mm\"\nT = \"100 N*m\"\nK_A = 1.5\n";
    const std::string life =
        "[life]\ncalculator = \"fatigue.cycle\"\nr = -1\nsigma_D = \"60 MPa\"\nS_D = 1.5\n"
        "cycle = \"=axle.cycle\"\n";
    CHECK(Solved(turning + life + "sigma_max = \"1 MPa\"\n").mode("axle.fatigue").state == State::not_judged);
    CHECK(Solved(turning + life + "stress = \"normal\"\n").mode("axle.fatigue").state == State::not_judged);
  }

  TEST_CASE("the tooth numbers of a planetary set are assessed by the pairs that take its meshes, the planet by both") {
    const std::string set =
        "[set]\ncalculator = \"gear.planetary\"\nz_s = 24\nz_p = 24\nN_p = 3\nfixed = \"ring\"\nn_s = \"1500 rpm\"\n"
        "T_s = \"90 N*m\"\nm_n = \"2.5 mm\"\n";
    const std::string rest =
        "b = \"30 mm\"\nsigma_adm_1 = \"200 MPa\"\naccept.pitting_1 = \"case hardened\"\n"
        "accept.pitting_2 = \"case hardened\"\n";
    const std::string with_sun =
        "[with_sun]\ncalculator = \"gear.pair\"\npair = \"=set.sun_mesh\"\n"
        "sigma_adm_2 = \"200 MPa\"\n" +
        rest;
    const std::string with_ring = "[with_ring]\ncalculator = \"gear.pair\"\npair = \"=set.ring_mesh\"\n" + rest;
    Solved one(set + with_sun), both(set + with_sun + with_ring);
    REQUIRE_MESSAGE(!has_errors(both.issues), both.messages());
    CHECK(one.mode("set.teeth_sun").state == State::accepted);  // its root passes, its pitting is answered for
    CHECK(one.mode("set.teeth_planet").state == State::not_judged);
    CHECK(both.mode("set.teeth_planet").state == State::accepted);
    CHECK(both.mode("set.teeth_ring").state == State::not_judged);  // Lewis does not know the teeth of a ring
    CHECK(both.word("with_sun.idler") == "gear_2");
    CHECK(both.word("with_ring.mesh") == "internal");
    // A third of the torque each; against the carrier the sun turns by 72/96 of its speed.
    CHECK(both.value("with_sun.T_1") == doctest::Approx(30.0));
    CHECK(both.value("with_sun.n_1") == doctest::Approx(1500.0 * 0.75 * 2.0 * 3.14159265358979 / 60.0));
    CHECK(both.value("with_ring.T_1") == doctest::Approx(30.0));  // the planet is as large as the sun
    CHECK(both.value("with_sun.F_t") == doctest::Approx(both.value("set.F_t")));
  }

  TEST_CASE("a step with less data on the service does not override what the part itself states") {
    const std::string shaft =
        "[axle]\ncalculator = \"shaft.design\"\nmaterial = \"C45E\"\ngroup = \"carbon-steel\"\npieces = [{ l = \"200 "
        "mm\", d = "
        "\"40 mm\" }]\nsupports = [{ x = \"10 mm\" }, { x = \"190 mm\" }]\nnotches = [{ x = \"50 mm\", part = "
        "\"=key.notch\" }]\n";
    const std::string key =
        "[key]\ncalculator = \"shaft.key\"\nT = \"100 N*m\"\ntorque = \"one_way\"\nK_A = 1.5\nd = \"40 mm\"\nkey = "
        "\"12x8\"\nl = \"50 mm\"\nl_n = \"60 mm\"\nR_e_1 = \"430 MPa\"\nR_e_2 = \"250 MPa\"\nR_e_k = \"420 MPa\"\n";
    Solved solved(shaft + key);
    REQUIRE_MESSAGE(!has_errors(solved.issues), solved.messages());
    CHECK(solved.mode("key.fatigue").state == State::not_judged);
  }
}
