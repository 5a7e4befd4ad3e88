// How much the terminal answers: in short, every mode, in full, the verdict alone.
#include "tests/cli/process.hpp"

#include <filesystem>
#include <string>
#include <vector>

using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string shaft = LOADPATH_ROOT "/examples/line-shaft/project.toml";

}  // namespace

TEST_SUITE("cli answer") {
  TEST_CASE("the verdict comes first, whatever follows") {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"run", shaft}, {"run", shaft, "--full"}, {"run", shaft, "--modes"}}) {
      const Ran ran = loadpath_with(words);
      CHECK(ran.code == 0);
      CHECK(ran.out.starts_with("PASS (torsion only; fatigue"));
    }
  }

  TEST_CASE("--full has the tables of the elements, --modes every failure mode and no table; not both") {
    const Ran full = loadpath_with({"run", shaft, "--full"}), modes = loadpath_with({"run", shaft, "--modes"});
    CHECK(contains(full.out, "\n  tau_max "));
    CHECK_FALSE(contains(modes.out, "\n  tau_max "));
    CHECK(contains(modes.out, "\n  pass            line_shaft.yield "));
    CHECK(contains(modes.out, "\n  not considered  line_shaft.brittle "));
    CHECK(loadpath_with({"run", shaft, "--full", "--modes"}).code == 2);
  }

  TEST_CASE("the designs of examples/failing fail") {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(LOADPATH_ROOT "/examples/failing")) {
      CAPTURE(entry.path().string());
      const Ran ran = loadpath_with({"run", (entry.path() / "project.toml").string(), "--quiet"});
      CHECK(ran.code == 1);
      CHECK(ran.out.starts_with("FAIL  "));
      ++count;
    }
    CHECK(count >= 3);
  }

  TEST_CASE("--quiet prints the verdict line unless it is a pass") {
    CHECK(loadpath_with({"run", shaft, "--quiet"}).out.empty());
    const Ran ran =
        Desk().run({"run", "-", "--quiet"},
                   "[key]\ncalculator = \"shaft.torsion\"\nT = \"100 N*m\"\nd = \"40 mm\"\nG = \"81 GPa\"\n");
    CHECK(ran.code == 4);
    CHECK(ran.out.starts_with("INCOMPLETE  "));
    CHECK(ran.out.find('\n') + 1 == ran.out.size());
  }

  TEST_CASE("a typing error that breaks a rule at many places is reported at thirty of them") {
    std::string many;
    for (int i = 0; i < 40; ++i) many += "[s" + std::to_string(i) + "]\ncalculator = \"shaft.torsion\"\nT = \"1 mm\"\n";
    const Ran ran = Desk().run({"run", "-"}, many);
    CHECK(ran.code == 2);
    CHECK(contains(ran.error, " more of these are not shown\n"));
    std::size_t shown = 0;
    for (std::size_t at = ran.error.find(": error: "); at != std::string::npos;
         at = ran.error.find(": error: ", at + 1))
      ++shown;
    CHECK(shown <= 30);
  }

  TEST_CASE("in a locale of another encoding bars are ASCII") {
    const Ran ran = Desk().run({"run", shaft}, "", {{"LC_ALL", "C"}});
    CHECK(contains(ran.out, " 0.859 ########"));
    CHECK_FALSE(contains(ran.out, "█"));
  }

  TEST_CASE("a search without a solution names the sizes tried and the nearest") {
    const std::string strut =
        "[strut]\ncalculator = \"column.buckling\"\nP = \"149 kN\"\nl = \"840 mm\"\nends = \"pinned_pinned\"\n"
        "d = \"?\"\nmaterial = \"S235JR\"\nmethod = \"euler\"\nsigma_P = \"235 MPa\"\nn_st = 3\n";
    const Ran ran = Desk().run({"run", "-"}, strut);
    CHECK(ran.code == 1);
    CHECK(ran.out.starts_with("NO SOLUTION  strut: d of R40: none passes\n"));
    CHECK(contains(ran.out, "\nNo solution: strut: d of R40: none passes, nearest is 37.5 mm"));
    CHECK(contains(ran.out, "\n  tried    fails\n  33.5 mm  "));
    CHECK(contains(ran.out, "\n  40 mm    "));
    CHECK_FALSE(contains(ran.out, "Not assessed"));  // the modes have no result because the search has none
  }
}
