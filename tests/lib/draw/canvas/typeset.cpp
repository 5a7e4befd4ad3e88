#include "lib/draw/canvas/typeset.hpp"

#include <doctest/doctest.h>

using namespace loadpath::draw;

namespace {

/// Runs as text: symbols in <>, subscripts in [].
std::string shown(std::string_view words) {
  std::string text;
  for (const Run& run : typeset(words)) {
    const bool symbol_run = run.face == Run::Face::symbol, sub = run.face == Run::Face::subscript;
    text += (symbol_run ? "<" : sub ? "[" : "") + run.text + (symbol_run ? ">" : sub ? "]" : "");
  }
  return text;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("names are set as symbols, words as words") {
    struct Row {
      const char *name, *expected;
    };
    const Row rows[] = {
        {"M", "<M>"},
        {"phi", "<φ>"},
        {"Omega", "<Ω>"},
        {"R_12", "<R>[12]"},
        {"tau_adm", "<τ>[adm]"},
        {"sigma_m1", "<σ>[−1]"},
        {"x_m1", "<x>[m1]"},
        {"K_f_t", "<K>[f,t]"},
        {"q_phi", "<q>[φ]"},
        {"A1", "<A>1"},
        {"crank", "crank"},
        {"peak of R_12 here", "peak of <R>[12] here"},
        {"a link", "a link"},
        {"12", "12"},
        {"_x", "_x"},
        {"", ""},
    };
    for (const Row& row : rows) CHECK_MESSAGE(shown(row.name) == row.expected, row.name);
  }

  TEST_CASE("a marked name is a symbol inside a longer text, other words stay as they are") {
    CHECK(shown(symbol("M") + " in N·m") == "<M> in N·m");
    CHECK(shown(symbol("design point") + " 3") == "design point 3");
  }

  TEST_CASE("screen readers get a symbol on one line") {
    CHECK(plain("tau_adm") == "τ_adm");
    CHECK(plain(symbol("phi") + " in deg") == "φ in deg");
  }

  TEST_CASE("a text is as wide as its parts, a subscript narrower than a word") {
    CHECK(width(typeset("ab cd"), 10.0) == doctest::Approx(width(typeset("ab "), 10.0) + width(typeset("cd"), 10.0)));
    CHECK(width(typeset("R_12"), 10.0) < width(typeset("R 12"), 10.0));
    CHECK(width({}, 10.0) == 0.0);
  }
}
