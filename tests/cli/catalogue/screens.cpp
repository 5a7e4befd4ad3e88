// What `describe` shows first: one calculator on one screen, an example that runs, one field.
#include "calculators/catalogue.hpp"
#include "lib/calculator/choice_words.hpp"
#include "tests/cli/process.hpp"
#include "tests/parts.hpp"
#include "tests/tries.hpp"

#include <algorithm>

using namespace loadpath;
using namespace loadpath::test;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The longest line, in characters.
std::size_t width_of(const std::string& text) {
  std::size_t longest = 0, length = 0;
  for (const char c : text) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    length = c == '\n' ? 0 : length + (continues ? 0 : 1);
    longest = std::max(longest, length);
  }
  return longest;
}

auto lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

/// The command under "Example"; empty where there is none.
std::string command_of(const std::string& shown) {
  const std::string head = "\nExample\n";
  const std::size_t from = shown.find(head), to = shown.find("\nIn a file", std::min(from, shown.size()));
  return from == std::string::npos ? "" : shown.substr(from + head.size(), to - from - head.size());
}

bool is_verdict(int code) { return code == 0 || code == 1 || code == 4; }

}  // namespace

TEST_SUITE("cli describe" * by_case * takes_share) {
  TEST_CASE("every calculator fits on a screen of 30 lines of 80 characters") {
    const Desk desk;
    for (const Calculator* calculator : calculators()) {
      CAPTURE(calculator->id);
      const Ran o = desk.run({"describe", calculator->id});
      CHECK(o.code == 0);
      CHECK(o.out.starts_with(std::string(calculator->id) + "  " + calculator->title + "\n"));
      CHECK(lines_of(o.out) <= 30);
      CHECK(width_of(o.out) <= 80);
      CHECK(contains(o.out, "\nSource "));
      CHECK_FALSE(contains(o.out, " ...\n"));  // complete phrases only
      CHECK(contains(o.out, "--toml prints a project that runs"));
    }
  }

  TEST_CASE("the screen shows what is required, sized, usual, assessed here and elsewhere") {
    const std::string torsion = loadpath_with({"describe", "shaft.torsion"}).out;
    CHECK(contains(torsion, "\nSized      d "));
    CHECK(contains(torsion, "\"?\" or omitted: from R40"));
    CHECK(contains(torsion, "           tau_adm "));
    CHECK(contains(torsion, "           material "));
    CHECK(contains(torsion, " more inputs: --full, or: loadpath describe shaft.torsion FIELD\n"));
    CHECK(contains(torsion, "\nResults    "));
    CHECK(contains(torsion, "\nAssesses   "));
    CHECK(contains(torsion, "(theta_adm)"));
    CHECK(contains(torsion, "\nNot here   "));
    CHECK(contains(torsion, "shaft.design"));
    CHECK(contains(loadpath_with({"describe", "shaft.overhung"}).out, "\nRequired   F "));
    CHECK(contains(loadpath_with({"describe", "mechanism.planar"}).out, "\nTemplates  slider_crank, "));
    CHECK(loadpath_with({"describe", "shaft", "torsion"}).out == torsion);
  }

  TEST_CASE("--toml prints the example alone, and it runs, for every calculator and template") {
    const Desk desk;
    Share share(12);
    for (const Calculator* calculator : calculators()) {
      if (share.skips()) continue;
      CAPTURE(calculator->id);
      const Ran o = desk.run({"describe", calculator->id, "--toml"});
      CHECK(o.code == 0);
      CHECK(o.out == calculator->example);
      const Ran ran = desk.run({"run", "-", "--quiet"}, o.out);
      CAPTURE(ran.error);
      CHECK(is_verdict(ran.code));
      for (const Template* t : calculator->templates)
        CHECK(desk.run({"describe", std::string(calculator->id) + "." + t->id, "--toml"}).out == t->example);
    }
    CHECK(is_verdict(desk.shell("loadpath describe shaft.torsion --toml > x.toml && loadpath run x.toml").code));
  }

  TEST_CASE("the command of the example gives the same as the file") {
    const Desk desk;
    std::size_t commands = 0;
    Share share(12);
    for (const Calculator* calculator : calculators()) {
      if (share.skips()) continue;
      CAPTURE(calculator->id);
      const std::string command = command_of(desk.run({"describe", calculator->id}).out);
      if (command.empty()) continue;
      ++commands;
      const Ran typed = desk.shell(command);
      CAPTURE(typed.error);
      CHECK(typed.code == desk.run({"run", "-"}, calculator->example).code);
    }
    CHECK(commands > (sanitized ? 0 : calculators().size() / 3));
    CHECK(contains(command_of(desk.run({"describe", "shaft.overhung"}).out), "--a \"50 mm\""));
  }

  TEST_CASE("every input and every failure mode is described by its key") {
    const Desk desk;
    std::size_t at = 0;
    for (const Calculator* calculator : calculators()) {
      const std::string id = calculator->id;
      CAPTURE(id);
      for (const FieldInfo& field : calculator->input->fields) {
        if (!is_tried(at++, one_of(sanitized ? 20 : 10))) continue;
        const Ran o = desk.run({"describe", id, field.key});
        CAPTURE(field.key);
        CHECK(o.code == 0);
        CHECK(contains(o.out, id + "." + field.key + "  "));
      }
      for (const ModeInfo& mode : calculator->modes) {
        if (!is_tried(at++, one_of(sanitized ? 20 : 10))) continue;
        const Ran o = desk.run({"describe", id, mode.id});
        CAPTURE(mode.id);
        CHECK(o.code == 0);
        CHECK(contains(o.out, "accept." + std::string(mode.id) + " = \"reason\"\n"));
      }
    }
  }

  TEST_CASE("an input has unit, bounds, usual range, sources, users and an example") {
    const std::string twist = loadpath_with({"describe", "shaft.torsion", "theta_adm"}).out;
    CHECK(contains(twist, "  unit       deg/m\n"));
    CHECK(contains(twist, "  bounds     > 0°/m\n"));
    CHECK(contains(twist, "  usual      0.02°/m to 10°/m\n"));
    CHECK(contains(twist, "(twist)\n"));
    CHECK(contains(twist, "  example    theta_adm = \"0.004 rad/m\"\n"));
    CHECK(contains(loadpath_with({"describe", "shaft", "torsion", "G"}).out,
                   "  filled by  material = \"NAME\", column G; rows: loadpath tables\n"));
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "d"}).out, "\"?\" or omitted: the smallest of R40"));
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "torques"}).out, "\n  torques[].x "));
    const std::string x = loadpath_with({"describe", "shaft.torsion", "torques[].x"}).out;
    CHECK(contains(x, "  bounds   >= 0 mm\n"));
    CHECK(contains(x, "  example  x = \"0 mm\"\n"));
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "material"}).out, "  fills  "));
  }

  TEST_CASE("a result is described with how another step takes it, a check with the number by which it passes") {
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "phi"}).out, "KEY = \"=STEP.phi\" in another step\n"));
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "segments.tau"}).out, "\"=STEP.segments[1].tau\""));
    const std::string check = loadpath_with({"describe", "shaft.torsion", "u_theta"}).out;
    CHECK(contains(check, "passes up to 1\n"));
    CHECK(contains(check, "where theta_adm is given\n"));
    CHECK(contains(loadpath_with({"describe", "mechanism.planar", "joints.NAME.F"}).out, "\"=STEP.joints.NAME.F\""));
    CHECK(contains(loadpath_with({"describe", "mechanism.planar", "e"}).out, "slider_crank"));
  }

  TEST_CASE("a row and a failure mode of the same name are both described") {
    const std::string key = loadpath_with({"describe", "shaft.key", "key"}).out;
    CHECK(contains(key, "row of a table"));
    CHECK(contains(key, "key = \"?\" finds the first row that passes"));
    CHECK(contains(key, "failure mode key"));
  }

  TEST_CASE("a template after its calculator, and a field of a list with the list") {
    CHECK(loadpath_with({"describe", "mechanism.planar", "slider_crank"}).out ==
          loadpath_with({"describe", "mechanism.planar.slider_crank"}).out);
    CHECK(loadpath_with({"describe", "shaft.design", "way"}).error.find("did you mean 'seats.way'?") !=
          std::string::npos);
  }

  TEST_CASE("an unknown name is reported with the similar ones and their meanings") {
    const Ran near = loadpath_with({"describe", "shaft.torsion", "thetaadm"});
    CHECK(near.code == 2);
    CHECK(near.out.empty());
    CHECK(contains(near.error, "'shaft.torsion' has no input, result, failure mode or part 'thetaadm'"));
    CHECK(contains(near.error, "did you mean 'theta_adm' (allowable "));
    CHECK(contains(loadpath_with({"describe", "shaft.torsion", "teapot"}).error,
                   "`loadpath describe shaft.torsion --full` shows all"));
  }
}
