// Sizes that values of rows are asked at, where they follow from these values.
#include "lib/calculator/calculator_of.hpp"
#include "lib/calculator/field.hpp"
#include "lib/calculator/trace.hpp"
#include "lib/project/run/calculator_step.hpp"
#include "tests/lib/project/sweep/swept.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::test;

/// A strip 10 mm thick, whose strength is that of its width.
struct Strip {
  static constexpr auto id = "test.strip", synonyms = "";
  static constexpr auto title = "A strip in tension";
  static constexpr auto scope = "Width of a strip 10 mm thick.";
  static constexpr auto source = "[B19]";
  static constexpr auto example = "[strip]\ncalculator = \"test.strip\"\nF = \"10 kN\"\nR_e = \"235 MPa\"\n";
  struct Input {
    Force F = unset<Force>;
    Stress R_e = unset<Stress>;
  };
  static constexpr Fields inputs{
      Field{&Input::F, "F", N, "force"}.load(),
      Field{&Input::R_e, "R_e", MPa, "yield strength"}.positive().from("material", "R_e", "w")};
  struct Result {
    Length w = unset<Length>;
    double u = unset<double>;
  };
  static constexpr Fields results{Field{&Result::w, "w", mm, "least width"},
                                  Field{&Result::u, "u", ratio, "stress over strength"}.check()};
  static constexpr std::array<Rule<Input>, 0> rules{};
  static constexpr std::array modes{
      Mode<Input>{"yield", "yield", [](const Input&) { return Applies::yes; }}.judged_by("u")};

  template <class Tracer>
  static Result evaluate(const Input& in, Tracer& trace) {
    Result r;
    STEP_TO(r, w, in.F / (in.R_e * (10.0 * mm.one)), "tension");
    STEP_TO(r, u, in.F / (in.R_e * (10.0 * mm.one) * r.w), "strength");
    return r;
  }
};
template const Calculator& loadpath::erased<Strip>();

namespace {

project::Catalogue with_strip() {
  static const auto all = [] {
    std::vector<project::CatalogueEntry> entries(catalogue().begin(), catalogue().end());
    entries.push_back({&erased<Strip>(), &project::make_calculator_step});
    return entries;
  }();
  return all;
}

/// Wide pieces are stronger than narrow ones: of no plate, and yet of rows that a user may type.
const std::string plate = R"([tables.materials.plate]
kind = "quenched and tempered steel"
by_size = [
  { size_max = "40 mm", R_e = "150 MPa", R_m = "500 MPa" },
  { size_max = "400 mm", R_e = "400 MPa", R_m = "500 MPa" },
]
source = "made up"
)";

std::string strip(const std::string& force) {
  return plate + "[strip]\ncalculator = \"test.strip\"\nmaterial = \"plate\"\nF = " + force + "\n";
}

}  // namespace

TEST_SUITE("sizes of rows") {
  TEST_CASE("a size that alternates is reported, and nothing is assessed with it") {
    std::vector<Issue> issues;
    auto project = project::read_project(strip("\"100 kN\""), "a.toml", with_strip(), issues);
    project::solve(project, issues);
    REQUIRE(issues.empty());
    const std::string why = "the size 'w' does not converge: it alternates between 25 mm and 66.67 mm";
    const auto verdicts = project::verdicts(project);
    REQUIRE(verdicts.size() == 1);
    CHECK(verdicts[0].state == account::State::not_available);
    CHECK(verdicts[0].note.text() == why);
    const Value* const width = project.value("strip.w");
    CHECK((width == nullptr || std::isnan(width->si[0])));
    REQUIRE(project::modes(project).size() == 2);
    CHECK(project::modes(project)[0].note.text() == why);
  }

  TEST_CASE("a point of a sweep whose size alternates is not available, like the single machine") {
    const Swept swept(strip("[\"5 kN\", \"100 kN\", \"200 kN\"]"), {"w = strip.w"}, 1, {}, with_strip());
    REQUIRE_MESSAGE(swept.errors().empty(), swept.errors());
    const std::vector<double>& width = swept.column("w");
    REQUIRE(width.size() == 3);
    CHECK(width[0] == doctest::Approx(5e3 / (150e6 * 0.01)));
    CHECK(std::isnan(width[1]));
    CHECK(width[2] == doctest::Approx(200e3 / (400e6 * 0.01)));
    CHECK(swept.column("state")[1] == static_cast<double>(account::State::not_available));
  }

  TEST_CASE("a minimum size that alternates excludes no size of the stock") {
    const auto project = solved(plate + axle + "material = \"plate\"\nT = \"1500 N*m\"\nS = 1.5\n");
    CHECK(value(project, "axle.d") == doctest::Approx(0.0425));
  }
}
