// Why a part came out as it did, from the shell.
#include "tests/cli/process.hpp"
#include "tests/lib/project/texts.hpp"

using namespace loadpath::test;

namespace {

const std::string bar = R"toml(calculator = "column.buckling"
ends = "pinned_pinned"
E = "210 GPa"
R_e = "235 MPa"
method = "johnson"
n_st = 2
)toml";
const std::string rod = "[rod]\n" + bar + "N = \"=press.links.rod.N\"\nl = \"200 mm\"\nd = \"?\"\n";
const std::string strut = "[strut]\n" + bar + "P = \"40 kN\"\nl = \"2 m\"\nsection = { stock = \"sections/ipe\" }\n";
const std::string end = R"toml([end]
calculator = "shaft.overhung"
F = "2 kN"
a = "50 mm"
T = "90 N*m"
sigma_adm = "60 MPa"
tau_adm = "30 MPa"
)toml";
const std::string weak = end + "d = \"20 mm\"\n";

Ran why(const std::string& project, const std::string& of = "") {
  std::vector<std::string> words{"why", "-"};
  if (!of.empty()) words.push_back(of);
  return Desk().run(words, project);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool before(const std::string& text, const std::string& first, const std::string& second) {
  return contains(text, first) && text.find(first) < text.rfind(second) && contains(text, second);
}

}  // namespace

TEST_SUITE("cli why") {
  TEST_CASE("without a step it explains the one that governs the verdict, and the exit code is that of the project") {
    const Ran all = why(press_of_heavy_rod + rod);
    CHECK(all.code == 4);
    CHECK(all.out.starts_with("INCOMPLETE  "));
    CHECK(contains(all.out, "(column.buckling)\n"));
    CHECK(why(end).code == 0);
    CHECK(why(weak).out.starts_with("FAIL  "));
    CHECK(why(weak).code == 1);
  }

  TEST_CASE("for a step: the verdict, the size, the governing mode with its formulas and inputs, what is missing") {
    const Ran answer = why(press_of_heavy_rod + rod, "rod");
    CHECK(answer.code == 4);
    CHECK(before(answer.out, "\n* d = ", "\nGoverning: "));
    CHECK(before(answer.out, "\nGoverning: ", "\n  u = F / P_all "));
    CHECK(before(answer.out, "\n  u = F / P_all ", "\nFrom\n"));
    CHECK(before(answer.out, "\nFrom\n", "\nNot assessed: "));
    CHECK(contains(answer.out, "link.member"));
  }

  TEST_CASE("a failure is explained with its formulas") {
    const Ran answer = why(weak, "end");
    CHECK(answer.code == 1);
    CHECK(before(answer.out, "FAIL  ", "\n  u_v = "));
    CHECK(before(answer.out, "\nFrom\n", "\n  sigma_adm "));
    CHECK_FALSE(contains(answer.out, "\n  tau_adm "));
  }

  TEST_CASE("a found size is explained, by its step, by its name, and by the result of that name") {
    const std::string reason = "smallest of R40 with which no assessed mode fails; 26.5 mm fails: u_v =";
    CHECK(contains(why(end, "end").out, "\n* d = 28 mm; 26.5 mm fails: "));
    CHECK(contains(why(end, "end.d").out, reason));
    CHECK_FALSE(contains(why(end, "end.d").out, "\n  d  28 mm  outer diameter\n"));
  }

  TEST_CASE("a found row is explained") {
    CHECK(contains(why(strut, "strut").out, "\n* IPE "));
    CHECK(contains(why(strut, "strut.section").out, " smallest of sections/ipe with which no assessed mode fails"));
  }

  TEST_CASE("a mode is explained with its formulas, together with what governs the step") {
    const Ran answer = why(press_of_heavy_rod + rod, "rod.buckling");
    CHECK(answer.code == 4);
    CHECK(contains(answer.out, ")\n  pass  buckling "));
    CHECK(contains(answer.out, "\n  u = F / P_all "));
    CHECK(before(answer.out, "\ngoverns rod\n", "link.member"));
    CHECK_FALSE(contains(why(press_of_heavy_rod + rod, "rod.lateral").out, "\ngoverns "));
    CHECK_FALSE(contains(why(end, "end.yield").out, "\ngoverns "));
  }

  TEST_CASE("a result is explained with its formulas only, and the inputs that they start from") {
    const Ran answer = why(end, "end.sigma_b");
    CHECK(answer.code == 0);
    CHECK(contains(answer.out, "= M_b / W "));
    CHECK_FALSE(contains(answer.out, "Tresca"));
    CHECK(before(answer.out, "\nfrom\n", "\n  F "));
    CHECK_FALSE(contains(answer.out, "sigma_adm"));
  }

  TEST_CASE("a series is explained by its extremes and their places") {
    const Ran answer = why(press_of_heavy_rod, "press.links.rod.N");
    CHECK(answer.code == 0);
    CHECK(contains(answer.out, "\n  links.rod.N  -172.718 N (at 180°) to 222.066 N (at "));
  }

  TEST_CASE("a missing value is explained as missing") {
    const std::string axle = "[axle]\ncalculator = \"shaft.torsion\"\n" + no_torque + "tau_adm = \"30 MPa\"\n" + relay;
    CHECK(contains(why(axle, "axle.T").out, "\n  T  not available"));
    CHECK(why(axle, "axle.T").code == 4);
  }

  TEST_CASE("a mode that does not apply is shown as such") {
    const Ran answer = why(strut, "strut.tension");
    CHECK(answer.code == 0);
    CHECK(contains(answer.out, "\n  does not apply here  tension  yielding in tension\n"));
  }

  TEST_CASE("an unknown name is refused before any output") {
    const Ran step = why(end, "edn"), value = why(end, "end.sigma_c"), beyond = why(end, "end.d.x");
    for (const Ran* ran : {&step, &value, &beyond}) {
      CHECK(ran->code == 2);
      CHECK(ran->out.empty());
    }
    CHECK(step.error == "loadpath: unknown step 'edn'\n  = help: did you mean 'end'?\n");
    CHECK(
        contains(value.error, "'end' has no result and no failure mode 'sigma_c'\n  = help: did you mean 'end.sigma_"));
    CHECK(why("[end]\nF = 3\n").code == 2);
    CHECK(loadpath_with({"why", "nothing.toml"}).code == 2);
  }

  TEST_CASE("errors in a file of the project are shown with their line") {
    const Desk desk;
    desk.put("own.toml", "table = \"mine\"\ngroup = \"material\"\nunits = { Re = \"MPa\" }\n");
    desk.put("a.toml", "[project]\ntables = [\"own.toml\"]\n" + end);
    CHECK(contains(desk.run({"why", "a.toml"}).error, "\n3 | units = { Re = \"MPa\" }\n"));
  }
}
