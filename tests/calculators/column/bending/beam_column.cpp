#include "calculators/column/bending/beam_column.hpp"

#include "tests/calculators/evaluated.hpp"
#include "tests/calculators/step_text.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

namespace {

using namespace loadpath;
using loadpath::test::ExampleStep;
using loadpath::test::mode_with;
using test::rel;

ExampleStep step(const std::string& lines) { return {"column.beam_column", lines}; }
std::string mode(const std::string& lines, const std::string& id) { return mode_with("column.beam_column", lines, id); }

const std::string no_moments = "M_y_1 = \nM_y_2 = \nM_z = \n";
const std::string by_aisc = "method = \"aisc\"\ngamma_M1 = \ngamma_F = \nP = \"300 kN\"\n";

}  // namespace

TEST_SUITE("column with bending") {
  TEST_CASE("without moments it is the plain column, by both codes") {
    const ExampleStep ec3 = step(no_moments), aisc = step(by_aisc + no_moments);
    CHECK(rel(ec3("u_z"), ec3("u")) < 1e-12);
    CHECK(rel(aisc("u_H"), aisc("u")) < 1e-12);
  }

  TEST_CASE("the interaction tends to the plain column as the moments tend to zero") {
    const ExampleStep little = step("M_y_1 = \"1e-6 N*m\"\nM_y_2 = \"0 N*m\"\nM_z = \"1e-6 N*m\"");
    CHECK(rel(little("u_z"), little("u")) < 1e-9);
  }

  TEST_CASE("a typed plastic modulus is that of the plates, but for fillets") {
    const auto error = [](const std::string& W_pl_y) {
      return test::first_error_of(
          "[c]\ncalculator = \"column.beam_column\"\nP = \"600 kN\"\nM_y = \"60 kN*m\"\nl = \"4 m\"\nends = "
          "\"pinned_pinned\"\n"
          "h = \"200 mm\"\nb = \"200 mm\"\nt_w = \"9 mm\"\nt_f = \"15 mm\"\nr = \"18 mm\"\nkind = \"rolled_I\"\nA = "
          "\"7808 mm^2\"\n"
          "I_y = \"5696 cm^4\"\nI_z = \"2003 cm^4\"\nE = \"210 GPa\"\nR_e = \"235 MPa\"\nmethod = \"ec3\"\ngamma_M1 = "
          "1\n"
          "gamma_F = 1\nW_pl_y = \"" +
          W_pl_y + "\"\n");
    };
    CHECK(error("642.5 cm^3").empty());
    CHECK(error("6425 cm^3").starts_with("W_pl_y = 6425000 mm³ is more than "));
  }

  TEST_CASE("a short bar is limited by its section") {
    const ExampleStep bar = step("l = \"10 mm\"\nM_y_1 = \nM_y_2 = \nM_y = \"1 N*m\"\nM_z = ");
    CHECK(rel(bar("chi_LT"), 1.0) < 1e-12);
    CHECK(rel(bar("u_y"), bar("u_s")) < 1e-4);
  }

  TEST_CASE("neither the sign of the moments nor the direction of the bar matters") {
    const ExampleStep bar = step("M_z_1 = \"4 kN*m\"\nM_z_2 = \"3 kN*m\"\nM_z = "),
                      turned = step(
                          "M_y_1 = \"-60 kN*m\"\nM_y_2 = \"20 kN*m\"\nM_z_1 = \"-3 kN*m\"\nM_z_2 = \"-4 kN*m\""
                          "\nM_z = "),
                      ends = step(
                          "M_y_1 = \"-20 kN*m\"\nM_y_2 = \"60 kN*m\"\nM_z_1 = \"3 kN*m\"\nM_z_2 = \"4 kN*m\"\n"
                          "M_z = ");
    for (const char* u : {"u_s", "u_y", "u_z", "u_LT"}) {
      CHECK(rel(turned(u), bar(u)) < 1e-9);
      CHECK(rel(ends(u), bar(u)) < 1e-9);
    }
    CHECK(rel(step("M_z = \"-5 kN*m\"")("u_z"), step("")("u_z")) < 1e-12);
  }

  TEST_CASE("double curvature is the mildest distribution, a uniform moment the worst") {
    double before = 0.0;
    for (const char* M_2 : {"-60 kN*m", "-20 kN*m", "0 kN*m", "30 kN*m", "60 kN*m"}) {
      const double u = step(std::string("M_y_2 = \"") + M_2 + "\"")("u_y");
      CHECK(u >= before);
      before = u;
    }
    CHECK(rel(before, step("M_y_1 = \nM_y_2 = \nM_y = \"60 kN*m\"")("u_y")) < 1e-12);
    CHECK(step("M_y_2 = \"-60 kN*m\"")("u_s") >= step("M_y_2 = \"0 kN*m\"")("u_s"));  // the section does not gain
  }

  TEST_CASE("random columns: no increase makes it easier, and bending never helps") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(0.1, 1.0);
    const auto lines = [](double P, double M_1, double M_2, double M_z, double l, const char* method) {
      const auto in = [](const char* key, double value, const char* unit) {
        return std::string(key) + " = \"" + std::to_string(value) + " " + unit + "\"\n";
      };
      return in("P", P, "kN") + in("M_y_1", M_1, "kN*m") + in("M_y_2", M_2, "kN*m") + in("M_z", M_z, "kN*m") +
             in("l", l, "m") + method;
    };
    for (int i = 0; i < 40; ++i) {
      const char* const method = i % 2 == 0 ? "" : "method = \"aisc\"\ngamma_M1 = \ngamma_F = \n";
      const char* const u = i % 2 == 0 ? (i % 4 == 0 ? "u_y" : "u_z") : "u_H";
      const double P = 500 * any(random), M_1 = 60 * any(random), M_2 = M_1 * (2 * any(random) - 1.2),
                   M_z = 10 * any(random), l = 8 * any(random);
      const ExampleStep bar = step(lines(P, M_1, M_2, M_z, l, method));
      CHECK(step(lines(1.2 * P, M_1, M_2, M_z, l, method))(u) > bar(u));
      CHECK(step(lines(P, M_1, M_2, 1.2 * M_z, l, method))(u) > bar(u));
      CHECK(step(lines(P, 1.2 * M_1, 1.2 * M_2, M_z, l, method))(u) > bar(u));
      CHECK(step(lines(P, M_1, M_2, M_z, 1.2 * l, method))(u) >= bar(u) * (1.0 - 1e-9));
      CHECK(step(lines(P, M_1, M_2, M_z, l, method))(i % 2 == 0 ? "u_z" : "u_H") >= bar("u"));
    }
  }

  TEST_CASE("a longer span between lateral supports lowers the moment, and a tube has no lateral-torsional buckling") {
    const std::string ipe = "section = \"IPE 300\"\nP = \"100 kN\"\nM_z = \nM_y_1 = \nM_y_2 = \nM_y = \"40 kN*m\"\n";
    CHECK(step(ipe + "l = \"8 m\"")("chi_LT") < step(ipe + "l = \"4 m\"")("chi_LT"));
    CHECK(step(ipe + "l = \"4 m\"")("chi_LT") < 0.9);
    CHECK(step("section = \"SHS 200x200x8\"")("chi_LT") == 1.0);
    CHECK(mode(ipe + "l = \"8 m\"\nl_LT = \"1 m\"", "lateral_torsional") == "not-judged");  // needs a reason
  }

  TEST_CASE("a load above the shear centre lowers the critical moment, one below raises it") {
    const std::string loaded = "section = \"IPE 300\"\nP = \"100 kN\"\nM_z = \nM_y_1 = \nM_y_2 = \nq_z = \"5 N/mm\"\n";
    const double at_top = step(loaded)("M_cr"), at_centre = step(loaded + "z_g = \"0 mm\"")("M_cr"),
                 below = step(loaded + "z_g = \"-150 mm\"")("M_cr");
    CHECK(at_top < at_centre);
    CHECK(at_centre < below);
    CHECK(rel(at_top, step(loaded + "z_g = \"150 mm\"")("M_cr")) < 1e-12);
  }

  TEST_CASE("tension with bending: the section, and lateral-torsional buckling without relief") {
    const std::string tie = "P = \nN = \"600 kN\"\n";
    CHECK(mode(tie, "section") == "pass");
    CHECK(mode(tie, "buckling") == "none");
    CHECK(mode(tie, "slenderness") == "none");
    CHECK(rel(step(tie)("u_LT"), step("")("u_LT")) < 1e-12);
    CHECK(mode("P = \nN = \"1900 kN\"\n", "section") == "fail");
    CHECK(mode("P = \nN = \"0 kN\"\nM_y_1 = \"160 kN*m\"\n", "section") == "fail");
  }

  TEST_CASE("outside its scope nothing passes") {
    CHECK_FALSE(step("section = \"UPN 200\"").fault().empty());
    CHECK_FALSE(step("section = \"L 100x10\"").fault().empty());
    CHECK_FALSE(step("section = \nA = \"78 cm^2\"\nI_y = \"5696 cm^4\"\nI_z = \"2003 cm^4\"").fault().empty());
    CHECK_FALSE(step("method = \"secant\"\ne_y = \"5 mm\"").fault().empty());
    CHECK_FALSE(step("method = \"johnson\"\nn_st = 2").fault().empty());
    CHECK_FALSE(step("M_y_2 = ").fault().empty());
    CHECK_FALSE(step("ends = \nends_y = \"pinned_pinned\"\nends_z = \"fixed_free\"\nq_z = \"1 N/mm\"").fault().empty());
    // IPE 500 of S460 under compression alone: the web is of class 4
    const std::string slender = no_moments + "section = \"IPE 500\"\nR_e = \"460 MPa\"\nP = \"100 kN\"\n";
    CHECK(mode(slender, "local") == "not-covered");
    CHECK(mode(by_aisc + no_moments + "section = \"IPE 600\"\nR_e = \"690 MPa\"\nP = \"5000 kN\"\nl = \"1 m\"",
               "local") == "not-covered");
  }

  TEST_CASE("each moment alone makes it fail, by either code") {
    for (const std::string& code : {std::string(), by_aisc}) {
      CHECK(mode(code + no_moments + "M_y = \"400 kN*m\"", "bent") == "fail");
      CHECK(mode(code + no_moments + "M_z = \"200 kN*m\"", "bent") == "fail");
      CHECK(mode(code + no_moments + "q_z = \"200 N/mm\"", "bent") == "fail");
      CHECK(mode(code + no_moments + "F_y = \"200 kN\"", "bent") == "fail");
      CHECK(mode(code + no_moments + "M_y_1 = \"400 kN*m\"\nM_y_2 = \"-400 kN*m\"", "bent") == "fail");
      CHECK(mode(code + no_moments, "bent") == "none");
    }
  }

  TEST_CASE("effective lengths by factors above 1 are those of ends that sway") {
    const ExampleStep held = step(""), swaying = step("ends = \nbeta_y = 2\nbeta_z = 1");
    CHECK(rel(swaying("C_my"), 0.9) < 1e-12);
    CHECK(swaying("u_y") > held("u_y"));
    const ExampleStep braced = step(by_aisc), free = step(by_aisc + "ends = \nbeta_y = 2\nbeta_z = 1");
    CHECK(free("B_y") > braced("B_y"));
    CHECK(free("B_y") > 1.0);
  }

  TEST_CASE("the amplification of AISC is that of the exact bar under a uniform moment, within three percent") {
    // 1.6 P/P_e = x: the exact one is 1/cos(pi/2 sqrt(x))
    const ExampleStep bar = step(by_aisc + no_moments + "M_y = \"20 kN*m\"");
    const double x = 1.6 * 300e3 * 16.0 / (pi * pi * 210e9 * 5696e-8);
    CHECK(rel(bar("B_y"), 1.0 / (1.0 - x)) < 1e-6);
    CHECK(rel(bar("B_y"), 1.0 / std::cos(pi / 2 * std::sqrt(x))) < 0.03);
  }
}
