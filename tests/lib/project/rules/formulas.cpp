// Each condition of the rules for loads that are a part of what a formula of values gives.
#include "lib/project/references/drives/formulas.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string found(const std::string& values, const std::string& steps, const std::string& step = "") {
  return inputs_found(&project::parts_of_formulas, "[values]\n" + values + "\n" + steps, step);
}

std::string shaft(const std::string& T, const std::string& more = "") {
  return "[s]\ncalculator = \"shaft.torsion\"\nd = \"60 mm\"\nmaterial = \"C45E\"\nS = 2\nT = \"" + T + "\"\n" + more;
}

std::string lug(const std::string& F) { return example_of("pin.lug", "F = \"" + F + "\""); }
std::string column(const std::string& P) { return example_of("column.buckling", "P = \"" + P + "\""); }
std::string cycle(const std::string& most, const std::string& least = "0 MPa") {
  return example_of("fatigue.life", "sigma_max = \"" + most + "\"\nsigma_min = \"" + least + "\"");
}
std::string shear(const std::string& tau_a, const std::string& tau_m) {
  return example_of("fatigue.combined", "tau_a = \"" + tau_a + "\"\ntau_m = \"" + tau_m + "\"");
}

const std::string power = "P = \"20 kW\"\nn = \"1000 rpm\"\nl = \"2 m\"\nF = \"2 kN\"\n";
const std::string oil = "p = \"10 MPa\"\nD = \"80 mm\"\nd_rod = \"45 mm\"\nr = \"40 mm\"\n";
const std::string force = "F = \"60 kN\"\nd = \"40 mm\"\nA = \"1200 mm^2\"\ne = \"30 mm\"\n";

}  // namespace

TEST_SUITE("project: parts of formulas") {
  TEST_CASE("a product of values by a bare number") {
    CHECK(found(power, shaft("=values.P/values.n/1.5")) == "T");
    CHECK(found(power, shaft("=values.P/values.n")).empty());
    CHECK(found(power, shaft("=0.9*values.P/values.n")).empty());  // losses
    CHECK(found(power, shaft("=0.2*values.F*values.l")).empty());  // the moment of a beam
    CHECK(found(power, shaft("=values.P/values.n*sin(30 deg)/2 + 0*values.l*values.F")) == "T");
    const std::string lift = "P = \"20 kW\"\nv = \"2 m/s\"\nm = \"1000 kg\"\n";
    CHECK(found(lift, lug("=values.P/values.v/2")).empty());  // of two lugs
    CHECK(found(lift, lug("=values.P/values.v/4")) == "F");
    CHECK(found(lift, lug("=values.m*9.81 m/s^2/4")) == "F");
    CHECK(found(lift, lug("=values.m*9.81 m/s^2")).empty());
    CHECK(found(lift, lug("=values.m*(g)")).empty());
    const std::string rest = "\n" + shaft("=values.P/values.n/2").replace(1, 1, "r");
    CHECK(found(power, shaft("=values.P/values.n/2") + rest).empty());
    CHECK(found(power, shaft("=values.P/values.n/2")) == "T");
  }

  TEST_CASE("a value with a word of its own states its share, a symbol does not") {
    CHECK(found(power + "T_each = \"=0.5*values.P/values.n\"\n", shaft("=values.T_each")).empty());
    CHECK(found(power + "T = \"=0.5*values.P/values.n\"\n", shaft("=values.T")) == "T");
  }

  TEST_CASE("forces of a pressure on a circle") {
    for (const char* const P : {"=values.p*pi*values.D^2/4", "=pi*(values.D/2)^2*values.p", "=pi*values.r^2*values.p",
                                "=values.p*pi*(values.D^2 - values.d_rod^2)/4"})
      CHECK_MESSAGE(found(oil, column(P)).empty(), P);
    for (const char* const P :
         {"=values.p/2*pi*values.D^2/4", "=values.p*pi*values.D^2/8", "=pi*(values.D/4)^2*values.p",
          "=pi*values.r^2/2*values.p", "=values.p*pi*(values.D^2 - values.d_rod^2)/8"})
      CHECK_MESSAGE(found(oil, column(P)) == "P", P);
  }

  TEST_CASE("torques of a force at a diameter, a radius or an eccentricity") {
    const std::string drum = "F = \"2 kN\"\nD_drum = \"400 mm\"\nr = \"200 mm\"\ne = \"50 mm\"\nm = \"200 kg\"\n";
    for (const char* const T : {"=values.F*values.D_drum/2", "=values.F*values.r", "=values.m*9.81 m/s^2*values.r",
                                "=values.F*values.e", "=0.9*values.F*values.r"})
      CHECK_MESSAGE(found(drum, shaft(T)).empty(), T);
    for (const char* const T : {"=values.F*values.D_drum/5", "=values.F*values.r/2", "=values.F*values.e/2",
                                "=values.m*9.81 m/s^2*values.r/2"})
      CHECK_MESSAGE(found(drum, shaft(T)) == "T", T);
  }

  TEST_CASE("stresses of a section") {
    for (const char* const sigma :
         {"=values.F/values.A", "=4*values.F/(pi*values.d^2)", "=values.F/(pi*(values.d/2)^2)"})
      CHECK_MESSAGE(found(force, cycle(sigma)).empty(), sigma);
    for (const char* const sigma : {"=values.F/values.A/2", "=2*values.F/(pi*values.d^2)", "=values.F/(4*values.A)"})
      CHECK_MESSAGE(found(force, cycle(sigma)) == "sigma_max", sigma);
    CHECK(found(force, cycle("=values.F/values.A", "=0.1*values.F/values.A")).empty());  // the lower end
    const std::string bar = "F = \"3 kN\"\nr = \"250 mm\"\nd = \"36 mm\"\nT = \"750 N*m\"\n";
    const std::string tau = "=16*values.F*values.r/(pi*values.d^3)", of_torque = "=16*values.T/(pi*values.d^3)";
    CHECK(found(bar, shear(tau + "/2", tau + "/2")).empty());
    CHECK(found(bar, shear(of_torque, of_torque)).empty());
    CHECK(found(bar, shear(tau + "/4", tau + "/4")) == "tau_m, tau_a");
  }

  TEST_CASE("a load divided by the application factor that the step applies") {
    const std::string stated = power + "K_A = 1.5\n";
    for (const char* const T : {"=values.P/values.n/values.K_A", "=values.P/values.n/1.5"})
      CHECK_MESSAGE(found(stated, shaft(T, "K_A = 1.5\n")) == "T", T);
    CHECK(found(stated, shaft("=values.P/values.n*values.K_A", "K_A = 1\n")).empty());
    CHECK(found(stated, shaft("=values.P/values.n/values.K_A")).empty());  // the step applies none
  }

  TEST_CASE("a force of the pressure in a cylinder of the file") {
    const std::string barrel =
        "\n" + example_of("vessel.thick", "p = \"=values.p\"\nR = \"=values.D/2\"\nmeasured = \"inner\"");
    const auto rod = [&](const std::string& P) { return found(oil, column(P) + barrel); };
    CHECK(rod("=values.p*pi*values.D^2/4").empty());
    CHECK(rod("=values.p*pi*values.d_rod^2/4") == "P");
    CHECK(rod("=values.p*pi*(values.D^2 - values.d_rod^2)/4") == "P");  // a bar that is pushed
    CHECK(found(oil, lug("=values.p*pi*(values.D^2 - values.d_rod^2)/4") + barrel).empty());
    CHECK(found(oil, lug("=values.p*pi*values.d_rod^2/4") + barrel) == "F");
    CHECK(found(oil + "p_2 = \"1 MPa\"\n", column("=values.p_2*pi*values.d_rod^2/4") + barrel).empty());
    CHECK(found(oil + "n = 8\n", lug("=values.p*pi*values.D^2/4/values.n") + barrel).empty());  // bolts of a cover
    const auto at = [&](const std::string& R, const std::string& measured) {                    // a bore of 80 mm
      return found(oil, lug("=values.p*pi*values.D^2/4") + "\n" +
                            example_of("vessel.thick", "p = \"=values.p\"\nR = \"" + R + "\"\ndelta = \"20 mm\"\n" +
                                                           "measured = \"" + measured + "\""));
    };
    CHECK(at("50 mm", "mean").empty());
    CHECK(at("60 mm", "outer").empty());
    CHECK(at("60 mm", "inner") == "F");
  }

  TEST_CASE("a smaller section of [values]") {
    const std::string solid = "=4*values.F/(pi*values.d^2)";
    for (const char* const size :
         {"d_i = \"20 mm\"", "d_bore = \"20 mm\"", "d_core = \"34 mm\"", "D_thread = \"36 mm\""})
      CHECK_MESSAGE(found(force + size + "\n", cycle(solid)) == "sigma_max", size);
    for (const char* const size : {"d_i = \"45 mm\"", "d_head = \"30 mm\"", "l_bore = \"20 mm\"", "d_i = \"20 N\""})
      CHECK_MESSAGE(found(force + size + "\n", cycle(solid)).empty(), size);
    CHECK(found(force + "A_core = \"1000 mm^2\"\n", cycle("=values.F/values.A")) == "sigma_max");
    CHECK(found(force + "A_core = \"1300 mm^2\"\n", cycle("=values.F/values.A")).empty());
    CHECK(found("d_rod_bore = \"20 mm\"\n", example_of("pin.joint")) == "d");
    CHECK(found("d_rod_bore = \"20 mm\"\n", example_of("pin.joint", "d_i = \"10 mm\"")).empty());
    CHECK(found("d_hub_bore = \"20 mm\"\n", example_of("shaft.key")).empty());
  }

  TEST_CASE("fewer parts carry than the load is divided by") {
    const std::string lugs = "m = \"6000 kg\"\nn_lugs = 4\n";
    const std::string each = lug("=values.m*9.81 m/s^2/values.n_lugs");
    CHECK(found(lugs, each).empty());
    CHECK(found(lugs + "n_lugs_loaded = 2\n", each) == "F");
    CHECK(found(lugs + "n_carrying = 2\n", each) == "F");
    CHECK(found(lugs + "n_carrying = 4\n", each).empty());
    CHECK(found(lugs + "n_bolts = 2\n", each).empty());
  }

  TEST_CASE("a larger pull than that of the torque") {
    const std::string drum = "m = \"1000 kg\"\nD = \"200 mm\"\n";
    const std::string torque = shaft("=values.m*9.81 m/s^2*values.D/2");  // of 9.81 kN
    CHECK(found(drum + "F_pull_max = \"25 kN\"\n", torque) == "T");
    CHECK(found(drum + "F_pull_max = \"9 kN\"\n", torque).empty());
    CHECK(found(drum + "F_pull = \"25 kN\"\n", torque).empty());
    CHECK(found(drum + "F_max = \"900 kN\"\n", torque).empty());
  }

  TEST_CASE("a named quarter next to a count of two, and the arm of a force by its word") {
    const std::string chains =
        "W = \"40 kN\"\nn_chains = 2\nF_half = \"=values.W/2\"\nF_chain = \"=values.W*(1 m)/(4 m)\"\n";
    CHECK(found(chains, lug("=values.F_half")).empty());
    const std::string arm = "F = \"600 N\"\nL_arm = \"800 mm\"\nd = \"60 mm\"\n";
    const std::string sigma = "=32*values.F*values.L_arm/(pi*values.d^3)";
    CHECK(found(arm, cycle(sigma)).empty());
    CHECK(found(arm, cycle(sigma + "/2")) == "sigma_max");
  }

  TEST_CASE("a typed pressure below that whose force acts on the bore") {
    const std::string rod = "\n" + column("=values.p*pi*values.D^2/4");
    const auto wall = [&](const std::string& p) {
      return found(oil, example_of("vessel.thick", "p = \"" + p + "\"\nR = \"40 mm\"\nmeasured = \"inner\"") + rod);
    };
    CHECK(wall("1 MPa") == "p");
    CHECK(wall("10 MPa").empty());
    CHECK(wall("=values.p").empty());
  }

  TEST_CASE("a named torque that is divided by the application factor of its shaft and its key") {
    const std::string drum = "F = \"12 kN\"\nd = \"240 mm\"\nT_drum = \"=values.F*values.d/2/1.4\"\n";
    const std::string both =
        shaft("=values.T_drum", "K_A = 1.4\n") + "\n" + example_of("shaft.key", "T = \"=values.T_drum\"\nK_A = 1.4");
    CHECK(found(drum, both) == "T");
    CHECK(found(drum, shaft("=values.T_drum", "K_A = 1.5\n")).empty());
    CHECK(found("F = \"12 kN\"\nd = \"240 mm\"\nT_half = \"=values.F*values.d/2/2\"\n",
                shaft("=values.T_half", "K_A = 2\n"))
              .empty());
  }
}
