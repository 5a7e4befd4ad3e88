// Reasons for values are printed by every output, also where only a value of [values] contradicts the input.
#include "lib/report/build/build.hpp"
#include "lib/report/document.hpp"
#include "tests/lib/project/solved.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace loadpath;
using test::contains;
using test::Solved;

namespace {

const std::string axle =
    "[values]\nT_start = \"900 N*m\"\n\n[axle]\ncalculator = \"shaft.torsion\"\nT = \"200 N*m\"\nd = \"45 "
    "mm\"\ntau_adm "
    "= \"60 MPa\"\nbecause.T = \"a slip clutch, sheet 7\"\n";

}  // namespace

TEST_SUITE("report of reasons") {
  TEST_CASE("the reason for an input that a value of [values] contradicts is on page 1 and in the appendix") {
    const Solved solved(axle);
    REQUIRE_MESSAGE(solved.errors().empty(), solved.errors());
    const report::Document document = report::build(solved.project, "loadpath");
    const std::string text = report::markdown(document, "a").text;
    CHECK_MESSAGE(contains(text, "axle, T = 200"), text);
    CHECK_MESSAGE(contains(text, ": a slip clutch, sheet 7."), text);
    CHECK_MESSAGE(contains(text, "Justified values"), text);
    CHECK(contains(report::html(document), "a slip clutch, sheet 7"));
    CHECK(contains(report::latex(document), "a slip clutch, sheet 7"));
  }

  TEST_CASE("without a reason there is no list of them") {
    const Solved solved(axle.substr(0, axle.find("because")));
    CHECK_FALSE(contains(report::markdown(report::build(solved.project, "loadpath"), "a").text, "Justified values"));
  }
}
