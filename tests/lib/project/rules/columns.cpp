// Each condition of the rules for columns next to [values] that no step takes.
#include "lib/project/references/stated/columns.hpp"

#include "tests/found/modes.hpp"
#include "tests/lib/project/rules/rows.hpp"

#include <string>

using namespace loadpath;
using namespace loadpath::test;

namespace {

void check(const std::string& steps, std::initializer_list<ValuesRow> rows) {
  check_values(&project::columns_stated_otherwise, steps, rows);
}

const std::string post =
    "[post]\ncalculator = \"column.buckling\"\nP = \"60 kN\"\nl = \"2 m\"\nends = \"pinned_pinned\"\nsection = \"HEA "
    "140\"\nmaterial = \"S235\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1.35\n";

}  // namespace

TEST_SUITE("project: columns stated otherwise") {
  TEST_CASE("an eccentricity next to a column that is not bent") {
    for (const std::string name : {"e", "e_0", "ecc", "eccentricity", "load_eccentricity"})
      check(post, {{name + " = \"40 mm\"", "P"}});
    check(post, {{"e = \"0 mm\"", ""}, {"e = 0.04", ""}, {"e_bolts = \"40 mm\"", ""}, {"e = \"-40 mm\"", "P"}});
    for (const std::string off_axis : {"e_y = \"5 mm\"\n", "e_z = \"5 mm\"\n"})
      check(post + off_axis, {{"e = \"40 mm\"", ""}});
    check(example_of("column.beam_column", "M_y_1 = \"1 kN*m\""), {{"e = \"40 mm\"", ""}});
  }

  TEST_CASE("a bending moment above that of the column") {
    for (const std::string name : {"M", "M_b", "M_max", "M_Ed", "M_d"}) check(post, {{name + " = \"5 kN*m\"", "P"}});
    check(post, {{"M_frame = \"5 kN*m\"", ""}, {"M = \"-5 kN*m\"", "P"}, {"M = 5000", ""}, {"M = \"0 N*m\"", ""}});
    const std::string bent = example_of("column.beam_column", "M_y_1 = \"4 kN*m\"\nM_y_2 = \"5 kN*m\"");
    check(bent, {{"M = \"5 kN*m\"", ""}, {"M = \"5.004 kN*m\"", ""}, {"M = \"5.01 kN*m\"", "P"}});
  }

  TEST_CASE("a stroke that is longer than the column") {
    check(post, {{"stroke = \"2.5 m\"", "l"},
                 {"stroke = \"2 m\"", ""},
                 {"stroke = \"2.001 m\"", ""},
                 {"rod_stroke = \"2.01 m\"", "l"},
                 {"stroke = 2.5", ""},
                 {"travel = \"2.5 m\"", ""}});
  }

  TEST_CASE("a length of the bar, or its effective length, above that of the column") {
    for (const std::string name : {"L", "height", "length", "clear_height", "l_0", "L_cr", "l_eff", "s_k"})
      check(post, {{name + " = \"3 m\"", "l"}, {name + " = \"2 m\"", ""}, {name + " = \"1.5 m\"", ""}});
    check(post, {{"height_building = \"12 m\"", ""}, {"l_beam = \"6 m\"", ""}, {"l_0 = 3", ""}});
    check(post, {{"beta = 2", "l"}, {"K = 2", "l"}, {"beta = 1", ""}, {"beta = 0.7", ""}, {"k = 2", ""}});
    std::string cantilever = post;
    cantilever.replace(cantilever.find("pinned_pinned"), 13, "fixed_free");
    check(cantilever, {{"L_cr = \"4 m\"", ""}, {"L_cr = \"5 m\"", "l"}, {"beta = 2", ""}});
    std::string longer = "\n[other]" + post.substr(6);
    longer.replace(longer.find("2 m"), 3, "3 m");
    check(post + longer, {{"L = \"3 m\"", ""}});
  }

  TEST_CASE("only a column with a load is compared") {
    const std::string values = "e = \"40 mm\"\nM = \"5 kN*m\"\nstroke = \"90 m\"";
    check(example_of("shaft.torsion"), {{values, ""}});
    check(example_of("chain.roller"), {{values, ""}});
    check(example_of("column.effective_length"), {{values, ""}});
  }

  TEST_CASE("the sign of a force that compresses by its name, and an eccentric link") {
    const auto tension = [](const std::string& name, const std::string& sign, const std::string& more = "") {
      const std::string rod = example_of("link.member", "N = \"=" + sign + "values." + name + "\"\n" + more);
      return inputs_found(&project::bars_in_tension, "[values]\n" + name + " = \"9 kN\"\n\n" + rod);
    };
    CHECK(tension("N_c", "") == "N");
    CHECK(tension("F_push", "") == "N");
    CHECK(tension("N_c", "-").empty());
    CHECK(tension("N_t", "").empty());
    CHECK(tension("N_c", "", "n_st =\nmethod =").empty());
    const std::string link = example_of("link.member", "N = \"-18 kN\"\nM_b = \"60 N*m\"");
    check_values(&project::eccentric_links, link,
                 {{"e_offset = \"10 mm\"", "M_b"}, {"e_offset = \"3 mm\"", ""}, {"e = 10", ""}});
  }
}

TEST_SUITE("project: bounds of links") {
  TEST_CASE("the ends of a link are not those of a column with a load of [values]") {
    const auto state = [](const std::string& P) {
      return mode_of(
          solved_as_found(
              "[values]\nP = \"10 kN\"\n\n[c]\ncalculator = \"column.buckling\"\nP = \"" + P +
              "\"\nl = \"900 mm\"\nh = \"28 mm\"\nb = \"20 mm\"\nends_y = \"fixed_pinned\"\nends_z = "
              "\"fixed_fixed\"\nbeta_basis = \"recommended\"\nmaterial = \"S355\"\nmethod = \"johnson\"\nn_st = 3\n"),
          "c", "buckling");
    };
    CHECK(state("=values.P") == state("10 kN"));
    CHECK(state("=values.P") == "pass");
  }
}
