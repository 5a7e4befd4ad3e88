#include "calculators/catalogue.hpp"
#include "tests/cli/process.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_SUITE("cli describe") {
  TEST_CASE("every calculator is listed and described with all its fields") {
    const std::string list = loadpath_with({"list"}).out;
    for (const Calculator* calculator : calculators()) {
      CAPTURE(calculator->id);
      CHECK(contains(list, calculator->id));
      const Ran o = loadpath_with({"describe", calculator->id});
      CHECK(o.code == 0);
      CHECK(contains(o.out, calculator->scope));
      for (const FieldInfo& field : calculator->input->fields) CHECK(contains(o.out, std::string("  ") + field.key));
      for (const RuleInfo& rule : calculator->rules) CHECK(contains(o.out, rule.text));
    }
  }

  TEST_CASE("results whose paths come from names are described by patterns with unit and meaning") {
    const std::string shown = loadpath_with({"describe", "mechanism.planar"}).out;
    CHECK(contains(shown, "Results, NAME as in the project file\n"));
    CHECK(contains(shown, " N        magnitude of the joint's force\n"));
    CHECK(contains(shown,
                   " N*m      couple of the first link on the second at the first link's point (prismatic joints)\n"));
    for (const char* path : {"drive.M", "drive.P", "cylinders.NAME.F", "joints.NAME.x", "joints.NAME.F",
                             "joints.NAME.N_front", "links.NAME.M_b", "springs.NAME.F", "links.NAME.phi",
                             "links.NAME.omega", "points.NAME.x", "points.NAME.a_y"}) {
      CAPTURE(path);
      CHECK(contains(shown, "\n  " + std::string(path) + " "));
    }
  }

  TEST_CASE("the example that is shown runs") {
    for (const Calculator* calculator : calculators()) {
      const std::string shown = loadpath_with({"describe", calculator->id}).out;
      const std::string head = "Example, a project file that runs:\n\n";
      const Ran o = Desk().run({"run", "-"}, shown.substr(shown.find(head) + head.size()));
      CAPTURE(o.error);
      CHECK(o.code <= 1);
    }
  }

  TEST_CASE("a calculator lists its templates, and each is described with what it makes and an example that runs") {
    const std::string planar = loadpath_with({"describe", "mechanism.planar"}).out;
    CHECK(contains(planar, "\n  slider_crank          Slider-crank, central or offset"));
    CHECK(contains(planar, "`loadpath describe mechanism.planar.NAME` tells more\n"));
    const Ran o = loadpath_with({"describe", "mechanism.planar.slider_crank"});
    CHECK(o.code == 0);
    CHECK(o.out.starts_with("mechanism.planar.slider_crank: Slider-crank, central or offset\n"));
    CHECK(contains(o.out, "\n  r         mm              required      length of the crank OA (must be > 0 mm)\n"));
    CHECK(contains(o.out, "Makes\n  ground               O, G\n  links                crank, rod, slider\n"));
    CHECK(contains(o.out, "\n  links.crank.points   O, A, S_crank\n"));
    const std::string head = "Example, a project file that runs:\n\n";
    CHECK(Desk().run({"run", "-"}, o.out.substr(o.out.find(head) + head.size())).code == 0);
    CHECK(loadpath_with({"describe", "mechanism.planar.slidercrank"}).error ==
          "loadpath: there is no calculator 'mechanism.planar.slidercrank'\n  = help: did you mean "
          "'mechanism.planar.slider_crank'?\n");
  }

  TEST_CASE("a calculator that does not exist is told with the nearest one") {
    const Ran o = loadpath_with({"describe", "shaft.torsoin"});
    CHECK(o.code == 2);
    CHECK(o.error == "loadpath: there is no calculator 'shaft.torsoin'\n  = help: did you mean 'shaft.torsion'?\n");
    CHECK(loadpath_with({"describe", "teapot"}).error ==
          "loadpath: there is no calculator 'teapot'\n  = help: `loadpath list` shows all\n");
  }

  TEST_CASE("the schema is what the program writes") {
    const Ran o = loadpath_with({"schema"});
    CHECK(o.code == 0);
    CHECK(o.out.starts_with("{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\","));
  }
}
