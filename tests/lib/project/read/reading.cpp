#include "lib/project/read/reading.hpp"

#include "tests/lib/project/texts.hpp"

using namespace loadpath;
using namespace loadpath::test;

TEST_SUITE("project reading") {
  TEST_CASE("a wrong dimension is reported with the expected one") {
    CHECK(issues_of(axle + "T = \"2700 N\"\ntau_adm = \"30 MPa\"\n") ==
          R"(a.toml:3:6: error: '2700 N' is a force; a moment is expected
3 | T = "2700 N"
  |      ^^^^^^
  = help: write a unit such as N*m
)");
  }

  TEST_CASE("an unknown unit is reported with the nearest one, and the caret is under it") {
    CHECK(issues_of(axle + "T = \"2700 N*m\"\ntau_adm = \"30 mpa\"\n") == R"(a.toml:4:15: error: unknown unit 'mpa'
4 | tau_adm = "30 mpa"
  |               ^^^
  = help: did you mean 'MPa'?
)");
  }

  TEST_CASE("a number without a unit is refused where the field has a dimension") {
    const std::string remedy = "  = help: write '2700 N*m'\n";
    CHECK(issues_of(axle + "T = 2700\ntau_adm = \"30 MPa\"\n") ==
          "a.toml:3:5: error: '2700' has no unit; a moment is expected\n3 | T = 2700\n  |     ^^^^\n" + remedy);
    CHECK(issues_of(axle + "T = \"2700\"\ntau_adm = \"30 MPa\"\n") ==
          "a.toml:3:6: error: '2700' has no unit; a moment is expected\n3 | T = \"2700\"\n  |      ^^^^\n" + remedy);
  }

  TEST_CASE("a unit is refused where the field is a plain number") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nK_A = \"1.4 mm\"\n") ==
          R"(a.toml:5:8: error: '1.4 mm' is a length; a plain number is expected
5 | K_A = "1.4 mm"
  |        ^^^^^^
  = help: write the number without a unit
)");
  }

  TEST_CASE("two decimal marks are refused, not guessed") {
    CHECK(issues_of(axle + "T = \"1,234.5 N*m\"\ntau_adm = \"30 MPa\"\n") ==
          R"(a.toml:3:6: error: '1,234.5' has more than one decimal mark
3 | T = "1,234.5 N*m"
  |      ^^^^^^^
  = help: write '1234.5'
)");
  }

  TEST_CASE("an expression without its '=' is reported as one") {
    CHECK(issues_of(axle + "T = \"peak(lever.drive.M)\"\ntau_adm = \"30 MPa\"\n") ==
          R"says(a.toml:3:6: error: 'peak(lever.drive.M)' is an expression without its '='
3 | T = "peak(lever.drive.M)"
  |      ^^^^^^^^^^^^^^^^^^^
  = help: an expression starts with '=': write "=peak(lever.drive.M)"
)says");
    CHECK(issues_of(axle + "T = \"2 * lever.drive.M\"\ntau_adm = \"30 MPa\"\n")
              .starts_with("a.toml:3:6: error: '2 * lever.drive.M' is an expression without its '='\n"));
  }

  TEST_CASE("display is a table of units") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\ndisplay = \"in\"\n") ==
          R"(a.toml:5:12: error: 'display' is a table of units, not a text
5 | display = "in"
  |            ^^
  = help: name the results: display = { d = "in" }
)");
  }

  TEST_CASE("infinity and NaN are not numbers") {
    CHECK(issues_of(axle + "T = \"nan N*m\"\ntau_adm = inf\n") ==
          R"(a.toml:3:6: error: 'nan' is not a finite number
3 | T = "nan N*m"
  |      ^^^
  = help: write a number and a unit, as in '30 N*m'; to have it found: T = "?"
a.toml:4:11: error: 'inf' is not a finite number
4 | tau_adm = inf
  |           ^^^
  = help: write a number and a unit, as in '30 MPa'
)");
  }

  TEST_CASE("a value outside its bounds is reported with value, unit and rule") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"-30 MPa\"\n") ==
          R"(a.toml:4:12: error: tau_adm = -30 MPa: must be > 0 MPa
4 | tau_adm = "-30 MPa"
  |            ^^^^^^^
)");
  }

  TEST_CASE("sizes whose powers would exceed the range of numbers are refused") {
    for (const char* size : {"1e40 MPa", "1e-45 MPa"}) {
      CHECK(first_error(axle + "T = \"9 N*m\"\ntau_adm = \"" + size + "\"\n") ==
            "tau_adm = " + std::string(size) + " is implausible");
    }
  }

  TEST_CASE("an unusual value is a warning, and the step is still solved") {
    const std::string text = axle + "T = \"9 N*m\"\ntau_adm = \"30 kPa\"\n";
    CHECK(issues_of(text) == R"(a.toml:4:12: warning: tau_adm = 0.03 MPa is unusual: 1 MPa to 1000 MPa is expected
4 | tau_adm = "30 kPa"
  |            ^^^^^^
  = help: check the unit
)");
    CHECK(told(text).project.value("axle.d_min") != nullptr);
    CHECK_FALSE(project::verdicts(told(text).project).empty());
  }

  TEST_CASE("an unknown key is reported with the nearest field, and the missing field is not reported again") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_amd = \"30 MPa\"\n")
              .starts_with(R"(a.toml:4:1: error: 'tau_amd' is not a valid key here
4 | tau_amd = "30 MPa"
  | ^^^^^^^
  = help: did you mean 'tau_adm' ()"));
  }

  TEST_CASE("a result that is given as an input is named as a result") {
    const std::string told = issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nd_min = \"20 mm\"\n");
    CHECK(told.starts_with("a.toml:5:1: error: 'd_min' is a result of shaft.torsion, not an input: "));
  }

  TEST_CASE("an integer in quotes is reported with how to write it") {
    const auto told = [](const std::string& keys) {
      return issues_of(
          "[key]\ncalculator = \"shaft.key\"\nT = \"9 N*m\"\nd = \"40 mm\"\nkey = \"12x8\"\nl = \"40 mm\"\n" + keys);
    };
    CHECK(told("i = \"2\"\n").find("help: write it without quotes, as in i = 3\n") != std::string::npos);
    CHECK(told("i = \"two\"\n").find("help: write an integer, as in i = 3\n") != std::string::npos);
    CHECK(told("i = \"?\"\n").find("'i' cannot be searched for") != std::string::npos);
    CHECK(told("torque = true\n").find("'true' is not a valid value of 'torque'") != std::string::npos);
  }

  TEST_CASE("an unknown key without a similar one is reported with all fields") {
    const std::string told =
        issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nsegments = [{ l = \"1 m\", width = \"3 mm\" }]\n");
    CHECK(told.starts_with(R"(a.toml:5:26: error: 'width' is not a valid key here
5 | segments = [{ l = "1 m", width = "3 mm" }]
  |                          ^^^^^
  = help: available: name ()"));
    for (const char* key : {", l (length)", ", d (", ", chi (", ", d_bore ("})
      CHECK(told.find(key) != std::string::npos);
  }

  TEST_CASE("a missing field is reported with its meaning and unit") {
    CHECK(issues_of("[pin]\ncalculator = \"shaft.overhung\"\nF = \"1 kN\"\nT = \"9 N*m\"\nsigma_adm = \"60 MPa\"\n") ==
          R"(a.toml:1:1: error: 'a' is missing: overhang: distance from the force to the bearing centre
1 | [pin]
  | ^^^^^
  = help: write a = "... mm"
)");
  }

  TEST_CASE("a field that is missing inside a list is reported by its element") {
    CHECK(issues_of(axle + "tau_adm = \"30 MPa\"\ntorques = [{ x = \"0 m\", T = \"9 N*m\" }, { name = \"gear\", T = "
                           "\"-9 N*m\" }]\n") ==
          R"(a.toml:4:40: error: 'torques.gear.x' is missing: position from the left end
4 | torques = [{ x = "0 m", T = "9 N*m" }, { name = "gear", T = "-9 N*m" }]
  |                                        ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  = help: write x = "... mm"
)");
  }

  TEST_CASE("the caret finds its place in arrays and inline tables over several lines") {
    CHECK(issues_of(axle + "tau_adm = \"30 MPa\"\ntorques = [\n  { x = \"0 m\", T = \"9 N*m\" },\n  { x = \"1 m\", T = "
                           "\"-9 Н·мм\" },\n  { x = \"2 furlong\", T = \"0 N*m\" },\n]\n") ==
          R"(a.toml:7:12: error: unknown unit 'furlong'
7 |   { x = "2 furlong", T = "0 N*m" },
  |            ^^^^^^^
  = help: write a number and a unit, as in '30 mm'
)");
  }

  TEST_CASE("a list that is too long is reported with its length") {
    std::string rows;
    for (int i = 0; i < 34; ++i) rows += "{ x = \"0 m\", T = \"0 N*m\" },";
    const std::string said = issues_of(axle + "tau_adm = \"30 MPa\"\ntorques = [" + rows + "]\n");
    CHECK(said.starts_with("a.toml:4:11: error: at most 33 torques; there are 34\n4 | torques = [{ x = "));
  }

  TEST_CASE("a duplicate name in a list is reported at the second") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\n[[axle.segments]]\nname = \"hub\"\nl = \"1 "
                           "m\"\n[[axle.segments]]\nname = \"hub\"\nl = \"2 m\"\n") ==
          R"(a.toml:9:9: error: the name 'hub' is used twice in 'segments'
9 | name = "hub"
  |         ^^^
)");
  }

  TEST_CASE("names have Latin letters, digits and '_'") {
    const std::string rule = "  = help: a name has Latin letters, digits and '_', and does not start with a digit\n";
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nsegments = { \"втулка\" = { l = \"1 m\" } }\n") ==
          "a.toml:5:14: error: 'втулка' is not a valid name\n5 | segments = { \"втулка\" = { l = \"1 m\" } }\n  |      "
          "        "
          "^^^^^^^^\n" +
              rule);
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nsegments = [{ name = \"2nd\", l = \"1 m\" }]\n") ==
          "a.toml:5:23: error: '2nd' is not a valid name\n5 | segments = [{ name = \"2nd\", l = \"1 m\" }]\n  |        "
          "         "
          "      ^^^\n" +
              rule);
  }

  TEST_CASE("a word that is not in a choice is reported with the nearest one") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nfixed = \"lft\"\n") ==
          R"(a.toml:5:10: error: 'lft' is not a valid value of 'fixed'
5 | fixed = "lft"
  |          ^^^
  = help: did you mean 'left'?
)");
  }

  TEST_CASE("a value of another type is described in words") {
    CHECK(issues_of(axle + "T = true\ntau_adm = \"30 MPa\"\nfixed = 3\nsegments = [3]\ntitle = 4\n") ==
          R"(a.toml:3:5: error: a quantity is expected, not true
3 | T = true
  |     ^^^^
  = help: write a text with a unit, "30 N*m"
a.toml:5:9: error: a number is not a valid value of 'fixed'
5 | fixed = 3
  |         ^
  = help: available: none, left, right
a.toml:6:13: error: 'segments[1]' is a table of fields, not a number
6 | segments = [3]
  |             ^
  = help: available: name, l, d, chi, d_bore, rho
a.toml:7:9: error: 'axle.title' takes a text, not a number
7 | title = 4
  |         ^
)");
  }

  TEST_CASE("a range is for sweeps") {
    const std::string remedy =
        "  = help: `loadpath sweep` goes through all of them, `loadpath run FILE --point 0` takes the first\n";
    CHECK(issues_of(axle + "T = { from = \"30 N*m\", to = \"60 N*m\", step = \"1 N*m\" }\ntau_adm = \"30 MPa\"\n") ==
          "a.toml:3:5: error: these are 31 values; a single value is required\n"
          "3 | T = { from = \"30 N*m\", to = \"60 N*m\", step = \"1 N*m\" }\n"
          "  |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n" +
              remedy);
    CHECK(issues_of(axle + "T = [\"30 N*m\", \"60 N*m\"]\ntau_adm = \"30 MPa\"\n") ==
          "a.toml:3:5: error: these are 2 values; a single value is required\n3 | T = [\"30 N*m\", \"60 N*m\"]\n  |    "
          " ^^^^^^^^^^^^^^^^^^^^\n" +
              remedy);
  }

  TEST_CASE("a range that a search chooses from has no value in a run") {
    CHECK(issues_of(axle + "T = { from = \"30 N*m\", to = \"60 N*m\" }\ntau_adm = \"30 MPa\"\n") ==
          R"(a.toml:3:5: error: 'T' is a range for searches; a single value is required
3 | T = { from = "30 N*m", to = "60 N*m" }
  |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  = help: `loadpath sweep FILE --minimise` chooses from it; scatter is { min = ..., max = ... }
)");
    CHECK(issues_of("[values]\nT = { from = \"30 N*m\", to = \"60 N*m\" }\n" + axle +
                    "T = \"=2*values.T\"\ntau_adm = \"30 MPa\"\n")
              .find("'values.T' is a range for searches") != std::string::npos);
  }

  TEST_CASE("an uncertain value runs at its middle, and this is reported") {
    const std::string text = axle + "T = { mean = \"30 N*m\", sd = \"2 N*m\" }\ntau_adm = \"30 MPa\"\n";
    CHECK(issues_of(text) == R"(a.toml:3:5: warning: 'T' is uncertain; computed at its middle value
3 | T = { mean = "30 N*m", sd = "2 N*m" }
  |     ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
)");
    CHECK(value(told(text).project, "axle.M_max") == doctest::Approx(30.0));
    CHECK(issues_of(axle + "T = { value = \"30 N*m\", tolerence = \"2 N*m\" }\ntau_adm = \"30 MPa\"\n") ==
          R"(a.toml:3:25: error: 'tolerence' is not a valid key here
3 | T = { value = "30 N*m", tolerence = "2 N*m" }
  |                         ^^^^^^^^^
  = help: did you mean 'tolerance'?
)");
  }

  TEST_CASE("a rule between fields is reported at the first of them that was written") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nd = \"40 mm\"\nd_bore = \"50 mm\"\n") ==
          R"(a.toml:6:11: error: the bore must be smaller than the outer diameter of the shaft
6 | d_bore = "50 mm"
  |           ^^^^^
)");
    CHECK(issues_of(axle + "tau_adm = \"30 MPa\"\n") ==
          "a.toml:1:2: error: give the torque T, or the power P with the speed n, or torques\n1 | [axle]\n  |  ^^^^\n");
  }

  TEST_CASE("an allowable stress and a material with a safety factor exclude one another") {
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nmaterial = \"C45E\"\nS = 2\n") ==
          R"(a.toml:6:5: error: tau_adm includes the safety factor; S would be a second one
6 | S = 2
  |     ^
  = help: omit S; or omit tau_adm, and S applies to the yield strength R_e, given or of a material
)");
    CHECK(issues_of(axle + "T = \"9 N*m\"\ntau_adm = \"30 MPa\"\nR_e = \"355 MPa\"\nS = 2\n") ==
          R"(a.toml:4:12: error: tau_adm includes the safety factor: give tau_adm, or R_e with S, not both
4 | tau_adm = "30 MPa"
  |            ^^^^^^
)");
  }

  TEST_CASE("a rule with details states which element and how much") {
    const std::string torques = axle + "tau_adm = \"30 MPa\"\ntorques = [{ x = \"0 m\", T = \"90 N*m\" }, ";
    CHECK(issues_of(torques + "{ x = \"1 m\", T = \"-60 N*m\" }]\n") ==
          R"(a.toml:4:11: error: the torques sum to 30 N·m, not to zero
4 | torques = [{ x = "0 m", T = "90 N*m" }, { x = "1 m", T = "-60 N*m" }]
  |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  = help: add the torque of -30 N·m that is missing, or hold an end: fixed = "left" or fixed = "right"
)");
    CHECK(issues_of(torques + "{ x = \"1.2 m\", T = \"-90 N*m\" }]\nl = \"1 m\"\n") ==
          R"(a.toml:4:48: error: torque 2 is at 1200 mm, 200 mm beyond the end of the shaft at 1000 mm
4 | torques = [{ x = "0 m", T = "90 N*m" }, { x = "1.2 m", T = "-90 N*m" }]
  |                                                ^^^^^
  = help: x counts from the left end: correct it, or the length l
)");
    CHECK(issues_of(torques + "{ name = \"gear\", x = \"1.2 m\", T = \"-90 N*m\" }]\nsegments = [{ l = \"1 m\" }]\n") ==
          R"(a.toml:4:63: error: torque 'gear' is at 1200 mm, 200 mm beyond the end of the shaft at 1000 mm
4 | torques = [{ x = "0 m", T = "90 N*m" }, { name = "gear", x = "1.2 m", T = "-90 N*m" }]
  |                                                               ^^^^^
  = help: x counts from the left end: correct it, or the lengths of the segments
)");
    CHECK(issues_of(torques + "{ x = \"0 m\", T = \"-90 N*m\" }]\n") ==
          R"(a.toml:4:11: error: all torques act at one position, and the shaft has no length
4 | torques = [{ x = "0 m", T = "90 N*m" }, { x = "0 m", T = "-90 N*m" }]
  |           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
  = help: give each torque its position x, from the left end
)");
  }

  TEST_CASE("all errors of a file are reported at once, in the order of their places") {
    CHECK(issues_of("[axle]\ncalculator = \"shaft.torsion\"\nT = \"9 N\"\ntau_adm = 30\n\n[pin]\ncalculator = "
                    "\"shaft.overhang\"\n\n[tables]\ncalculator = \"shaft.torsion\"\n") ==
          R"(a.toml:3:6: error: '9 N' is a force; a moment is expected
3 | T = "9 N"
  |      ^^^
  = help: write a unit such as N*m
a.toml:4:11: error: '30' has no unit; a stress is expected
4 | tau_adm = 30
  |           ^^
  = help: write '30 MPa'
a.toml:7:15: error: unknown calculator 'shaft.overhang'
7 | calculator = "shaft.overhang"
  |               ^^^^^^^^^^^^^^
  = help: did you mean 'shaft.overhung'?
a.toml:9:2: error: 'tables' is a reserved name and cannot name a step
9 | [tables]
  |  ^^^^^^
  = help: call it 'tables_1', or by the part that it describes
)");
  }

  TEST_CASE("spellings of a quantity read alike: decimal comma, Cyrillic units, prefixes") {
    for (const char* T : {"2700 N*m", "2,7 kN·m", "2.7 кН·м", "2700000 N mm", "2.7e3 Nm"}) {
      CAPTURE(T);
      const auto project = solved(axle + "T = \"" + T + "\"\ntau_adm = \"30 МПа\"\n");
      CHECK(value(project, "axle.T") == doctest::Approx(2700.0).epsilon(1e-14));
    }
  }

  TEST_CASE("a list element is found by its number and by its name") {
    const auto project =
        solved(axle +
               "tau_adm = \"30 MPa\"\n[[axle.torques]]\nname = \"gear\"\nx = \"0 m\"\nT = \"=2 * 4 N*m\"\n"
               "[[axle.torques]]\nx = \"1 m\"\nT = \"-8 N*m\"\n");
    CHECK(value(project, "axle.torques.gear.T") == doctest::Approx(8.0));
    CHECK(value(project, "axle.torques[2].T") == doctest::Approx(-8.0));
  }
}
