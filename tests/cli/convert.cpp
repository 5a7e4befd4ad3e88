#include "tests/cli/process.hpp"

using namespace loadpath::test;

namespace {

struct Row {
  std::vector<std::string> words;
  std::string out;
};

Ran convert(std::vector<std::string> words) {
  words.insert(words.begin(), "convert");
  return loadpath_with(words);
}

}  // namespace

TEST_SUITE("cli convert") {
  TEST_CASE("quantities are converted to the given unit") {
    const Row rows[] = {
        {{"2700 lbf*in", "N*m"}, "305.0590384 N·m\n"},
        {{"2,5 kN·m", "N*m"}, "2500 N·m\n"},
        {{"-5 °C", "K"}, "268.15 K\n"},
        {{"120 rpm", "rad/s"}, "12.56637061 rad/s\n"},
        {{"1-1/2 in", "mm"}, "38.1 mm\n"},
        {{"30 МПа", "ksi"}, "4.351132132 ksi\n"},
    };
    for (const Row& row : rows) {
      CAPTURE(row.words[0]);
      const Ran o = convert(row.words);
      CHECK(o.code == 0);
      CHECK(o.out == row.out);
    }
  }

  TEST_CASE("a quantity split at its blank is reported with the quotes it needs") {
    CHECK(
        convert({"10", "kN"}).error.ends_with("help: a value with a blank needs quotes: loadpath convert \"10 kN\"\n"));
  }

  TEST_CASE("an expression is computed with its dimension") {
    CHECK(convert({"=2*pi*0.5 Hz*1 rad", "rad/s"}).out == "3.141592654 rad/s\n");
    CHECK(convert({"=6 kW / (60 rpm)", "N*m"}).out == "954.9296586 N·m\n");
    CHECK(convert({"=sqrt(2) * 2 N", "N"}).out == "2.828427125 N\n");
  }

  TEST_CASE("values of tables are numbers too") {
    CHECK(convert({"=2 * tables.sections.\"IPE 330\".I_y", "cm^4"}).out == "23540 cm⁴\n");
    CHECK(convert({"=tables.sections.\"HEA 155\".A"})
              .error.ends_with("  = help: did you mean 'HEA 140' or 'HEA 160'?\n"));
  }

  TEST_CASE("without a unit one is chosen") { CHECK(convert({"2700 lbf*in"}).out == "305.0590384 N·m\n"); }

  TEST_CASE("an error is reported at its character") {
    CHECK(convert({"30 mpa"}).error ==
          "quantity:1:4: error: unknown unit 'mpa'\n1 | 30 mpa\n  |    ^^^\n  = help: did you mean 'MPa'?\n");
    CHECK(convert({"30 mm", "mn"}).error ==
          "unit:1:1: error: unknown unit 'mn'\n1 | mn\n  | ^^\n  = help: did you mean 'mm'?\n");
    CHECK(convert({"3 mn", "mm"}).error.ends_with("  = help: did you mean 'mm'?\n"));
    CHECK(convert({"3 furlong"}).error.ends_with("  = help: `loadpath convert --help` lists the units\n"));
    CHECK(convert({"1,234.5 mm"}).error.starts_with("quantity:1:1: error: '1,234.5' has more than one decimal mark\n"));
    CHECK(convert({"=a.b + 1"}).error ==
          "quantity:1:2: error: 'a.b' refers to a project, and there is none here\n1 | =a.b + 1\n  |  ^^^\n");
    CHECK(convert({"=1 mm + 1 kg"}).code == 2);
  }

  TEST_CASE("unlike dimensions are refused") {
    const Ran o = convert({"30 mm", "kg"});
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(o.error == "loadpath: '30 mm' is a length, 'kg' is a unit of mass\n");
  }
}
