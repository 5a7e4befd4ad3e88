#include "lib/formula/formula.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace loadpath::formula;

TEST_SUITE("formula") {
  TEST_CASE("a name becomes the technical symbol in three notations") {
    struct Row {
      std::string_view name, plain, tex, mathml;
    };
    for (const Row& row : std::vector<Row>{
             {"d", "d", "d", "<mi>d</mi>"},
             {"tau_adm", "τ_adm", "\\tau_{\\mathrm{adm}}", "<msub><mi>τ</mi><mi>adm</mi></msub>"},
             {"d_i", "d_i", "d_{i}", "<msub><mi>d</mi><mi>i</mi></msub>"},
             {"sigma_m1", "σ_−1", "\\sigma_{-1}", "<msub><mi>σ</mi><mn>−1</mn></msub>"},
             {"d_m1", "d_m1", "d_{m1}", "<msub><mi>d</mi><mrow><mi>m</mi><mn>1</mn></mrow></msub>"},
             {"sigma_v_max", "σ_v,max", "\\sigma_{v,\\mathrm{max}}",
              "<msub><mi>σ</mi><mrow><mi>v</mi><mo>,</mo><mi>max</mi></mrow></msub>"},
             {"R_12", "R_12", "R_{12}", "<msub><mi>R</mi><mn>12</mn></msub>"},
             {"d1", "d_1", "d_{1}", "<msub><mi>d</mi><mn>1</mn></msub>"},
             {"R_p02", "R_p0.2", "R_{p0.2}", "<msub><mi>R</mi><mrow><mi>p</mi><mn>0.2</mn></mrow></msub>"},
             {"beta_sigma", "β_σ", "\\beta_{\\sigma}", "<msub><mi>β</mi><mi>σ</mi></msub>"},
             {"x_sigma1", "x_σ1", "x_{\\sigma 1}", "<msub><mi>x</mi><mrow><mi>σ</mi><mn>1</mn></mrow></msub>"},
             {"theta", "θ", "\\theta", "<mi>θ</mi>"},
             {"phi", "φ", "\\varphi", "<mi>φ</mi>"},
             {"chi", "χ", "\\chi", "<mi>χ</mi>"},
             {"Delta_T", "Δ_T", "\\Delta_{T}", "<msub><mi>Δ</mi><mi>T</mi></msub>"},
             {"Sigma", "Σ", "\\Sigma", "<mi>Σ</mi>"},
             {"Re", "Re", "\\mathrm{Re}", "<mi>Re</mi>"},
             {"a<b", "a<b", "\\mathrm{ab}", "<mi>a&lt;b</mi>"},
             {"D_star", "D*", "D^{\\ast}", "<msup><mi>D</mi><mo>*</mo></msup>"},
             {"d_", "d", "d", "<mi>d</mi>"}}) {
      CAPTURE(row.name);
      CHECK(symbol_plain(row.name) == row.plain);
      CHECK(symbol_tex(row.name) == row.tex);
      CHECK(symbol_mathml(row.name) == row.mathml);
    }
  }
}
