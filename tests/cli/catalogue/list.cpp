// `list`: all calculators on one screen, those of an element, and those that a word of the field finds.
#include "calculators/catalogue.hpp"
#include "tests/cli/process.hpp"
#include "tests/tries.hpp"

#include <algorithm>
#include <sstream>

using namespace loadpath;
using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool fits_a_screen(const std::string& text) {
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    if (line.size() > 80) return false;
  }
  return count <= 30;
}

/// The id in the first line.
std::string first_of(const std::string& out) { return out.substr(0, out.find(' ')); }

}  // namespace

TEST_SUITE("cli list") {
  TEST_CASE("all calculators by their elements, on a screen of 30 lines of 80 characters") {
    const Ran o = loadpath_with({"list"});
    CHECK(o.code == 0);
    CHECK(fits_a_screen(o.out));
    for (const Calculator* calculator : calculators()) {
      CAPTURE(calculator->id);
      const std::string id = calculator->id;
      const std::string line = "\n  " + id.substr(0, id.find('.')) + " ";
      const std::size_t from = o.out.find(line), name = o.out.find(" " + id.substr(id.find('.') + 1), from);
      REQUIRE(from != std::string::npos);
      CHECK(name != std::string::npos);
    }
  }

  TEST_CASE("the calculators of an element with their titles") {
    const std::string shaft = loadpath_with({"list", "shaft"}).out;
    CHECK(shaft.starts_with("shaft.torsion "));
    CHECK_FALSE(contains(shaft, "gear.pair"));
    for (const Calculator* calculator : calculators()) {
      if (calculator->element() == "shaft") CHECK(contains(shaft, calculator->title));
    }
  }

  TEST_CASE("a technical term finds its calculator first, in English, German and Russian") {
    const std::vector<std::pair<const char*, const char*>> words{{"buckling", "column.buckling"},
                                                                 {"Knickung", "column.buckling"},

                                                                 {"вал", "shaft.torsion"},
                                                                 {"кручение", "shaft.torsion"},
                                                                 {"шпонка", "shaft.key"},
                                                                 {"rainflow", "fatigue.history"},
                                                                 {"goodman", "fatigue.life"},
                                                                 {"hoist", "dynamics.lift"},
                                                                 {"Passfeder", "shaft.key"},
                                                                 {"feather key", "shaft.key"},
                                                                 {"Keilriemen", "belt.v"},
                                                                 {"S-N", "fatigue.wohler"},
                                                                 {"keyway", "shaft.key"},
                                                                 {"Zahnrad", "gear.pair"},
                                                                 {"bevel gear", "gear.bevel"},
                                                                 {"Schnecke", "gear.worm"},
                                                                 {"Schraubradgetriebe", "gear.crossed"},
                                                                 {"подшипник", "bearing.rolling"},
                                                                 {"flywheel", "machine.flywheel"},
                                                                 {"critical speed", "shaft.design"},
                                                                 {"interference fit", "shaft.press_fit"},
                                                                 {"Planetengetriebe", "gear.planetary"},
                                                                 {"slider-crank", "mechanism.planar"},
                                                                 {"двутавр", "section.I"}};
    const Desk desk;
    Share share(8);
    for (const auto& word : words) {
      if (share.skips()) continue;
      CAPTURE(std::string(word.first));
      const Ran o = desk.run({"list", word.first});
      CHECK(o.code == 0);
      CHECK(first_of(o.out).starts_with(word.second));
    }
  }

  TEST_CASE("the name of a machine finds the calculators of its parts, the first of them first") {
    const std::vector<std::pair<const char*, const char*>> words{
        {"fan", "belt.v_sizing"},   {"conveyor", "drive.train"},        {"lift", "dynamics.lift"},
        {"gearbox", "drive.train"}, {"compressor", "mechanism.planar"}, {"wobble drive", "motion.spherical_four_bar"}};
    const Desk desk;
    Share share(8);
    for (const auto& word : words) {
      if (share.skips()) continue;
      CAPTURE(std::string(word.first));
      CHECK(first_of(desk.run({"list", word.first}).out) == word.second);
    }
    const std::string gearbox = desk.run({"list", "gearbox"}).out;
    for (const char* part : {"gear.pair", "gear.rating", "shaft.design", "bearing.rolling", "shaft.key"})
      CHECK(contains(gearbox, std::string("\n") + part + " "));
  }

  TEST_CASE("words for the kind of work do not narrow a search") {
    const Desk desk;
    CHECK(desk.run({"list", "gearbox design"}).out == desk.run({"list", "gearbox"}).out);
    CHECK(first_of(desk.run({"list", "shaft design"}).out) == "shaft.design");
    CHECK(desk.run({"list", "bolt design"}).out == desk.run({"list", "bolt"}).out);
  }

  TEST_CASE("several words need no quotation marks") {
    CHECK(loadpath_with({"list", "press", "fit"}).out == loadpath_with({"list", "press fit"}).out);
    CHECK(loadpath_with({"list", "press", "fit"}).code == 0);
  }

  TEST_CASE("a subject that is not included is reported, with the nearest calculators") {
    const Desk desk;
    for (const std::string word : {"bolt", "Schraube", "hypoid gear", "spring", "пружина", "weld"}) {
      CAPTURE(word);
      const Ran o = desk.run({"list", word});
      CHECK(o.code == 0);
      CHECK(o.out.starts_with("Not included: "));
      CHECK(contains(o.out, "\nNearest:\n"));
    }
  }

  TEST_CASE("a word that finds nothing is reported with the nearest one") {
    const Ran o = loadpath_with({"list", "bucling"});
    CHECK(o.code == 2);
    CHECK(o.error == "loadpath: no calculator matches 'bucling'\n  = help: did you mean 'buckling'?\n");
    CHECK(contains(loadpath_with({"list", "shfat"}).error, "did you mean 'shaft'?"));
  }
}
