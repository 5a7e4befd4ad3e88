// Each condition of the rules for walls of one vessel.
#include "lib/project/references/machine/vessels.hpp"

#include "lib/project/references/agreement/ends.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

std::string found(const std::string& text, const std::string& step) {
  return inputs_found(&project::values_of_vessels, text, step);
}

std::string shell(const std::string& lines = "") {
  return "[shell]\n" +
         with_lines(
             "calculator = \"vessel.cylinder\"\np = \"1 MPa\"\nR = \"600 mm\"\nmeasured = "
             "\"inner\"\nc = \"1 mm\"\nz_l = 1\nsigma_adm = \"140 MPa\"\ndelta = \"12 mm\"\n",
             lines) +
         "\n";
}

/// An end, of the record of the shell or with its own pressure.
std::string end(const std::string& lines) {
  return "[end]\n" +
         with_lines("calculator = \"vessel.end\"\nform = \"korbbogen\"\nmaterial = \"P265GH\"\nl_f = \"40 mm\"\n",
                    lines) +
         "\n";
}

std::string outside(const std::string& lines) {
  return "[vac]\n" +
         with_lines(
             "calculator = \"vessel.external\"\np_e = \"0.1 MPa\"\nL = \"2400 mm\"\nmaterial = "
             "\"P265GH\"\n",
             lines) +
         "\n";
}

}  // namespace

TEST_SUITE("project: walls of one vessel") {
  TEST_CASE("an end takes the record of the shell") {
    const std::string typed = "p = \"1 MPa\"\nD_i = \"1200 mm\"\nc = \"1 mm\"";
    CHECK(found(shell() + end(typed), "end") == "p");
    CHECK(found(end(typed), "end").empty());
    CHECK(found(shell() + end("shell = \"=shell.shell\""), "end").empty());
    CHECK(found(shell() + end("shell = \"=shell.shell\"\np = \"1 MPa\""), "end").empty());
    CHECK(found(shell() + shell().replace(1, 5, "other"), "other").empty());
  }

  TEST_CASE("an end is tested with the pressure of its shell") {
    const std::string tested = shell("p_t = \"1.43 MPa\"\nh_t = \"0 m\"\nsigma_adm =\nmaterial = \"P265GH\"\nS = 1.5");
    const std::string taken = "shell = \"=shell.shell\"";
    CHECK(found(tested + end(taken), "end") == "p_t");
    CHECK(found(tested + end(taken + "\np_t = \"1.43 MPa\"\nh_t = \"0 m\""), "end").empty());
    CHECK(found(tested + end(taken + "\np_t = \"1.5 MPa\"\nh_t = \"0 m\""), "end").empty());
    CHECK(found(tested + end(taken + "\np_t = \"1.429 MPa\"\nh_t = \"0 m\""), "end").empty());
    CHECK(found(tested + end(taken + "\np_t = \"1.2 MPa\"\nh_t = \"0 m\""), "end") == "p_t");
    CHECK(found(shell() + end(taken), "end").empty());
    CHECK(found(shell() + end(taken + "\np_t = \"1.2 MPa\"\nh_t = \"0 m\""), "end").empty());
    CHECK(found(tested + end("p = \"1 MPa\"\nD_i = \"1200 mm\"\nc = \"1 mm\""), "end") == "p");
  }

  TEST_CASE("an end is tested under the water of its shell") {  // 2 m of water are 0.02 MPa
    const std::string tested = shell("p_t = \"1.43 MPa\"\nh_t = \"2 m\"\nsigma_adm =\nmaterial = \"P265GH\"\nS = 1.5");
    const auto asked = [&](const std::string& p_t, const std::string& h_t) {
      return inputs_found(&project::ends_of_vessel,
                          tested + end("shell = \"=shell.shell\"\np_t = \"" + p_t + "\"\nh_t = \"" + h_t + "\""),
                          "end");
    };
    CHECK(asked("1.43 MPa", "0.5 m") == "h_t");
    CHECK(asked("1.43 MPa", "2 m").empty());
    CHECK(asked("1.43 MPa", "3 m").empty());
    CHECK(asked("1.46 MPa", "0 m").empty());
    CHECK(asked("1.2 MPa", "0.5 m").empty());  // p_t is too low
  }

  TEST_CASE("an end of a shell that is assessed under external pressure") {
    const std::string taken = end("shell = \"=shell.shell\"");
    const std::string vacuum = outside("wall = \"=shell.wall\"");
    CHECK(found(shell() + taken + vacuum, "end") == "p");
    CHECK(found(shell() + taken, "end").empty());
    CHECK(found(shell() + end("shell = \"=shell.shell\"\naccept.vacuum = \"a valve\"") + vacuum, "end").empty());
    CHECK(found(shell() + taken + vacuum + outside("D_a = \"=end.D_a\"\ndelta = \"=end.delta\"").replace(1, 3, "own"),
                "end")
              .empty());
    CHECK(found(shell() + taken + outside("D_a = \"1224 mm\"\ndelta = \"12 mm\"\nc = \"1 mm\""), "end").empty());
  }

  TEST_CASE("the share of its thickness that the shell needs") {
    // delta_min of p R / (sigma z - p/2), and 1 mm of allowance
    const auto share = [](const std::string& delta, const std::string& m_r) {
      const std::string flat =
          "[flat]\ncalculator = \"vessel.flat_end\"\nshell = \"=shell.shell\"\nR_e = \"265 MPa\"\nR_m = \"410 "
          "MPa\"\nm_r = " +
          m_r + "\n";
      return found(shell("delta = \"" + delta + "\"") + flat, "flat");
    };
    CHECK(share("12 mm", "0.1") == "m_r");
    CHECK(share("12 mm", "0.9").empty());
    CHECK(share("12 mm", "\"=(shell.delta_min - 1 mm)/(shell.delta - 1 mm)\"").empty());
    CHECK(share("12 mm", "\"=0.99*(shell.delta_min - 1 mm)/(shell.delta - 1 mm)\"") == "m_r");
  }

  TEST_CASE("a wall under external pressure takes the record of the wall") {
    const std::string sizes = "D_a = \"1224 mm\"\ndelta = \"12 mm\"\nc = \"1 mm\"";
    CHECK(found(shell() + outside(sizes), "vac") == "delta");
    CHECK(found(outside(sizes), "vac").empty());
    CHECK(found(shell() + outside("D_a = \"1224 mm\"\nc = \"1 mm\""), "vac").empty());
    CHECK(found(shell() + outside("wall = \"=shell.wall\""), "vac").empty());
    CHECK(found(shell() + outside("D_a = \"1224 mm\"\ndelta = \"=shell.delta\"\nc = \"1 mm\""), "vac") == "delta");
    const auto of_step = [](const std::string& step, const std::string& D_a) {
      return found(shell() + step + outside("D_a = \"" + D_a + "\"\ndelta = \"12 mm\"\nc = \"1 mm\""), "vac");
    };
    const std::string ball =
        "[ball]\ncalculator = \"vessel.sphere\"\np = \"1 MPa\"\nR = \"612 mm\"\ndelta = \"9 mm\"\nsigma_adm = \"140 "
        "MPa\"\n";
    CHECK(of_step(ball, "=2*ball.R").empty());
    const std::string bar = "[bar]\ncalculator = \"section.rectangle\"\nb = \"1 mm\"\nh = \"1 mm\"\n";
    CHECK(of_step(bar, "=1224 mm * (bar.h/bar.b)") == "delta");
  }

  TEST_CASE("a wall without the liquid of another one of its vessel") {
    const auto wall = [](const std::string& name, const std::string& p, const std::string& more = "") {
      return "[" + name + "]\ncalculator = \"vessel.cylinder\"\np = \"" + p +
             "\"\nR = \"600 mm\"\nsigma_adm = \"140 MPa\"\n" + more + "\n";
    };
    const std::string values = "[values]\np = \"0.4 MPa\"\n\n", water = "rho = \"1000 kg/m^3\"\nh_l = \"10 m\"\n";
    const std::string held = wall("b", "=values.p", water);
    CHECK(found(values + wall("a", "=values.p") + held, "a") == "p");
    CHECK(found(values + wall("a", "=values.p", water) + held, "a").empty());
    CHECK(found(values + wall("a", "0.4 MPa") + held, "a").empty());
    CHECK(found(values + wall("a", "=values.p") + wall("b", "0.4 MPa", water), "a").empty());
    CHECK(found(wall("a", "0.4 MPa") + wall("b", "0.4 MPa", water), "a").empty());
    CHECK(found(values + wall("a", "=values.p") + wall("b", "=values.p"), "a").empty());
    CHECK(found(values + wall("a", "=values.p") + held, "b").empty());
    const std::string low = "rho = \"1000 kg/m^3\"\nh_l = \"20 mm\"\n";  // 0.2 kPa
    CHECK(found(values + wall("a", "=values.p") + wall("b", "=values.p", low), "a").empty());
  }

  TEST_CASE("an allowable stress above that of the material of the vessel") {
    const auto wall = [](const std::string& name, const std::string& p, const std::string& strength) {
      return "[" + name + "]\ncalculator = \"vessel.cylinder\"\np = \"" + p + "\"\nR = \"600 mm\"\n" + strength + "\n";
    };
    const std::string values = "[values]\np = \"0.4 MPa\"\n\n";
    const std::string of_steel = wall("b", "=values.p", "material = \"P265GH\"\nS = 1.5\n");
    const auto asked = [&](const std::string& sigma, const std::string& p = "=values.p") {
      return found(values + wall("a", p, "sigma_adm = \"" + sigma + "\"\n") + of_steel, "a");
    };
    CHECK(asked("250 MPa") == "sigma_adm");
    CHECK(asked("150 MPa").empty());
    CHECK(asked("250 MPa", "0.4 MPa").empty());
    CHECK(found(values + of_steel + wall("a", "=values.p", "sigma_adm = \"250 MPa\"\n"), "b").empty());
    const std::string plain = wall("b", "=values.p", "sigma_adm = \"100 MPa\"\n");
    CHECK(found(values + wall("a", "=values.p", "sigma_adm = \"250 MPa\"\n") + plain, "a").empty());
    const std::string taken = wall("a", "=b.p", "sigma_adm = \"250 MPa\"\n");
    CHECK(found(taken + wall("b", "0.4 MPa", "material = \"P265GH\"\nS = 1.5\n"), "a") == "sigma_adm");
    CHECK(
        found(wall("a", "0.4 MPa", "sigma_adm = \"250 MPa\"\n") + wall("b", "=a.p", "material = \"P265GH\"\nS = 1.5\n"),
              "a") == "sigma_adm");
  }
}
