// Each condition of the rules for partial factors in the formulas of loads.
#include "lib/project/references/actions/partial_factors.hpp"

#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

const std::string actions =
    "G = \"120 kN\"\nQ = \"90 kN\"\nG_k = \"120 kN\"\nQ_k = \"90 kN\"\nH_k = \"6 kN\"\ndead = \"120 kN\"\nlive = "
    "\"90 kN\"\ndead_Ed = \"160 kN\"\nF_x = \"80 kN\"\nF_y = \"60 kN\"\nL = \"4 m\"\nn = 2\ng_Q = 1.5\ngamma_G = "
    "1.35\ngamma_Q = 1.5\ngamma_inf = 1\npsi_snow = 0.5\npsi_wind = 0.6\npsi_0 = 0.6\n";

std::string column(const std::string& P, const std::string& M_y, const std::string& gamma_F) {
  return "[c]\ncalculator = \"column.beam_column\"\nP = \"" + P + "\"\nM_y = \"" + M_y +
         "\"\nl = \"4 m\"\nends = \"pinned_pinned\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = " + gamma_F +
         "\nmaterial = \"S235JR\"\nsection = \"HEB 160\"\n";
}

std::string found(const std::string& P, const std::string& M_y = "2 kN*m", const std::string& gamma_F = "1") {
  INFO(P << " " << M_y);
  return inputs_found(&project::partial_factors_of_loads, "[values]\n" + actions + "\n" + column(P, M_y, gamma_F));
}

}  // namespace

TEST_SUITE("project: partial factors in loads") {
  TEST_CASE("a term without a partial factor next to one with it") {
    for (const std::string P : {"=1.35*values.G + values.Q", "=values.Q + 1.35*values.G",
                                "=1.35*values.G + 0.15*values.Q", "=values.gamma_G*values.G + values.Q"})
      CHECK_MESSAGE(found(P) == "P", P);
    for (const std::string P :
         {"=1.35*values.G + 1.5*values.Q", "=1.35*values.G + 1.5*0.7*values.Q", "=values.G + values.Q",
          "=1.35*values.G + values.g_Q*values.Q", "=1.35*(values.G + values.Q)",
          "=values.gamma_G*values.G + values.gamma_Q*values.Q", "=1.35*values.G + 1.5*values.Q - values.G"})
      CHECK_MESSAGE(found(P).empty(), P);
  }

  TEST_CASE("characteristic values alone") {
    CHECK(found("=values.G_k + values.Q_k") == "P");
    CHECK(found("=values.dead + values.live") == "P");
    CHECK(found("=values.dead + values.live", "2 kN*m", "1.5").empty());
    CHECK(found("=values.dead_Ed").empty());
    CHECK(found("=1.35*values.G_k + 1.5*values.Q_k").empty());
    CHECK(found("=(1.35*values.G_k + 1.5*values.Q_k)/values.n").empty());
    CHECK(found("=(values.G_k + values.Q_k)/values.n") == "P");
  }

  TEST_CASE("the moment of a characteristic value") {
    CHECK(found("300 kN", "=values.H_k*values.L/4") == "M_y");
    CHECK(found("300 kN", "=values.H_k*values.L/4", "1.5").empty());
    CHECK(found("300 kN", "=values.gamma_Q*values.H_k*values.L/4").empty());
    CHECK(found("300 kN", "=0.375*values.H_k*values.L").empty());  // 1.5/4
    CHECK(found("300 kN", "=values.F_x*values.L/40").empty());
  }

  TEST_CASE("an action subtracted with a partial factor") {
    CHECK(found("=values.gamma_G*values.G_k - values.gamma_Q*values.Q_k") == "P");
    CHECK(found("=1.35*values.G_k - 1.5*values.Q_k") == "P");
    CHECK(found("=1.5*values.G_k - values.gamma_inf*values.Q_k").empty());
    CHECK(found("=1.5*values.G_k - values.Q_k").empty());
    CHECK(found("=1.5*values.G_k - 0.9*values.Q_k").empty());
  }

  TEST_CASE("the root of squares of vertical actions") {
    CHECK(found("=hypot(1.35*values.G, 1.5*values.Q)") == "P");
    CHECK(found("=hypot(values.gamma_G*(values.dead), values.gamma_Q*values.live)") == "P");
    CHECK(found("=hypot(1.5*values.F_x, 1.5*values.F_y)").empty());
    CHECK(found("=hypot(1.35*values.G, 1.5*values.H_k)").empty());
  }

  TEST_CASE("the combination factor of another action") {
    CHECK(found("300 kN", "=1.5*values.psi_snow*values.H_k*values.L/4") == "M_y");
    CHECK(found("=1.5*values.psi_wind*values.G") == "P");
    CHECK(found("=1.5*values.psi_snow*values.Q").empty());
    CHECK(found("300 kN", "=1.5*values.psi_wind*values.H_k*values.L/4").empty());
    CHECK(found("300 kN", "=1.5*values.psi_0*values.H_k*values.L/4").empty());
  }
}
