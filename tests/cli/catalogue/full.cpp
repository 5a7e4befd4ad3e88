#include "calculators/catalogue.hpp"
#include "tests/cli/process.hpp"
#include "tests/tries.hpp"

#include <regex>

using namespace loadpath;
using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Ran described(const std::string& id) { return loadpath_with({"describe", id, "--full"}); }

/// The text with one space for every break of a line.
std::string in_one_line(std::string text) {
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    const std::size_t next = std::min(text.find_first_not_of(' ', at + 1), text.size());
    text.replace(at, next - at, " ");
  }
  return text;
}

/// The length of the longest line before the example, in characters.
std::size_t longest_line(const std::string& shown) {
  std::size_t longest = 0, length = 0;
  for (const char c : shown.substr(0, shown.find("Example, a project file"))) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    length = c == '\n' ? 0 : length + (continues ? 0 : 1);
    longest = std::max(longest, length);
  }
  return longest;
}

}  // namespace

TEST_SUITE("cli describe in full") {
  TEST_CASE("every calculator is described with all its fields") {
    Share share(4);
    for (const Calculator* calculator : calculators()) {
      if (share.skips()) continue;
      CAPTURE(calculator->id);
      const Ran o = described(calculator->id);
      CHECK(o.code == 0);
      const std::string text = in_one_line(o.out);
      CHECK(contains(text, in_one_line(calculator->scope)));
      CHECK(longest_line(o.out) <= 100);
      for (const FieldInfo& field : calculator->input->fields) CHECK(contains(o.out, std::string("  ") + field.key));
      for (const RuleInfo& rule : calculator->rules) CHECK(contains(text, rule.text));
    }
  }

  TEST_CASE("the keys that every step has are described with its inputs") {
    const std::string column = described("column.buckling").out;
    for (const char* key : {"calculator", "material", "section", "title, note", "display", "accept"})
      CHECK(contains(column, "\n  " + std::string(key) + " "));
    CHECK(contains(column, "[project]"));
    CHECK_FALSE(contains(column, "\n  template "));
    CHECK(contains(described("mechanism.planar").out, "\n  template "));
  }

  TEST_CASE("an element alone is described with its calculators, and a name after it makes an id") {
    const Ran shaft = loadpath_with({"describe", "shaft"});
    CHECK(shaft.code == 2);
    CHECK(contains(shaft.error,
                   "= help: 'shaft' is an element; `loadpath describe` takes one of shaft.torsion, shaft.overhung"));
    CHECK(contains(loadpath_with({"describe", "torsion"}).error, "= help: did you mean 'shaft.torsion'?"));
    CHECK(loadpath_with({"describe", "shaft", "torsion"}).out == loadpath_with({"describe", "shaft.torsion"}).out);
  }

  TEST_CASE("a count that is required, or may be left out, has no default") {
    const std::string shown = described("gear.pair").out;
    CHECK(std::regex_search(shown, std::regex("\n  z_1 +integer +required ")));
    CHECK(std::regex_search(shown, std::regex("\n  z_2 +integer +optional ")));
    CHECK(contains(shown, "\"?\""));  // of T_1, which may be as large as passes
  }

  TEST_CASE("results with paths from names are described by patterns with unit and meaning") {
    const std::string shown = described("mechanism.planar").out;
    CHECK(contains(shown, "Results, NAME as in the project file\n"));
    CHECK(contains(shown, " N        magnitude of the joint's force\n"));
    CHECK(contains(shown, " N*m      moment of the first link on the second at the first"));
    for (const char* path : {"drive.M", "drive.P", "cylinders.NAME.F", "joints.NAME.x", "joints.NAME.F",
                             "joints.NAME.N_front", "links.NAME.M_b", "springs.NAME.F", "links.NAME.phi",
                             "links.NAME.omega", "points.NAME.x", "points.NAME.a_y"}) {
      CAPTURE(path);
      CHECK(contains(shown, "\n  " + std::string(path) + " "));
    }
  }

  TEST_CASE("the example that is shown runs") {
    Share share(8);
    for (const Calculator* calculator : calculators()) {
      if (share.skips()) continue;
      const std::string shown = described(calculator->id).out;
      const std::string head = "Example, a project file that runs:\n\n";
      const Ran o = Desk().run({"run", "-"}, shown.substr(shown.find(head) + head.size()));
      CAPTURE(o.error);
      CHECK((o.code <= 1 || o.code == 4));
    }
  }

  TEST_CASE("a calculator lists its templates, and each is described with its mechanism and an example that runs") {
    const std::string planar = described("mechanism.planar").out;
    CHECK(contains(planar, "\n  slider_crank          Slider-crank, central or offset"));
    CHECK(contains(planar, "`loadpath describe mechanism.planar.NAME` shows one\n"));
    const Ran o = loadpath_with({"describe", "mechanism.planar.slider_crank"});
    CHECK(o.code == 0);
    CHECK(o.out.starts_with("mechanism.planar.slider_crank: Slider-crank, central or offset\n"));
    CHECK(contains(o.out, "\n  r         mm              required      length of the crank OA (must be > 0 mm)\n"));
    CHECK(contains(o.out, "Makes\n  ground               O, G\n  links                crank, rod, slider\n"));
    CHECK(contains(o.out, "\n  links.crank.points   O, A, S_crank\n"));
    const std::string head = "Example, a project file that runs:\n\n";
    CHECK(Desk().run({"run", "-"}, o.out.substr(o.out.find(head) + head.size())).code == 0);
    CHECK(loadpath_with({"describe", "mechanism.planar.slidercrank"}).error ==
          "loadpath: unknown calculator 'mechanism.planar.slidercrank'\n  = help: did you mean "
          "'mechanism.planar.slider_crank'?\n");
  }

  TEST_CASE("a calculator that does not exist is reported with the nearest one") {
    const Ran o = loadpath_with({"describe", "shaft.torsoin"});
    CHECK(o.code == 2);
    CHECK(o.error == "loadpath: unknown calculator 'shaft.torsoin'\n  = help: did you mean 'shaft.torsion'?\n");
    CHECK(loadpath_with({"describe", "shaft.teapot"}).error ==
          "loadpath: unknown calculator 'shaft.teapot'\n  = help: `loadpath list shaft` shows all\n");
    CHECK(loadpath_with({"describe", "teapot"}).error ==
          "loadpath: unknown calculator 'teapot'\n  = help: `loadpath list` shows all\n");
  }

  TEST_CASE("the schema is what the program writes") {
    const Ran o = loadpath_with({"schema"});
    CHECK(o.code == 0);
    CHECK(o.out.starts_with("{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\","));
  }
}
