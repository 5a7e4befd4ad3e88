#include "tests/cli/process.hpp"
#include "tests/pages.hpp"

using namespace loadpath::test;

namespace {

std::string expecting(const std::string& is) {
  return "[axle]\ncalculator = \"shaft.torsion\"\nT = \"2700 N*m\"\ntau_adm = \"30 MPa\"\n"
         "[[expect]]\nvalue = \"axle.d_min\"\nis = \"" +
         is + "\"\ndigits = 4\nsource = \"by hand\"\n";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("cli verify") {
  TEST_CASE("the built-in manual passes") {
    const Ran o = loadpath_with({"verify"});
    CHECK(o.code == 0);
    CHECK(o.error.empty());
    CHECK(o.out.ends_with(" hold, 0 miss\n"));
    CHECK_FALSE(contains(o.out, "MISS"));
    const Ran full = loadpath_with({"verify", "--full"});
    CHECK(contains(full.out, "published"));
    CHECK(full.out.size() > 4 * o.out.size());
  }

  TEST_CASE("docs/verification.md is the report of the built-in cases") {
    const Desk desk;
    const Ran ran = desk.run({"verify", "--report", "verification.md"});
    CHECK(ran.code == 0);
    CHECK(ran.error == "report: verification.md\n");
    CHECK_MESSAGE(desk.get("verification.md") == text_of(LOADPATH_ROOT "/docs/verification.md"),
                  "run `loadpath verify --report docs/verification.md`");
  }

  TEST_CASE("a report on a file's own expectations names those that are missed") {
    const Desk desk;
    desk.put("a.toml", expecting("77.20 mm"));
    const Ran ran = desk.run({"verify", "a.toml", "--report", "a.md"});
    CHECK(ran.code == 1);
    const std::string report = desk.get("a.md");
    CHECK(report.starts_with("# Verification\n"));
    CHECK(contains(report, "this version reproduces 0 and misses 1."));
    CHECK(contains(report, "| axle.d_min | 77.20 mm  | 77.1029 mm | MISS: -0.13 % | by hand |"));
    CHECK(desk.run({"verify", "a.toml", "--report", "a.txt"}).code == 2);
  }

  TEST_CASE("a file is compared with its own expectations") {
    const Desk desk;
    desk.put("a.toml", expecting("77.10 mm"));
    desk.put("b.toml", expecting("77.20 mm"));
    const Ran good = desk.run({"verify", "a.toml"}), both = desk.run({"verify", "a.toml", "b.toml"});
    CHECK(good.code == 0);
    CHECK(good.out.ends_with("1 hold, 0 miss\n"));
    CHECK(both.code == 1);
    CHECK(both.out.ends_with("1 hold, 1 miss\n"));
    CHECK(contains(both.out, "  MISS  axle.d_min  77.20 mm"));
    CHECK(contains(both.out, "by hand"));
  }

  TEST_CASE("where the tolerance is a quantity the deviation is one, too") {
    const Desk desk;
    std::string text = expecting("77.20 mm");
    text.replace(text.find("digits = 4"), 10, "within = \"0,1 mm\"");
    desk.put("a.toml", text);
    CHECK(contains(desk.run({"verify", "a.toml"}).out, "  ok  axle.d_min  77.20 mm   77.1029 mm  -0.097 mm"));
  }

  TEST_CASE("a file that cannot be read or run is wrong input") {
    const Desk desk;
    desk.put("a.toml", expecting("77.10 kg"));
    CHECK(desk.run({"verify", "none.toml"}).code == 2);
    CHECK(desk.run({"verify", "none.toml"})
              .error.starts_with("loadpath: cannot read 'none.toml'\n  = help: no such file; "));
    CHECK(desk.run({"verify", "a.toml"}).code == 2);
    CHECK(desk.run({"verify", "a.toml"})
              .error.starts_with("a.toml:6:10: error: 'axle.d_min' is a length, and '77.10 kg' is a mass\n"));
  }
}
