// Sizes of a free section that are searched for: against every size of the stock, each given as a literal.
#include "tests/calculators/column/models.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::tests;

constexpr std::array r40{1.0,  1.06, 1.12, 1.18, 1.25, 1.32, 1.4,  1.5,  1.6,  1.7,  1.8, 1.9,  2.0, 2.12,
                         2.24, 2.36, 2.5,  2.65, 2.8,  3.0,  3.15, 3.35, 3.55, 3.75, 4.0, 4.25, 4.5, 4.75,
                         5.0,  5.3,  5.6,  6.0,  6.3,  6.7,  7.1,  7.5,  8.0,  8.5,  9.0, 9.5};
constexpr std::array r20{1.0,  1.12, 1.25, 1.4, 1.6, 1.8, 2.0, 2.24, 2.5, 2.8,
                         3.15, 3.55, 4.0,  4.5, 5.0, 5.6, 6.3, 7.1,  8.0, 9.0};

/// Of both decades, mm.
template <std::size_t n>
std::vector<double> sizes_of(const std::array<double, n>& decade, double low, double high) {
  std::vector<double> sizes;
  for (const double ten : {0.1, 1.0, 10.0, 100.0}) {
    for (const double size : decade) {
      if (size * ten >= low && size * ten <= high) sizes.push_back(size * ten);
    }
  }
  return sizes;
}

std::string bar(const std::string& lines) {
  return "[bar]\ncalculator = \"column.buckling\"\nl = \"1.2 m\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\n"
         "R_e = \"235 MPa\"\nP = \"60 kN\"\nmethod = \"johnson\"\nn_st = 3\n" +
         lines;
}

std::string line(const std::string& key, double mm) { return key + " = \"" + std::to_string(mm) + " mm\"\n"; }

/// Whether every mode that a size decides passes; an input that is refused does not.
bool is_sound(const std::string& text) {
  std::vector<Issue> issues;
  const project::Project project = solved(text, issues);
  if (has_errors(issues)) return false;
  for (const char* mode : {"buckling", "slenderness"}) {
    if (test::mode_of(project, "bar", mode) != "pass") return false;
  }
  const std::string local = test::mode_of(project, "bar", "local");
  return local == "pass" || local == "none";
}

double found(const project::Project& project, const std::string& key) {
  const Value* const value = project.value("bar." + key);
  REQUIRE(value != nullptr);
  return value->si[0] * 1e3;
}

/// The smallest of the stock that passes as a literal.
double least_of(const std::vector<double>& stock, const std::string& key, const std::string& others) {
  const auto first =
      std::find_if(stock.begin(), stock.end(), [&](double mm) { return is_sound(bar(others + line(key, mm))); });
  return first == stock.end() ? 0.0 : *first;
}

/// Utilisation of a rectangle by Johnson and Euler, computed here, in N and mm.
double utilisation_of_rectangle(double h, double b, double P, double l, double n) {
  const double lambda = l / (std::min(h, b) / std::sqrt(12.0)), E = 210e3, R_e = 235.0;
  const double change = std::sqrt(2.0 * pi * pi * E / R_e);
  const double sigma =
      lambda > change ? pi * pi * E / (lambda * lambda) : R_e * (1.0 - R_e * lambda * lambda / (4.0 * pi * pi * E));
  return lambda > 200.0 ? 2.0 : P * n / (sigma * h * b);
}

}  // namespace

TEST_SUITE("column sizing") {
  TEST_CASE("a side, a diameter or a wall is the smallest of the stock that passes") {
    struct Row {
      const char *key, *others;
      std::vector<double> stock;
    };
    const std::vector<double> sides = sizes_of(r40, 1.0, 400.0), walls = sizes_of(r20, 0.5, 100.0);
    for (const Row& row : {Row{"h", "b = \"40 mm\"\n", sides}, Row{"b", "h = \"60 mm\"\n", sides}, Row{"d", "", sides},
                           Row{"d", "t_w = \"4 mm\"\n", sides}, Row{"t_w", "d = \"60 mm\"\n", walls},
                           Row{"t_w", "h = \"60 mm\"\nb = \"40 mm\"\nkind = \"cold_hollow\"\n", walls},
                           Row{"h", "b = \"40 mm\"\nt_w = \"5 mm\"\nkind = \"cold_hollow\"\n", sides}}) {
      CAPTURE(row.key);
      CAPTURE(row.others);
      const double least = least_of(row.stock, row.key, row.others);
      REQUIRE(least > 0.0);
      const auto project = test::solved_as_found(bar(std::string(row.others) + row.key + " = \"?\"\n"));
      CHECK(found(project, row.key) == doctest::Approx(least).epsilon(1e-9));
      CHECK(is_sound(bar(std::string(row.others) + line(row.key, least))));
    }
  }

  TEST_CASE("height and width together give the rectangle of least area in the stock") {
    double least = 1e9;
    const std::vector<double> sides = sizes_of(r40, 1.0, 400.0);
    for (const double h : sides) {
      for (const double b : sides) {
        if (h * b < least && utilisation_of_rectangle(h, b, 60e3, 1200.0, 3.0) <= 1.0) least = h * b;
      }
    }
    const auto project = test::solved_as_found(bar("h = \"?\"\nb = \"?\"\n"));
    CHECK(found(project, "h") * found(project, "b") == doctest::Approx(least).epsilon(1e-9));
    CHECK(is_sound(bar(line("h", found(project, "h")) + line("b", found(project, "b")))));
  }

  TEST_CASE("a tube found with its wall has less area than any with a diameter near it") {
    const auto project = test::solved_as_found(bar("d = \"?\"\nt_w = \"?\"\n"));
    const double d = found(project, "d"), t = found(project, "t_w"), area = found(project, "A") * 1e3;
    CHECK(is_sound(bar(line("d", d) + line("t_w", t))));
    CHECK(area == doctest::Approx(pi * t * (d - t)).epsilon(1e-9));
    const std::vector<double> walls = sizes_of(r20, 0.5, 20.0);
    for (const double other : sizes_of(r40, 0.7 * d, 1.4 * d)) {
      const double wall = least_of(walls, "t_w", line("d", other));
      if (wall > 0.0) CHECK(pi * wall * (other - wall) >= area * (1.0 - 1e-9));
    }
  }

  TEST_CASE("a size is not searched for where the section is given in another way") {
    const std::string typed = "A = \"3880 mm^2\"\nI_y = \"1673 cm^4\"\nI_z = \"616 cm^4\"\n";
    for (const char* size : {"h = \"?\"\n", "b = \"?\"\n", "t_w = \"?\"\n", "d = \"?\"\n"}) {
      CAPTURE(size);
      for (const std::string& section : {std::string("section = \"HEA 160\"\n"), typed}) {
        const std::string error = test::first_error_of(bar(section + size));
        CHECK_MESSAGE(error.find("the section is given without it") != std::string::npos, error);
      }
    }
  }

  TEST_CASE("where no size passes there is no solution, and the nearest size is named") {
    // a width of 5 mm is too slender at every height
    const auto project = test::solved_as_found(bar("b = \"5 mm\"\nh = \"?\"\n"));
    CHECK(test::mode_of(project, "bar", "slenderness") != "pass");
    std::string text = bar("d = \"60 mm\"\nt_w = \"?\"\n");
    text.replace(text.find("60 kN"), 5, "2 MN");
    const auto none = test::solved_as_found(text);
    CHECK(test::mode_of(none, "bar", "buckling") != "pass");
    bool is_named = false;
    for (const account::Mode& mode : project::modes(none))
      is_named = is_named || mode.note.text().find("nearest is") != std::string::npos;
    CHECK(is_named);
  }
}

TEST_SUITE("column walls") {
  TEST_CASE("a tube given by its wall is the tube given by its bore") {
    column::Buckling::Input tube = bar_of_steel(column::Ends::pinned_pinned);
    tube.b = tube.h = unset<Length>;
    tube.d = 60.0 * mm, tube.d_bore = 50.0 * mm, tube.P = 20.0 * kN;
    column::Buckling::Input walled = tube;
    walled.d_bore = unset<Length>, walled.t_w = 5.0 * mm;
    const auto one = solve(tube), other = solve(walled);
    CHECK(rel(in_si(other.A), in_si(one.A)) < 1e-12);
    CHECK(rel(other.lambda, one.lambda) < 1e-12);
    CHECK(rel(other.u, one.u) < 1e-12);
    CHECK(rel(other.r_class, one.r_class) < 1e-12);
  }

  TEST_CASE("a hollow rectangle is the rectangle minus its hollow") {
    column::Buckling::Input box = bar_of_steel(column::Ends::pinned_pinned);
    box.t_w = 4.0 * mm, box.t_f = 6.0 * mm;  // 40 mm by 60 mm, 32 mm by 48 mm within
    const auto r = solve(box);
    const double A = 40.0 * 60.0 - 32.0 * 48.0;
    CHECK(rel(in_si(r.A), A * 1e-6) < 1e-12);
    CHECK(rel(in_si(r.axes[0].i) * 1e3, std::sqrt((40.0 * 216e3 - 32.0 * 110592.0) / 12.0 / A)) < 1e-12);
    CHECK(rel(in_si(r.axes[1].i) * 1e3, std::sqrt((60.0 * 64e3 - 48.0 * 32768.0) / 12.0 / A)) < 1e-12);
    box.t_f = unset<Length>, box.t_w = 20.0 * mm * (1.0 - 1e-12);  // no hollow is left
    CHECK(rel(in_si(solve(box).A), 2400e-6) < 1e-9);
  }

  TEST_CASE("walls that do not fit are refused") {
    const auto says = [](const std::string& lines, const char* what) {
      CAPTURE(lines);
      CHECK(
          complaints("calculator = \"column.buckling\"\nl = \"900 mm\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nR_e "
                     "= \"235 MPa\"\nmethod = \"johnson\"\n" +
                     lines)
              .find(what) != std::string::npos);
    };
    says("d = \"60 mm\"\nt_w = \"30 mm\"\n", "the walls must enclose a hollow");
    says("d = \"60 mm\"\nt_w = \"5 mm\"\nd_bore = \"50 mm\"\n", "both give the wall");
    says("d = \"60 mm\"\nt_w = \"5 mm\"\nkind = \"solid\"\n", "omit kind");
    says("d = \"60 mm\"\nd_bore = \"50 mm\"\nkind = \"rolled_I\"\n", "omit kind");
    says("h = \"60 mm\"\nb = \"40 mm\"\nt_w = \"20 mm\"\n", "the walls must enclose a hollow");
    says("h = \"60 mm\"\nb = \"40 mm\"\nt_f = \"5 mm\"\n", "t_f does not describe");
    says("h = \"60 mm\"\nb = \"40 mm\"\nt_w = \"5 mm\"\nr = \"5 mm\"\n", "sharp corners");
    says("h = \"60 mm\"\nb = \"40 mm\"\nt_w = \"5 mm\"\nkind = \"rolled_I\"\n", "omit kind");
  }

  TEST_CASE("a typed wall is never ignored: with it the tube carries less than the solid bar") {
    const auto state = [](const std::string& lines) {
      return test::mode_of(test::solved_as_found(bar(lines)), "bar", "buckling");
    };
    CHECK(state("d = \"45 mm\"\n") == "pass");
    CHECK(state("d = \"45 mm\"\nt_w = \"2 mm\"\n") == "fail");
  }
}
