// Fields that the command line sets in place of what a project file says.
#include "tests/cli/process.hpp"

using namespace loadpath::test;

namespace {

const std::string shaft = R"toml([values]
n = "750 rpm"

[shaft]
calculator = "shaft.torsion"
T = "900 N*m"
G = "80 GPa"
tau_adm = "30 MPa"
torque = "one_way"
)toml";
const std::string line_shaft = R"toml([shaft]
calculator = "shaft.torsion"
torques = [
  { name = "M1", x = "0 mm", T = "900 N*m" },
  { name = "M2", x = "300 mm", T = "-900 N*m" },
]
G = "80 GPa"
tau_adm = "30 MPa"
)toml";
const std::string press = R"toml([press]
calculator = "mechanism.planar"
template = "slider_crank"
r = "50 mm"
l = "200 mm"
crank = { speed = "60 rpm" }
links.rod.mass = "1 kg"
)toml";

std::string plain_shaft() {
  return shaft.substr(shaft.find("[shaft]"), shaft.find("torque =") - shaft.find("[shaft]"));
}

Ran with(const std::string& project, const std::vector<std::string>& settings,
         const std::vector<std::string>& more = {"--json"}) {
  std::vector<std::string> words{"run", "-"};
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  words.insert(words.end(), more.begin(), more.end());
  return Desk().run(words, project);
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Output of the program for the same fields given in the file itself.
std::string without_heading(const std::string& json) { return json.substr(json.find("\"verdict\"")); }

}  // namespace

TEST_SUITE("cli settings") {
  TEST_CASE("a field that is set counts as if it were in the file") {
    std::string written = plain_shaft();
    written.replace(written.find("900 N*m"), 7, "1.2 kN*m");
    const Ran set = with(plain_shaft(), {"shaft.T=1.2 kN*m"}), asked = with(written, {});
    CHECK(set.code == asked.code);
    CHECK(without_heading(set.out) == without_heading(asked.out));
    CHECK(contains(set.out, "\"set\": \"shaft.T = 1.2 kN*m\""));
    CHECK_FALSE(contains(asked.out, "\"set\""));
  }

  TEST_CASE("fields are added, numbers are numbers, and TOML is taken unchanged") {
    CHECK(contains(with(plain_shaft(), {"shaft.K_A=1.4", "shaft.d={ stock = \"R20\" }"}).out, "smallest of R20"));
    CHECK(contains(with(plain_shaft(), {"shaft.K_A = 1.4"}).out, "shaft.K_A = 1.4"));
    CHECK(contains(with(plain_shaft(), {"shaft.title=2024"}).out, "\"title\": \"2024\""));
    CHECK(contains(with(plain_shaft(), {"project.revision=2"}).out, "\"revision\": \"2\""));
    CHECK(contains(with(plain_shaft(), {"shaft.T==2*450 N*m"}, {}).out, "d = 56 mm"));
  }

  TEST_CASE("nested fields and elements of lists are named") {
    const std::string by_name = without_heading(with(line_shaft, {"shaft.torques.M2.x=400 mm"}).out);
    CHECK(by_name == without_heading(with(line_shaft, {"shaft.torques[2].x=400 mm"}).out));
    CHECK(by_name != without_heading(with(line_shaft, {}).out));
    CHECK(with(press, {"press.links.rod.mass=2 kg", "press.crank.speed=90 rpm"}).code == 0);
    CHECK(with(press, {"press.links.slider.mass=2 kg"}).code == 0);
  }

  TEST_CASE("errors are reported with their place among the settings, and nothing is solved") {
    const Ran step = with(plain_shaft(), {"shaft.K_A=1.4", "shaf.T=1 N*m"}, {});
    CHECK(step.code == 2);
    CHECK(step.out.empty());
    CHECK(step.error ==
          "--set:2:1: error: unknown step 'shaf'\n2 | shaf.T=1 N*m\n  | ^^^^\n  = help: did you mean 'shaft'?\n");
    const Ran field = with(plain_shaft(), {"shaft.tau_ad=1 MPa"}, {});
    CHECK(field.code == 2);
    CHECK(contains(field.error, "--set:1:7: error: "));
    CHECK(contains(field.error, "did you mean 'tau_adm' ("));
    const Ran unit = with(plain_shaft(), {"shaft.tau_adm=30 mpa"}, {});
    CHECK(unit.code == 2);
    CHECK(contains(unit.error, "--set:1:18: error: unknown unit 'mpa'"));
    CHECK(contains(with(line_shaft, {"shaft.torques.M3.x=1 mm"}, {}).error, "unknown element 'M3'"));
    CHECK(contains(with(line_shaft, {"shaft.torques[0].x=1 mm"}, {}).error,
                   "elements are counted from 1, [1] to [2], or named: M1, M2"));
    CHECK(contains(with(line_shaft, {"torques[1].x=1 mm"}, {}).error,
                   "= help: write the step before the field: shaft.torques\n"));
    CHECK(contains(with("", {"shaft.d=1 mm"}, {}).error, "= help: the file has no steps"));
    CHECK(contains(with(line_shaft, {"shaft.torques[3].x=1 mm"}, {}).error, "unknown element '[3]'"));
    const std::string inside = with(line_shaft, {"shaft.tau_adm.x=1 mm"}, {}).error;
    CHECK(contains(inside, "is a text, and has no fields"));
    CHECK(contains(inside, "= help: set the value itself: --set shaft.tau_adm=VALUE\n"));
    CHECK(contains(with(plain_shaft(), {"shaft.d={ stock = "}, {}).error, "--set:1:"));
    for (const char* wrong : {"shaft=1", "shaft.T", "=3", "shaft..T=1", ".T=1"}) {
      CAPTURE(wrong);
      const Ran ran = with(plain_shaft(), {wrong}, {});
      CHECK(ran.code == 2);
      CHECK(contains(ran.error, "sets no field of a step"));
    }
  }

  TEST_CASE("a wrong value of [values] is reported once, not where expressions calculate with it") {
    const std::string file =
        "[values]\nT = \"300 N*m\"\nn = \"1450 rpm\"\n"
        "[a]\ncalculator = \"shaft.torsion\"\nT = \"=values.T\"\ntau_adm = \"30 MPa\"\n"
        "[b]\ncalculator = \"shaft.torsion\"\nT = \"=2*values.T\"\ntau_adm = \"30 MPa\"\n";
    for (const char* wrong : {"values.T=3", "values.T={ a = 3 }", "values.T=[1, 2]", "values.T=oops"}) {
      CAPTURE(wrong);
      const std::string error = with(file, {wrong}, {}).error;
      CHECK(contains(error, "--set:1:"));
      CHECK(error.find(": error: ") == error.rfind(": error: "));
    }
  }

  TEST_CASE("why and sweep take them, too") {
    const Desk desk;
    desk.put("shaft.toml", plain_shaft());
    CHECK(contains(desk.run({"why", "shaft.toml", "shaft", "--set", "shaft.T=1.8 kN*m"}).out, "1800 N·m"));
    const Ran swept = desk.run(
        {"sweep", "shaft.toml", "--json", "--set", "shaft.T={ from = \"100 N*m\", to = \"200 N*m\", count = 3 }"});
    CHECK(swept.code == 0);
    CHECK(contains(swept.out, "\"points\": 3"));
  }

  TEST_CASE("a calculator with a file takes them, for the steps that it refers to as well") {
    const Desk desk;
    desk.put("two.toml", plain_shaft() +
                             "[rod]\ncalculator = \"fatigue.cycle\"\nstress = \"shear\"\nsigma_max = "
                             "\"=shaft.tau_max\"\n"
                             "sigma_min = \"0 MPa\"\n");
    const Ran set = desk.run({"fatigue", "cycle", "--file", "two.toml", "--set", "shaft.d=80 mm", "--json"});
    CHECK(contains(set.out, "\"set\": \"shaft.d = 80 mm\""));
    CHECK(contains(set.out, "\"value\": 0.08"));
    const Ran none = desk.run({"fatigue", "cycle", "--sigma_a", "9 MPa", "--r", "-1", "--set", "rod.r=0"});
    CHECK(none.code == 2);
    CHECK(contains(none.error, "'--set' changes a step of a file"));
    CHECK(contains(desk.run({"fatigue", "cycle", "--file", "two.toml", "--set", "shat.d=80 mm"}).error,
                   "did you mean 'shaft'?"));
  }

  TEST_CASE("a stopped sweep resumes only with the same settings") {
    const Desk desk;
    desk.put("shaft.toml", plain_shaft());
    const std::string range = "shaft.T={ from = \"100 N*m\", to = \"200 N*m\", count = 3 }";
    CHECK(desk.run({"sweep", "shaft.toml", "--out", "s", "--set", range}).code == 0);
    CHECK(desk.run({"sweep", "shaft.toml", "--out", "s", "--resume", "--set", range}).code == 0);
    const Ran other =
        desk.run({"sweep", "shaft.toml", "--out", "s", "--resume", "--set", range, "--set", "shaft.K_A=2"});
    CHECK(other.code == 2);
  }
}
