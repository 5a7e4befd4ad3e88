// Loads travel with their simultaneous loads, and with the factors that they include.
#include "tests/contract/calculators.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace loadpath;

struct Reason {
  std::string_view of, why;
};

/// Results that load a part and name no simultaneous load, "calculator path".
constexpr const char* is_whole = "it is the whole force on the body";
constexpr const char* at_an_end =
    "a coupling takes it over; where a wheel sits, shafts tell its force beside the torque";
constexpr const char* of_stress = "a stress holds what brings it";
constexpr const char* of_a_pin = "a pin that turns brings no moment into its eye and its fork";
constexpr const char* balances = "the forces of the planets balance around the axis";
constexpr std::array alone{
    Reason{"bearing.rolling F_i", "the mating bearing takes it beside a radial load of its own"},
    Reason{"belt.v_sizing candidates.R_new", "a row to choose from; belt.v gives what loads the shafts"},
    Reason{"drive.train T_1", at_an_end},
    Reason{"drive.train T_out", at_an_end},
    Reason{"drive.train stages.T_h", "it loads the housing"},
    Reason{"gear.pair mesh.T_1", "the load of the teeth, for gear.rating; that of the shaft is gear_1"},
    Reason{"gear.planetary T_s", balances},
    Reason{"gear.planetary gear_s.T", balances},
    Reason{"gear.planetary T_c", balances},
    Reason{"gear.planetary T_r", balances},
    Reason{"gear.planetary F_t", "it loads a tooth; on the shaft of the sun the planets balance"},
    Reason{"gear.planetary sun_mesh.T_1", "one mesh of several, for gear.pair; on the shaft of the sun they balance"},
    Reason{"gear.planetary ring_mesh.T_1", "one mesh of several, for gear.pair; on the ring they balance"},
    Reason{"chain.roller F_t", "it loads the chain; what the shafts take is shaft_1, shaft_2"},
    Reason{"shaft.torsion cycle.sigma_max", of_stress},
    Reason{"shaft.held cycle.sigma_max", of_stress},
    Reason{"shaft.held R_1", "it loads what holds the bar"},
    Reason{"shaft.held R_2", "it loads what holds the bar"},
    Reason{"section.thin_walled cycle.sigma_max", of_stress},
    Reason{"section.solid_torsion cycle.sigma_max", of_stress},
    Reason{"pin.joint eye.F", of_a_pin},
    Reason{"pin.joint cheek.F", of_a_pin},
    Reason{"pin.lug cycle.sigma_max", of_stress},
    Reason{"link.member cycle.sigma_max", of_stress},
    Reason{"fatigue.cycle cycle.sigma_max", of_stress},
    Reason{"fatigue.cycle cycle.sigma_min", of_stress},
    Reason{"dynamics.force R", is_whole},
    Reason{"dynamics.force R_max", is_whole},
    Reason{"dynamics.impulse F_m", is_whole},
    Reason{"dynamics.lift weight_states.T", is_whole},
    Reason{"dynamics.work R", is_whole},
    Reason{"vessel.cylinder shell.p", "the pressure on its ends is all that loads them"},
    Reason{"motion.universal_joint M_1", "the torque of the driving shaft, with all that turns on the driven one"},
    Reason{"motion.universal_joint M_1max", "the torque of the driving shaft from the load; M_J is named beside it"},
    Reason{"motion.spherical_four_bar M_1", "the torque of the input, from the load of the output"},
    Reason{"motion.spherical_four_bar M_1max", "the torque of the input, from the load of the output"},
    Reason{"machine.flywheel M_peak", "what else acts comes along with the moments that it is the peak of"},
};

/// Calculators of loads for which simultaneous loads do not matter.
constexpr const char* of_a_body = "its bodies are rigid: loads move them and do not bend them";
constexpr const char* of_a_drive = "power and torque pass through it; its results tell the forces on its shafts";
constexpr const char* of_a_wall = "the pressure is the load of its wall, and comes alone";
constexpr const char* of_energy = "the moments about one axis are its energy; the shaft takes what comes along";
constexpr std::array takes_alone{
    Reason{"drive.train", of_a_drive},
    Reason{"drive.friction_wheels", of_a_drive},
    Reason{"gear.pair", of_a_drive},
    Reason{"gear.planetary", of_a_drive},
    Reason{"gear.rating", of_a_drive},
    Reason{"gear.sizing", of_a_drive},
    Reason{"gear.bevel", of_a_drive},
    Reason{"gear.worm", of_a_drive},
    Reason{"gear.crossed", of_a_drive},
    Reason{"chain.roller", of_a_drive},
    Reason{"chain.inverted_tooth", of_a_drive},
    Reason{"belt.flat", of_a_drive},
    Reason{"belt.v", of_a_drive},
    Reason{"belt.v_sizing", of_a_drive},
    Reason{"belt.synchronous", of_a_drive},
    Reason{"belt.grooved", of_a_drive},
    Reason{"belt.course", of_a_drive},
    Reason{"dynamics.force", of_a_body},
    Reason{"dynamics.impulse", of_a_body},
    Reason{"dynamics.angular_momentum", of_a_body},
    Reason{"dynamics.lift", of_a_body},
    Reason{"dynamics.work", of_a_body},
    Reason{"mechanism.planar", of_a_body},
    Reason{"machine.flywheel", of_energy},
    Reason{"machine.motion", of_energy},
    Reason{"motion.universal_joint", of_a_drive},
    Reason{"motion.spherical_four_bar", of_a_drive},
    Reason{"fatigue.cycle", of_stress},
    Reason{"fatigue.life", of_stress},
    Reason{"fatigue.combined", of_stress},
    Reason{"fatigue.wohler", of_stress},
    Reason{"vessel.cylinder", of_a_wall},
    Reason{"vessel.sphere", of_a_wall},
    Reason{"vessel.cone", of_a_wall},
    Reason{"vessel.ellipsoid", of_a_wall},
    Reason{"vessel.torus", of_a_wall},
    Reason{"vessel.shell", of_a_wall},
    Reason{"vessel.thick", of_a_wall},
    Reason{"vessel.end", of_a_wall},
    Reason{"vessel.flat_end", of_a_wall},
    Reason{"vessel.thick_sphere", of_a_wall},
    Reason{"vessel.compound", of_a_wall},
    Reason{"vessel.autofrettage", of_a_wall},
    Reason{"vessel.external", of_a_wall},
};

using Visit = std::function<void(std::span<const FieldInfo> beside, const FieldInfo& field, const std::string& path)>;

void for_each_field(std::span<const FieldInfo> fields, const std::string& prefix, const Visit& visit) {
  for (const FieldInfo& field : fields) {
    const std::string path = prefix + field.key;
    visit(fields, field, path);
    if (field.has_fields()) for_each_field(field.fields, path + ".", visit);
  }
}

/// Whether a part with this calculator can be loaded by another.
bool takes_loads(const Calculator& c) {
  bool takes = false;
  for_each_field(c.input->fields, "",
                 [&](auto, const FieldInfo& f, const std::string&) { takes = takes || f.is_load; });
  return takes;
}

bool minds_the_rest(const Calculator& c) {
  return std::any_of(c.modes.begin(), c.modes.end(), [](const ModeInfo& m) { return m.by_rest; });
}

/// "T_1|T_2, F_a": T_1, T_2 and F_a.
std::vector<std::string> companions(const FieldInfo& field) {
  std::vector<std::string> keys;
  for (std::string key : listed_keys(field.companions)) {
    for (std::size_t bar = key.find('|'); bar != std::string::npos; bar = key.find('|')) {
      keys.push_back(key.substr(0, bar));
      key.erase(0, bar + 1);
    }
    keys.push_back(std::move(key));
  }
  return keys;
}

template <class List>
bool lists(const List& list, std::string_view of) {
  return std::any_of(list.begin(), list.end(), [&](const Reason& reason) { return reason.of == of; });
}

/// Each of these is in the list, and nothing else of the elements that this run covers is.
template <class List>
void check_listed(const List& list, const std::vector<std::string>& found) {
  for (const std::string& one : found) CHECK_MESSAGE(lists(list, one), one, " needs a reason");
  for (const Reason& reason : list) {
    if (!test::takes_id(reason.of)) continue;
    CHECK_MESSAGE(std::count(found.begin(), found.end(), reason.of) == 1, std::string(reason.of), " needs no reason");
  }
}

}  // namespace

TEST_SUITE("contract" * test::by_element) {
  TEST_CASE("load components next to a load, and the factors that it includes, are fields of its calculator") {
    for (const Calculator* c : test::plain_calculators()) {
      for_each_field(c->result->fields, "", [&](auto beside, const FieldInfo& f, const std::string& path) {
        for (const std::string& key : companions(f)) {
          const bool of_input = path == f.key && find_field(c->input->fields, key) != nullptr;
          CHECK_MESSAGE((find_field_at(beside, key) != nullptr || of_input), c->id, " ", path, " with ", key);
        }
        for (const std::string& key : listed_keys(f.factors)) {
          const FieldInfo* const factor = find_field(c->input->fields, key);
          CHECK_MESSAGE((factor != nullptr && factor->is_factor), c->id, " ", path, " holds ", key);
          CHECK_MESSAGE((f.is_load || f.role == Role::result), c->id, " ", path);
        }
      });
    }
  }

  TEST_CASE("a load that a calculator finds names the components next to it, or is in a list with the reason") {
    std::vector<std::string> unnamed;
    for (const Calculator* c : test::plain_calculators()) {
      for_each_field(c->result->fields, "", [&](auto, const FieldInfo& f, const std::string& path) {
        const bool of_input = path.starts_with("best.");  // inputs of another calculator, handed over
        if (f.is_load && companions(f).empty() && !of_input) unnamed.push_back(std::string(c->id) + " " + path);
      });
    }
    check_listed(alone, unnamed);
  }

  TEST_CASE("a calculator under load takes account of the other load components, or is in a list with the reason") {
    std::vector<std::string> unminding;
    for (const Calculator* c : test::calculators_taken()) {
      if (takes_loads(*c) && !minds_the_rest(*c)) unminding.emplace_back(c->id);
    }
    check_listed(takes_alone, unminding);
  }
}
