#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace loadpath::formula;

TEST_SUITE("formula") {
  TEST_CASE("a name becomes the technical symbol in three notations") {
    struct Row {
      std::string_view name, plain, tex, html;
    };
    for (const Row& row : std::vector<Row>{{"d", "d", "d", "𝑑"},
                                           {"tau_adm", "τ_adm", "\\tau_{\\mathrm{adm}}", "𝜏<sub>adm</sub>"},
                                           {"d_i", "d_i", "d_{i}", "𝑑<sub>𝑖</sub>"},
                                           {"sigma_m1", "σ_−1", "\\sigma_{-1}", "𝜎<sub>−1</sub>"},
                                           {"d_m1", "d_m1", "d_{m1}", "𝑑<sub>𝑚1</sub>"},
                                           {"sigma_v_max", "σ_v,max", "\\sigma_{v,\\mathrm{max}}", "𝜎<sub>𝑣,max</sub>"},
                                           {"R_12", "R_12", "R_{12}", "𝑅<sub>12</sub>"},
                                           {"d1", "d_1", "d_{1}", "𝑑<sub>1</sub>"},
                                           {"R_p02", "R_p0.2", "R_{p0.2}", "𝑅<sub>𝑝0.2</sub>"},
                                           {"beta_sigma", "β_σ", "\\beta_{\\sigma}", "𝛽<sub>𝜎</sub>"},
                                           {"x_sigma1", "x_σ1", "x_{\\sigma 1}", "𝑥<sub>𝜎1</sub>"},
                                           {"theta", "θ", "\\theta", "𝜃"},
                                           {"phi", "φ", "\\varphi", "𝜑"},
                                           {"chi", "χ", "\\chi", "𝜒"},
                                           {"Delta_T", "Δ_T", "\\Delta_{T}", "𝛥<sub>𝑇</sub>"},
                                           {"Sigma", "Σ", "\\Sigma", "𝛴"},
                                           {"Re", "Re", "\\mathrm{Re}", "Re"},
                                           {"a<b", "a<b", "\\mathrm{ab}", "a&lt;b"},
                                           {"D_star", "D*", "D^{\\ast}", "𝐷<sup>*</sup>"},
                                           {"d_", "d", "d", "𝑑"}}) {
      CAPTURE(row.name);
      CHECK(symbol_plain(row.name) == row.plain);
      CHECK(symbol_tex(row.name) == row.tex);
      CHECK(symbol_html(row.name) == row.html);
    }
  }
}
