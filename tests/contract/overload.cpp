// A thousand times the load, every size held: nothing passes that can break.
#include "calculators/catalogue.hpp"
#include "lib/account/state.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "tests/contract/held.hpp"
#include "tests/parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace {

using namespace loadpath;
using account::State;

constexpr double overload = 1e3;
constexpr int least_steps = 150;  // of the examples and reference cases, so that none is lost in silence

struct Reason {
  std::string_view of, why;
};

/// Calculators of parts that no load breaks, as far as they look.
constexpr const char* properties = "it gives properties of a section; what carries a load takes them";
constexpr const char* laws = "it gives motion or forces; what carries them takes them";
constexpr std::array unbroken{
    Reason{"section.circle", properties},
    Reason{"section.ellipse", properties},
    Reason{"section.ring", properties},
    Reason{"section.rectangle", properties},
    Reason{"section.I", properties},
    Reason{"section.channel", properties},
    Reason{"section.angle", properties},
    Reason{"section.T", properties},
    Reason{"section.hollow", properties},
    Reason{"section.polygon", properties},
    Reason{"column.effective_length", "it gives the length that column.buckling takes"},
    Reason{"fatigue.endurance", "it gives the strength that fatigue.cycle takes"},
    Reason{"fatigue.wohler", "it gives the life at a stress that fatigue.cycle judges"},
    Reason{"fatigue.staircase", "it gives the strength that fatigue.life takes"},
    Reason{"fatigue.survival", "it gives the strength that fatigue.life takes"},
    Reason{"motion.point", laws},
    Reason{"motion.along_path", laws},
    Reason{"motion.rotation", laws},
    Reason{"motion.plane", laws},
    Reason{"motion.compound", laws},
    Reason{"dynamics.force", laws},
    Reason{"dynamics.motion", laws},
    Reason{"dynamics.path_work", laws},
    Reason{"motion.spatial", laws},
    Reason{"motion.spherical_four_bar", laws},
    Reason{"motion.universal_joint", "speeds and torques; the strength of the joint is not covered"},
    Reason{"dynamics.impulse", laws},
    Reason{"dynamics.momentum", laws},
    Reason{"dynamics.mass_centre", laws},
    Reason{"dynamics.inertia", "it gives the moment of inertia that others take"},
    Reason{"dynamics.angular_momentum", laws},
};

/// Modes of strength that pass however large the load is.
constexpr const char* by_speed = "speed and sizes decide";
constexpr const char* by_sizes = "sizes decide";
constexpr const char* by_tension =
    "the tension or pressing force that is not typed grows with the load; strength holds";
constexpr const char* by_balance = "all forces on it grow alike, and so does what drives it";
constexpr std::array without_load{
    Reason{"bearing.rolling speed", by_speed},
    Reason{"belt.course grip", by_tension},
    Reason{"belt.course lifting", by_tension},
    Reason{"belt.flat bending", by_sizes},
    Reason{"belt.flat grip", by_tension},
    Reason{"belt.flat speed", by_speed},
    Reason{"belt.flat twist", by_sizes},
    Reason{"belt.grooved bending", by_sizes},
    Reason{"belt.grooved grip", by_tension},
    Reason{"belt.grooved speed", by_speed},
    Reason{"belt.synchronous pulley", by_sizes},
    Reason{"belt.synchronous speed", by_speed},
    Reason{"belt.v bending", by_speed},
    Reason{"belt.v pulley", by_sizes},
    Reason{"belt.v rim", by_speed},
    Reason{"belt.v sharing", "a count of belts that was typed"},
    Reason{"belt.v speed", by_speed},
    Reason{"belt.v wrap", by_sizes},
    Reason{"belt.v_sizing bending", by_speed},
    Reason{"belt.v_sizing rim", by_speed},
    Reason{"chain.inverted_tooth speed", by_speed},
    Reason{"chain.roller speed", by_speed},
    Reason{"column.beam_column local", "class 3 at the yield strength"},
    Reason{"column.beam_column slenderness", by_sizes},
    Reason{"column.buckling local", "class 3 at the yield strength"},
    Reason{"column.buckling slenderness", by_sizes},
    Reason{"column.lightest local", "class 3 at the yield strength"},
    Reason{"column.lightest slenderness", by_sizes},
    Reason{"drive.friction_wheels grip", by_tension},
    Reason{"dynamics.lift reach", by_balance},
    Reason{"dynamics.lift slack", by_balance},
    Reason{"dynamics.throw landing", by_speed},
    Reason{"dynamics.throw reach", by_speed},
    Reason{"dynamics.work reach", "the force is zero, or drives it on"},
    Reason{"gear.bevel dynamic", by_speed},
    Reason{"gear.rating dynamic", by_speed},
    Reason{"gear.sizing dynamic", by_speed},
    Reason{"link.member inertia", by_speed},
    Reason{"link.member local", "class 3 at the yield strength"},
    Reason{"link.member slenderness", by_sizes},
    Reason{"machine.disc strength", by_speed},
    Reason{"machine.run_up stall", "its points are of motor and load alike, and are no single load"},
    Reason{"shaft.design critical_bending", by_speed},
    Reason{"shaft.design critical_torsion", by_speed},
    Reason{"shaft.circlip opening", by_speed},
    Reason{"shaft.press_fit hub", by_sizes},
    Reason{"shaft.press_fit shaft", by_sizes},
    Reason{"shaft.set_screw safety", "the safety that is asked for is given, not found; slip judges the load with it"},
    Reason{"vessel.autofrettage reverse", "the autofrettage pressure decides, not that in service"},
    Reason{"vessel.ellipsoid knuckle", "its proof is a bound of the slenderness"},
};

template <class List>
bool lists(const List& list, std::string_view of) {
  return std::any_of(list.begin(), list.end(), [&](const Reason& reason) { return reason.of == of; });
}

std::string name_of(const project::Step& step, const account::Mode& mode) {
  return std::string(step.input().calculator->id) + " " + mode.id;
}

/// The modes of a step held so; nothing where that load is refused, with the reason.
std::optional<account::Modes> modes_under(const project::Step& step, double load_factor, std::string& refused) {
  const std::string text = test::held(step, load_factor);
  std::vector<Issue> issues;
  project::Project project = project::read_project(text, "held.toml", catalogue(), issues);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false, .unused = false});
  if (!has_errors(issues)) return project::modes(project);
  refused = text + render(issues, [&](const std::string&) { return text; });
  return std::nullopt;
}

/// Whether the program would end as passed: all that applies is judged, accepted or open.

bool has_strength(const Calculator& calculator) {
  return std::any_of(calculator.modes.begin(), calculator.modes.end(),
                     [](const ModeInfo& mode) { return mode.kind == ModeKind::strength; });
}

/// The series of a flywheel is not a single value that could be typed; its rim bursts by its speed.
bool can_be_held(const project::Step& step) {
  const std::string_view id = step.input().calculator->id;
  return step.input().calculator->evaluate != nullptr && id != "machine.flywheel" && id != "machine.motion";
}

}  // namespace

TEST_SUITE("contract: overload" * test::by_element) {
  TEST_CASE("a calculator of something that no load can break is in a list with the reason") {
    for (const Calculator* c : test::calculators_taken()) {
      INFO(std::string(c->id));
      CHECK(lists(unbroken, c->id) != has_strength(*c));
    }
  }

  TEST_CASE("under a thousand times its load nothing that can break passes") {
    int steps = 0;
    std::set<std::string> passing;
    test::for_each_step([&](const project::Step& step, const std::string& where) {
      if (!can_be_held(step) || !has_strength(*step.input().calculator)) return;
      std::string refused;
      REQUIRE_MESSAGE(modes_under(step, 1.0, refused), where, "\n", refused);
      const auto loaded = modes_under(step, overload, refused);
      REQUIRE_MESSAGE(loaded, where, "\n", refused);
      ++steps;
      bool can_break = false;
      for (const account::Mode& mode : *loaded) {
        if (mode.kind != ModeKind::strength || mode.state == State::open) continue;
        if (mode.state == State::pass) passing.insert(name_of(step, mode));
        can_break = can_break || !lists(without_load, name_of(step, mode));
      }
      CHECK_MESSAGE(!(can_break && passes(*loaded)), where, " passes");
    });
    for (const std::string& mode : passing) CHECK_MESSAGE(lists(without_load, mode), mode, " passes whatever the load");
    for (const Reason& reason : without_load) {
      if (!test::takes_id(reason.of)) continue;
      CHECK_MESSAGE(passing.count(std::string(reason.of)) == 1, std::string(reason.of), " is decided by the load");
    }
    if (!test::is_part()) CHECK(steps > least_steps);
  }
}
