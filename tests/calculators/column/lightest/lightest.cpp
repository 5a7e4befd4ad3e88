#include "calculators/column/lightest/lightest.hpp"

#include "calculators/column/lightest/families.hpp"
#include "tests/calculators/column/models.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using column::Ends;
using column::Method;
using loadpath::test::replaced;
using Failure = column::Lightest::Failure;

/// A hinged column of S235 by EN 1993-1-1, without partial factors.
column::Lightest::Input column_of(std::initializer_list<const char*> families, Force P, Length l) {
  column::Lightest::Input in;
  for (const char* family : families) in.families.push_back({family});
  in.P = P, in.l = l;
  in.ends = Ends::pinned_pinned;
  in.E = 210.0 * GPa, in.R_e = 235.0 * MPa;
  in.method = Method::ec3;
  in.gamma_M1 = in.gamma_F = 1.0;
  return in;
}

column::Lightest::Result solve(const column::Lightest::Input& in) {
  NoTrace trace;
  return column::Lightest::evaluate(in, trace);
}

const column::TableSection& section_of(std::string_view name) {
  const auto& all = column::sections_by_mass();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name() == name; });
  REQUIRE(found != all.end());
  return *found;
}

/// W4X13 is of W and of W4, W40X149 of W and of W40, SHS 100x5 of SHS and of SHS100.
bool is_of(std::string name, std::string_view family) {
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  if (name.substr(0, family.size()) != family) return false;
  const std::string rest = name.substr(family.size());
  const bool is_word = family.find_first_of("0123456789") == family.npos;
  return rest.empty() || is_word != (std::string_view("0123456789.").find(rest.front()) == std::string_view::npos);
}

/// Result of column.buckling for a section.
column::MemberResult judged(const column::Lightest::Input& in, std::string_view section) {
  return tests::solve({in, section_of(section)});
}

const std::string text =
    "calculator = \"column.lightest\"\nP = \"900 kN\"\nl = \"4.5 m\"\nends = \"pinned_pinned\"\nmaterial = \"S235\"\n"
    "method = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\n";

bool says(const std::string& lines, std::string_view words) {
  const std::string said = complaints(lines);
  INFO(said);
  const bool found = said.find(words) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_SUITE("column lightest") {
  TEST_CASE("the section, its force and the next lighter section are those of an independent search") {
    struct Row {
      std::initializer_list<const char*> families;
      double P, l, R_e, beta_z;
      const char *section, *lighter;
      double P_all, P_lighter;
    };
    for (const Row& row : {Row{{"HEA", "IPE"}, 900, 4.5, 235, 1, "HEA 220", "IPE 330", 935.655157, 593.4},
                           Row{{"HEB"}, 2000, 8, 235, 0.7, "HEB 300", "HEB 280", 2348.849194, 1963.6},
                           Row{{"IPE"}, 300, 3, 235, 0.5, "IPE 160", "IPE 140", 322.381139, 238.9},
                           Row{{"SHS"}, 500, 4, 355, 1, "SHS 140x140x5", "SHS 90x90x8", 662.324338, 309.5},
                           Row{{"HEB"}, 3326, 7, 275, 1, "HEB 500", "HEB 450", 3478.142715, 3209.7}}) {
      CAPTURE(row.section);
      auto in = column_of(row.families, row.P * kN, row.l * m);
      in.R_e = row.R_e * MPa;
      in.ends = Ends::unsaid, in.beta_y = 1.0, in.beta_z = row.beta_z;
      const auto r = solve(in);
      CHECK(r.section.view() == row.section);
      CHECK(rel(in_si(r.P_all), 1e3 * row.P_all) < 1e-8);
      REQUIRE(!r.lighter.empty());
      CHECK(r.lighter[0].name.view() == row.lighter);
      CHECK(std::abs(in_si(r.lighter[0].P_all) - 1e3 * row.P_lighter) < 51.0);
      CHECK(r.lighter[0].failure == Failure::load);
    }
  }

  TEST_CASE("the section found passes column.buckling, the lighter ones do not") {
    for (const double P : {50.0, 200.0, 800.0, 2500.0}) {
      const auto in = column_of({"IPE", "HEA", "HEB", "RHS", "L"}, P * kN, 4.0 * m);
      const auto r = solve(in);
      CAPTURE(r.section.view());
      REQUIRE(r.carrying > 0.0);
      const auto whole = judged(in, r.section.view());
      CHECK(whole.u == r.u);
      CHECK(whole.u <= 1.0);
      CHECK(whole.r_lambda <= 1.0);
      CHECK(whole.r_class <= 1.0);
      for (const auto& c : r.lighter) {
        CAPTURE(c.name.view());
        const auto other = judged(in, c.name.view());
        CHECK(rel(in_si(other.P_all), in_si(c.P_all)) < 1e-12);
        CHECK((other.u > 1.0 || other.r_lambda > 1.0 || other.r_class > 1.0));
        CHECK(c.demand > 1.0);
        CHECK(c.q <= r.q);
        CHECK(c.excess <= 0.0);
      }
    }
  }

  TEST_CASE("of all rows of the families no lighter one passes column.buckling, by several methods") {
    struct Row {
      std::initializer_list<const char*> families;
      double P, l;
      Method method;
    };
    for (const Row& row :
         {Row{{"IPE", "UPN"}, 60, 2, Method::ec3}, Row{{"HEA", "L"}, 350, 5, Method::ec3},
          Row{{"SHS", "RHS"}, 150, 3, Method::johnson}, Row{{"W", "HEB"}, 2500, 6, Method::johnson},
          Row{{"UPN"}, 5000, 9, Method::ec3}, Row{{"W14"}, 2300, 6, Method::ec3},
          Row{{"W4", "IPE300"}, 100, 2, Method::ec3}, Row{{"HSS8X8", "SHS100x100"}, 900, 5, Method::ec3}}) {
      auto in = column_of(row.families, row.P * kN, row.l * m);
      in.method = row.method;
      if (row.method == Method::johnson) in.n_st = 3.0;
      const auto r = solve(in);
      const auto passes = [&](const column::TableSection& section) {
        const auto member = judged(in, section.name());
        return member.u <= 1.0 && !(member.r_lambda > 1.0) && !(member.r_class > 1.0);
      };
      const auto is_in = [&](const column::TableSection& section) {
        return std::any_of(row.families.begin(), row.families.end(),
                           [&](std::string_view family) { return is_of(std::string(section.name()), family); });
      };
      const auto& all = column::sections_by_mass();  // ascending
      const auto first =
          std::find_if(all.begin(), all.end(), [&](const auto& section) { return is_in(section) && passes(section); });
      CAPTURE(r.section.view());
      CHECK((first == all.end()) == (r.carrying == 0.0));
      if (first != all.end()) CHECK(rel(in_si(r.q), in_si(first->m)) < 1e-12);
    }
  }

  TEST_CASE("the list has the sections that carry the load, the lightest first") {
    const auto r = solve(column_of({"HEA", "HEB"}, 900.0 * kN, 4.5 * m));
    REQUIRE(r.candidates.size() == column::Lightest::Candidates::capacity());
    CHECK(r.candidates[0].name == r.section);
    CHECK(r.candidates[0].excess == 0.0);
    for (std::size_t i = 0; i < r.candidates.size(); ++i) {
      CHECK(r.candidates[i].demand <= 1.0);
      CHECK(r.candidates[i].failure == Failure::none);
      if (i > 0) CHECK(r.candidates[i].q >= r.candidates[i - 1].q);
    }
    CHECK(r.sections == 48.0);
    CHECK(rel(in_si(r.mass), 50.5 * 4.5) < 1e-12);
  }

  TEST_CASE("a heavier load never gives a lighter section, nor does a longer bar") {
    double before = 0.0;
    for (double P = 10.0; P < 4000.0; P *= 1.15) {
      const double q = in_si(solve(column_of({"HEA", "IPE", "SHS"}, P * kN, 4.0 * m)).q);
      CHECK(q >= before);
      before = q;
    }
    before = 0.0;
    for (double l = 0.5; l < 10.0; l += 0.5) {
      const double q = in_si(solve(column_of({"HEA", "IPE", "SHS"}, 500.0 * kN, l * m)).q);
      CHECK(q >= before);
      before = q;
    }
  }

  TEST_CASE("one more section family never makes it heavier") {
    const auto one = solve(column_of({"IPE"}, 400.0 * kN, 3.5 * m));
    const auto two = solve(column_of({"IPE", "SHS"}, 400.0 * kN, 3.5 * m));
    CHECK(two.q < one.q);
    CHECK(two.sections > one.sections);
  }

  TEST_CASE("where space is limited only sections that fit are tried") {
    auto in = column_of({"HEB", "HEM"}, 1500.0 * kN, 4.0 * m);
    const auto free = solve(in);
    in.h_max = in.b_max = 220.0 * mm;
    const auto tight = solve(in);
    CHECK(section_of(tight.section.view()).h <= in.h_max);
    CHECK(section_of(tight.section.view()).b <= in.b_max);
    CHECK(tight.q >= free.q);
    CHECK(tight.sections < free.sections);
  }

  TEST_CASE("supports between the ends are evaluated once, and apply to every section") {
    auto in = column_of({"IPE"}, 300.0 * kN, 3.0 * m);
    in.supports_z.push_back({1.5 * m});
    const auto r = solve(in);
    CHECK(r.section.view() == "IPE 160");
    CHECK(rel(in_si(r.P_all), 322.381139e3) < 1e-8);
    for (const auto& c : r.lighter) CHECK(rel(in_si(judged(in, c.name.view()).P_all), in_si(c.P_all)) < 1e-12);
  }

  TEST_CASE("a slenderness limit applies to bars in compression: a tie needs the area only") {
    auto in = column_of({"L"}, 0.0 * kN, 3.0 * m);
    const auto fails_by_slenderness = [](const auto& r) {
      return std::any_of(r.lighter.begin(), r.lighter.end(),
                         [](const auto& c) { return c.failure == Failure::slenderness; });
    };
    in.P = 0.001 * kN;
    const auto pressed = solve(in);
    CHECK(pressed.lambda <= 200.0);
    CHECK(fails_by_slenderness(pressed));
    in.P = unset<Force>, in.N = 20.0 * kN;
    const auto pulled = solve(in);
    CHECK(pulled.u == 0.0);
    CHECK(pulled.lambda > 200.0);
    CHECK_FALSE(fails_by_slenderness(pulled));
    const auto& all = column::sections_by_mass();  // the first whose area does not yield
    const auto first = std::find_if(all.begin(), all.end(), [](const auto& s) {
      return column::family_of(s.name()) == "L" && in_si(s.A) * 235e6 >= 20e3;
    });
    REQUIRE(first != all.end());
    CHECK(pulled.section.view() == std::string_view(first->name()));
  }

  TEST_CASE("a bar under high tension needs the area") {
    auto in = column_of({"HEB"}, 0.0 * kN, 3.0 * m);
    in.P = unset<Force>, in.N = 6000.0 * kN;
    const auto r = solve(in);
    CHECK(r.section.view() == "HEB 600");  // 270.0 cm^2; 6 MN/235 MPa are 255.3 cm^2
    CHECK(rel(r.x_t, 6e6 / 270.0e-4 / 235e6) < 1e-3);
    REQUIRE(!r.lighter.empty());
    CHECK(r.lighter[0].name.view() == "HEB 550");
    for (const auto& c : r.lighter) {
      CHECK(c.failure == Failure::tension);
      CHECK(c.demand > 1.0);
    }
    CHECK(column::Lightest::strength_in_tension(in));
    in.R_e = unset<Stress>;
    CHECK(!column::Lightest::strength_in_tension(in));
  }

  TEST_CASE("round tubes that the table does not mark as hot or cold formed have the less favourable curve") {
    auto in = column_of({"CHS"}, 300.0 * kN, 4.0 * m);
    const auto open = solve(in);
    in.kind = SectionKind::hot_hollow;
    const auto hot = solve(in);
    in.kind = SectionKind::cold_hollow;
    const auto cold = solve(in);
    CHECK(hot.carrying > 0.0);
    CHECK(hot.q < cold.q);
    CHECK(open.q == cold.q);
    in.families.push_back({"IPE"});
    CHECK(solve(in).q == cold.q);  // the kind of rows that have one stays theirs
  }

  TEST_CASE("beyond the table of SP 16 the kind of section is not asked for") {
    auto in = column_of({"HEA"}, 1.0 * kN, 60.0 * m);
    in.method = Method::sp16, in.n_st = 2.0;
    const auto r = solve(in);
    CHECK(r.carrying == 0.0);
    for (const auto& c : r.lighter) CHECK(c.failure == Failure::beyond);
    const FieldFault fault = column::Lightest::none_carries(in);
    CHECK(fault.message.text().find("slenderness beyond the code table") != std::string::npos);
    CHECK(fault.hint.text().find("kind") == std::string::npos);
  }

  TEST_CASE("a tube counts as thin by its diameter over its wall: 90 eps^2") {
    auto in = column_of({"CHS"}, 300.0 * kN, 4.0 * m);
    in.kind = SectionKind::hot_hollow;
    column::Buckling::Input bar{in, section_of("CHS 76.1x2.5")};
    bar.kind = SectionKind::hot_hollow;
    CHECK(rel(tests::solve(bar).r_class, 76.1 / 2.5 / 90.0) < 1e-12);
  }

  TEST_CASE("where no section carries the load, the shortfall of the strongest is reported") {
    const std::string heavy = "families = [\"IPE\"]\n" + text;
    CHECK(complaints("families = [\"HEA\"]\n" + text).empty());
    std::string lines = heavy;
    lines.replace(lines.find("900 kN"), 6, "9 MN");
    says(lines, "no section of IPE carries 9000 kN; the strongest is IPE 600");
    const auto r = solve(column_of({"IPE"}, 9000.0 * kN, 4.5 * m));
    CHECK(r.carrying == 0.0);
    CHECK(r.candidates.empty());
    CHECK(r.section.view() == "IPE 600");
    CHECK(r.u > 1.0);
    CHECK(rel(r.lack, 1.0 - 1.0 / r.u) < 1e-12);
    says("families = [\"IPE\"]\nh_max = \"50 mm\"\n" + text, "no section of IPE fits within h_max = 50 mm");
    says("families = [\"IPE\"]\nh_max = \"50 mm\"\nb_max = \"20 mm\"\n" + text,
         "no section of IPE fits within h_max = 50 mm, b_max = 20 mm");
  }

  TEST_CASE("each section has the strength of its own thickness, as when assessed singly") {
    struct Row {
      const char *families, *P, *section;
    };
    for (const Row& row : {Row{"\"HEA\", \"HEB\", \"RHS\"", "900 kN", ""}, Row{"\"HEA\", \"HEB\"", "3.2 MN", ""},
                           Row{"\"HEB\", \"HEM\"", "6 MN", ""}, Row{"\"CHS\"", "2694 kN", "CHS 457x16"}}) {
      CAPTURE(row.P);
      std::string lines = std::string("families = [") + row.families + "]\n" + text;
      lines = replaced(lines, "900 kN", row.P);
      if (*row.section != '\0') {
        lines = replaced(replaced(lines, "ec3", "johnson"), "gamma_M1 = 1\ngamma_F = 1\n", "n_st = 2\n");
        lines = replaced(replaced(lines, "4.5 m", "8.683 m"), "S235", "S275");
      }
      std::vector<Issue> issues;
      const auto project = solved("[bar]\n" + lines, issues);
      REQUIRE(issues.empty());
      const auto& results = project.find("bar")->account().results;
      const auto name = std::find_if(results.begin(), results.end(), [](const auto& e) { return e.path == "section"; });
      REQUIRE(name != results.end());
      if (*row.section != '\0') CHECK(name->word == row.section);
      const std::string alone = "[bar]\ncalculator = \"column.buckling\"\nsection = \"" + name->word + "\"\n" +
                                lines.substr(lines.find("P = "));
      const auto checked = solved(alone, issues);
      REQUIRE(issues.empty());
      for (const char* same : {"bar.t", "bar.R_e", "bar.u"})
        CHECK(project.value(same)->si[0] == checked.value(same)->si[0]);
      CHECK(project.value("bar.u")->si[0] <= 1.0);
    }
  }

  TEST_CASE("strengths by thickness: typed in place of R_e, ascending, and no section beyond them is assessed") {
    const std::string bar = replaced(text, "material = \"S235\"\n", "E = \"210 GPa\"\n") + "families = [\"HEM\"]\n";
    const std::string thin = "strengths = [[\"16 mm\", \"235 MPa\"], [\"40 mm\", \"225 MPa\"]]\n";
    CHECK(complaints(bar + thin).empty());
    says(bar + thin + "R_e = \"355 MPa\"\n", "give R_e, or strengths by thickness, not both");
    says(bar + "strengths = [[\"40 mm\", \"225 MPa\"], [\"16 mm\", \"235 MPa\"]]\n", "must increase");
    says(bar + "strengths = [[\"10 mm\", \"235 MPa\"]]\n", "no strength given for its thickness");
    says(replaced(bar + "strengths = [[\"20 mm\", \"235 MPa\"]]\n", "900 kN", "5 MN"),
         "no section of HEM whose strength is given carries 5000 kN");
    std::vector<Issue> issues;
    const auto typed = solved("[bar]\n" + bar + thin, issues),
               named = solved("[bar]\n" + text + "families = [\"HEM\"]\n", issues);
    REQUIRE(issues.empty());
    CHECK(typed.value("bar.u")->si[0] == doctest::Approx(named.value("bar.u")->si[0]));
  }

  TEST_CASE("Euler's formula ends where sections are stocky: this is reported, not that they are too weak") {
    auto in = column_of({"HEA"}, 300.0 * kN, 3.0 * m);
    in.method = Method::euler, in.R_e = unset<Stress>;
    in.sigma_P = 200.0 * MPa, in.n_st = 3.0;
    const auto r = solve(in);
    CHECK(r.carrying == 0.0);
    CHECK(r.r_1 > 1.0);
    CHECK(column::Lightest::none_carries(in).message.text() == "no section of HEA carries the bar; nearest is " +
                                                                   std::string(r.section.view()) +
                                                                   ": outside the range of the method");
  }

  TEST_CASE("wrong input is reported at its place") {
    says("families = [\"IPE\", \"IPX\"]\n" + text, "families[2].family: unknown family 'IPX' in the section tables");
    says("families = [\"W15\"]\n" + text, "families[1].family: unknown family 'W15' in the section tables");
    says("families = [\"HEA1\"]\n" + text, "families[1].family: unknown family 'HEA1' in the section tables");
    says("families = [\"W14\", \"W\"]\n" + text, "families[1].family: the sections 'W14' are part of the family 'W'");
    says(text, "'families' is missing");
    says("families = [\"IPE\", \"HEA\", \"IPE\"]\n" + text, "families[3].family: the family 'IPE' is named twice");
    says("families = [\"CHS\"]\nkind = \"rolled_I\"\n" + text,
         "kind: round tubes must be hot_hollow or cold_hollow, not rolled_I");
    says("families = [\"HEA\"]\nkind = \"rolled_I\"\n" + text, "'kind' has no effect here");
    says("families = [\"HEA\", \"UPN\"]\ne_z = \"5 mm\"\n" + text,
         "the extreme fibre of UPN 80 is not at half the side");
    CHECK(complaints("families = [\"HEA\"]\ne_z = \"5 mm\"\n" + text).empty());
    says("families = [\"HEA\"]\nmaterial_class = \"wood\"\n" + text, "the method 'ec3' is for steel");
    std::string pulled = "families = [\"HEA\"]\nE = \"210 GPa\"\nsigma_P = \"200 MPa\"\nn_st = 2\n" + text;
    pulled.replace(pulled.find("P = \"900"), 1, "N");
    pulled.replace(pulled.find("material = \"S235\"\n"), 18, "");
    pulled.replace(pulled.find("ec3"), 3, "euler");
    says(pulled, "a bar in tension is assessed by its yield strength");
    std::string unloaded = "families = [\"IPE\"]\n" + text;
    unloaded.erase(unloaded.find("P = "), 13);
    says(unloaded, "give the force on the bar");
    std::string factors = "families = [\"IPE\"]\n" + text;
    factors.erase(factors.find("gamma_M1"), 13);
    says(factors, "partial factors of EN 1993-1-1 assumed: gamma_M1 = 1.0");
  }

  TEST_CASE("the family of a row is the beginning of its name") {
    CHECK(column::family_of("IPE 200") == "IPE");
    CHECK(column::family_of("W4X13") == "W");
    CHECK(column::family_of("L 20x20x3") == "L");
    CHECK(column::families().size() == 17);
  }
}
