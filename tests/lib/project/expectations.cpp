#include "lib/project/verify.hpp"
#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// A shaft whose largest moment is 100 N m, with one expectation; its lines start at line 6.
std::string expecting(const std::string& lines) {
  return axle + "T = \"100 N*m\"\ntau_adm = \"30 MPa\"\n[[expect]]\n" + lines;
}

project::Comparison compared(const std::string& lines) { return project::compare(solved(expecting(lines))).at(0); }

const std::string source = "source = \"here\"\n";

}  // namespace

TEST_SUITE("project expectations") {
  TEST_CASE("digits allow half a unit of the last digit") {
    CHECK(project::half_unit(43.17, 4) == doctest::Approx(0.005));
    CHECK(project::half_unit(-0.0432, 3) == doctest::Approx(0.00005));
    CHECK(project::half_unit(100.0, 3) == doctest::Approx(0.5));
    CHECK(compared("value = \"axle.M_max\"\nis = \"100.4 N*m\"\ndigits = 3\n" + source).holds);
    CHECK_FALSE(compared("value = \"axle.M_max\"\nis = \"100.6 N*m\"\ndigits = 3\n" + source).holds);
  }

  TEST_CASE("the digits are counted in the unit that is written") {
    CHECK(compared("value = \"axle.M_max\"\nis = \"0.1004 kN*m\"\ndigits = 3\n" + source).holds);
    CHECK_FALSE(compared("value = \"axle.M_max\"\nis = \"0.1004 kN*m\"\ndigits = 4\n" + source).holds);
  }

  TEST_CASE("within is a part of the value") {
    CHECK(compared("value = \"axle.M_max\"\nis = \"101 N*m\"\nwithin = \"1 %\"\n" + source).holds);
    CHECK_FALSE(compared("value = \"axle.M_max\"\nis = \"102 N*m\"\nwithin = \"1 %\"\n" + source).holds);
    CHECK(compared("value = \"axle.M_max\"\nis = \"101 N*m\"\nwithin = \"1 %\"\n" + source).deviation ==
          doctest::Approx(-1.0 / 101.0));
  }

  TEST_CASE("within may be a quantity like the value, in any unit of it") {
    for (const char* within : {"1 N*m", "1,0 N·m", "0.001 kN*m"}) {
      CAPTURE(within);
      const std::string tolerance = "\"\nwithin = \"" + std::string(within) + "\"\n" + source;
      CHECK(compared("value = \"axle.M_max\"\nis = \"101 N*m" + tolerance).holds);
      CHECK(compared("value = \"axle.M_max\"\nis = \"0.099 kN*m" + tolerance).holds);
      CHECK_FALSE(compared("value = \"axle.M_max\"\nis = \"101.01 N*m" + tolerance).holds);
      CHECK(compared("value = \"axle.M_max - 99.5 N*m\"\nis = \"0 N*m" + tolerance).holds);
      CHECK_FALSE(compared("value = \"axle.M_max - 98.5 N*m\"\nis = \"0 N*m" + tolerance).holds);
    }
  }

  TEST_CASE("within of a plain number may be a difference, with its sign") {
    CHECK(compared("value = \"=axle.M_max/(62.15 N*m)\"\nis = \"1.6\"\nwithin = \"±0.01\"\n" + source).holds);
    CHECK_FALSE(compared("value = \"=axle.M_max/(62.15 N*m)\"\nis = \"1.6\"\nwithin = \"±0.001\"\n" + source).holds);
    CHECK(issues_of(expecting("value = \"axle.u_tau\"\nis = \"1\"\nwithin = \"0.01\"\n" + source))
              .ends_with("  = help: write a part of the value, \"0.5 %\", or a difference from it, \"±0.01\"\n"));
  }

  TEST_CASE("infinity is expected as such, and needs no tolerance") {
    const std::string cycle = "[rod]\ncalculator = \"fatigue.cycle\"\nsigma_max = \"0 MPa\"\nsigma_a = \"5 MPa\"\n";
    const auto expected = [&](const char* is) {
      return project::compare(solved(cycle + "[[expect]]\nvalue = \"rod.r\"\nis = \"" + is + "\"\n" + source)).at(0);
    };
    CHECK(expected("inf").holds);
    CHECK_FALSE(expected("-inf").holds);
    CHECK(issues_of(cycle + "[[expect]]\nvalue = \"rod.r\"\nis = \"inf\"\ndigits = 3\n" + source)
              .find("an infinite value has no tolerance") != std::string::npos);
  }

  TEST_CASE("an expected zero is compared in SI") {
    CHECK(compared("value = \"axle.M_max - 100 N*m\"\nis = \"0 N*m\"\nwithin = \"1 %\"\n" + source).holds);
  }

  TEST_CASE("a value may be an expression") {
    CHECK(compared("value = \"=axle.M_max / axle.T\"\nis = \"1\"\ndigits = 9\n" + source).holds);
  }

  TEST_CASE("a value that is not available is a miss") {
    const auto project = told(axle + no_torque + "tau_adm = \"30 MPa\"\n" + relay +
                              "[[expect]]\nvalue = \"axle.M_max\"\nis = \"1 "
                              "N*m\"\ndigits = 3\n" +
                              source)
                             .project;
    CHECK_FALSE(project::compare(project).at(0).holds);
  }

  TEST_CASE("an expectation needs value, is and source") {
    CHECK(issues_of(expecting("value = \"axle.M_max\"\nis = \"1 N*m\"\ndigits = 3\n")) ==
          "a.toml:5:1: error: an expectation needs value, is and source\n5 | [[expect]]\n  | ^^^^^^^^^^\n");
  }

  TEST_CASE("an expectation has either digits or within") {
    const std::string said = "error: an expectation has either digits or within\n5 | [[expect]]\n  | ^^^^^^^^^^\n";
    const std::string value_and_is = "value = \"axle.M_max\"\nis = \"1 N*m\"\n" + source;
    CHECK(issues_of(expecting(value_and_is)) == "a.toml:5:1: " + said);
    CHECK(issues_of(expecting(value_and_is + "digits = 3\nwithin = \"1 %\"\n")) == "a.toml:5:1: " + said);
    CHECK(issues_of(expecting(value_and_is + "digits = 99\n")) ==
          "a.toml:9:10: error: digits is an integer from 1 to 15\n9 | digits = 99\n  |          ^^\n");
    CHECK(issues_of(expecting(value_and_is + "digits = 2.5\n")) ==
          "a.toml:9:10: error: digits is an integer from 1 to 15\n9 | digits = 2.5\n  |          ^^^\n");
    CHECK(issues_of(expecting(value_and_is + "digits = 1e30\n")) ==  // more than an int holds
          "a.toml:9:10: error: digits is an integer from 1 to 15\n9 | digits = 1e30\n  |          ^^^^\n");
    CHECK(issues_of(expecting(value_and_is + "within = \"3 mm\"\n")) ==
          R"(a.toml:9:11: error: '3 mm' (length) is not a tolerance of '1 N*m' (moment)
9 | within = "3 mm"
  |           ^^^^
  = help: write a part of the value, "0.5 %", or a quantity like it, "0.1 N*m"
)");
    CHECK(issues_of(expecting(value_and_is + "within = \"-0.1 N*m\"\n")) ==
          R"(a.toml:9:11: error: within must be > 0
9 | within = "-0.1 N*m"
  |           ^^^^^^^^
  = help: write a part of the value, "0.5 %", or a quantity like it, "0.1 N*m"
)");
    CHECK(issues_of(expecting(value_and_is + "within = \"0.1 mpa\"\n"))
              .starts_with("a.toml:9:15: error: unknown unit 'mpa'\n"));
    CHECK(issues_of(expecting("value = \"axle.u_tau\"\nis = \"1\"\n" + source + "within = \"3 mm\"\n"))
              .ends_with("  = help: write a part of the value, \"0.5 %\", or a difference from it, \"±0.01\"\n"));
  }

  TEST_CASE("an unknown key of an expectation is reported with the nearest one") {
    CHECK(issues_of(expecting("value = \"axle.M_max\"\nis = \"1 N*m\"\ndigits = 3\nsuorce = \"here\"\n" + source)) ==
          R"(a.toml:9:1: error: 'suorce' is not a valid key here
9 | suorce = "here"
  | ^^^^^^
  = help: did you mean 'source'?
)");
  }

  TEST_CASE("dimensions, references and series of an expectation are checked when the file is read") {
    CHECK(issues_of(expecting("value = \"axle.M_max\"\nis = \"1 N\"\ndigits = 3\n" + source)) ==
          R"(a.toml:6:10: error: 'axle.M_max' is a moment, and '1 N' is a force
6 | value = "axle.M_max"
  |          ^^^^^^^^^^
)");
    CHECK(issues_of(expecting("value = \"axle.M_mx\"\nis = \"1 N*m\"\ndigits = 3\n" + source)) ==
          R"(a.toml:6:10: error: 'axle' has no result 'M_mx'
6 | value = "axle.M_mx"
  |          ^^^^^^^^^
  = help: did you mean 'axle.M_max'?
)");
  }

  TEST_CASE("expectations are an array of tables") {
    CHECK(issues_of(axle + "T = \"1 N*m\"\ntau_adm = \"30 MPa\"\n[expect]\nvalue = \"axle.M_max\"\n")
              .starts_with("a.toml:5:1: error: write expectations as [[expect]]\n"));
  }
}
