// Random mechanisms whose answers come from an independent solver: slider-cranks, four-bars, Watt and Stephenson
// six-bars, slotted levers, class III groups, chains of up to 50 dyads.
#include "lib/mechanism/constraints/system.hpp"
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "tests/lib/mechanism/reference.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace loadpath::mechanism;
namespace json = boost::json;
using namespace reference;

// The largest error and the largest value of each kind over a file.
class Errors {
 public:
  void add(const std::string& kind, double mine, double theirs) {
    auto& [error, size] = kinds_[kind];
    error = std::max(error, std::isfinite(mine) ? std::abs(mine - theirs) : HUGE_VAL);
    size = std::max(size, std::abs(theirs));
  }
  void add(const std::string& kind, Vec mine, Vec theirs) {
    add(kind, mine.x, theirs.x);
    add(kind, mine.y, theirs.y);
  }
  [[nodiscard]] double worst(std::string& kind) const {
    double worst = 0.0;
    for (const auto& [name, of_kind] : kinds_) {
      const double relative = of_kind.first / (of_kind.second > 0.0 ? of_kind.second : 1.0);
      if (relative > worst) kind = name;
      worst = std::max(worst, relative);
    }
    return worst;
  }

 private:
  std::map<std::string, std::pair<double, double>> kinds_;
};

void compare_motion(const Model& model, const Position& mine, const json::value& answer, Errors& errors,
                    double& energy) {
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    const Link& link = model.links[k];
    const auto& theirs = answer.at("bodies").at(link.name);
    const Pose& p = mine.pose[k];
    const Pose& v = mine.velocity[k];
    const Pose& a = mine.acceleration[k];
    const Vec arm = turn(p.phi)(link.centre);
    const Vec velocity = Vec{v.x, v.y} + v.phi * normal(arm);
    errors.add("origin", Vec{p.x, p.y}, vec(theirs.at("origin")));
    errors.add("angle", p.phi, number(theirs, "phi"));
    errors.add("velocity", velocity, vec(theirs.at("v_com")));
    errors.add("angular velocity", v.phi, number(theirs, "omega"));
    errors.add("acceleration", Vec{a.x, a.y} + a.phi * normal(arm) - v.phi * v.phi * arm, vec(theirs.at("a_com")));
    errors.add("angular acceleration", a.phi, number(theirs, "eps"));
    energy += 0.5 * (link.mass * dot(velocity, velocity) + link.inertia * v.phi * v.phi);
  }
  errors.add("kinetic energy", energy, number(answer, "kinetic_energy"));
}

void compare_forces(const Named& named, const Position& mine, const json::value& answer, double speed, Errors& errors) {
  const Model& model = named.model;
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const auto& theirs = answer.at("joints").at(model.joints[k].name);
    const double sense = named.link(theirs, "on") == model.joints[k].i ? 1.0 : -1.0;
    const Vec force = vec(theirs.at("F"));
    const Vec arm = mine.reactions[k].at - vec(theirs.at("at"));
    errors.add("force", sense * mine.reactions[k].force, force);
    errors.add("moment", sense * (mine.reactions[k].couple + cross(arm, mine.reactions[k].force)), number(theirs, "M"));
  }
  const auto& drive = answer.at("drivers").at(model.drivers[0].name);
  errors.add("moment", mine.effort[0], number(drive, "effort"));
  errors.add("power", mine.effort[0] * speed, number(drive, "power"));
}

// `stride`: which of the answered positions follows; prime to their number.
template <class System>
double worst_error(const json::value& file, std::size_t stride, std::string& kind) {
  const Named named = model_of(file.at("model"));
  const auto& driver = file.at("model").at("drivers").at(0);
  System system(named.model);
  REQUIRE(system.assemble() == Status::closed);
  Position mine = blank_position(named.model);
  Errors errors;
  const auto& answers = file.at("answers").as_array();
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto& answer = answers[k * stride % answers.size()];
    const Drive drive = drive_at(driver, number(answer, "t"));
    REQUIRE(system.solve({&drive, 1}, mine) == Status::closed);
    double energy = 0.0;
    compare_motion(named.model, mine, answer, errors, energy);
    compare_forces(named, mine, answer, drive.speed, errors);
  }
  return errors.worst(kind);
}

template <class System>
void check_all(std::size_t stride) {
  const auto all = files();
  REQUIRE(all.size() == 34);
  for (const auto& path : all) {
    CAPTURE(path.filename().string());
    std::string kind;
    const double worst = worst_error<System>(read(path), stride, kind);
    CAPTURE(kind);
    CHECK(worst <= 1e-11);
  }
}

using Loads = std::vector<Load>;

/// On every link a force at a point of it, and a couple.
Loads random_loads(const Model& model, std::mt19937& random) {
  const auto up_to = [&](double size) {
    return size * (2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1.0);
  };
  Loads loads;
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    loads.push_back({"load", static_cast<int>(k), {up_to(0.1), up_to(0.1)}, {up_to(500.0), up_to(500.0)}});
    loads.back().moment = up_to(40.0);
  }
  return loads;
}

Loads mixed(const Loads& a, double of_a, const Loads& b, double of_b) {
  Loads all;
  const auto add = [&](const Loads& loads, double part) {
    for (Load load : loads) {
      load.force = part * load.force;
      load.moment *= part;
      all.push_back(load);
    }
  };
  add(a, of_a);
  add(b, of_b);
  return all;
}

/// The reactions, as force and couple about the origin, then the effort.
template <class System>
std::vector<double> forces_under(Model model, Loads loads, const Drive& drive, bool statics) {
  model.loads = std::move(loads);
  System system(model);
  REQUIRE(system.assemble() == Status::closed);
  Position at = blank_position(model);
  REQUIRE(system.solve({&drive, 1}, at, statics) == Status::closed);
  std::vector<double> forces;
  for (const Reaction& r : at.reactions)
    forces.insert(forces.end(), {r.force.x, r.force.y, r.couple + cross(r.at, r.force)});
  forces.push_back(at.effort[0]);
  return forces;
}

double largest(const std::vector<double>& forces) {
  double most = 0.0;
  for (const double f : forces) most = std::max(most, std::abs(f));
  return most;
}

/// `neither` is in both of the parts.
void check_sum(const std::vector<double>& both, const std::vector<double>& first, const std::vector<double>& second,
               const std::vector<double>& neither) {
  const double size = std::max(largest(first), largest(second));
  double worst = 0.0;
  for (std::size_t k = 0; k < both.size(); ++k)
    worst = std::max(worst, std::abs(both[k] - (first[k] + second[k] - neither[k])));
  CHECK(worst <= 1e-10 * size);
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE_TEMPLATE("random mechanisms agree with an independent solver over a full turn", System, WholeSystem,
                     GroupSystem) {
    check_all<System>(1);
  }

  TEST_CASE_TEMPLATE("random mechanisms keep their assembly over moves of any length", System, WholeSystem,
                     GroupSystem) {
    check_all<System>(7);
  }

  // Without friction, belts or cams that let go the forces are linear in the loads.
  TEST_CASE_TEMPLATE("superposition: random mechanisms respond to loads together as to each of them", System,
                     WholeSystem, GroupSystem) {
    std::mt19937 random(3);
    for (const auto& path : files()) {
      CAPTURE(path.filename().string());
      const auto file = read(path);
      Model model = model_of(file.at("model")).model;
      model.loads.clear();
      model.springs.clear();
      const auto& answers = file.at("answers").as_array();
      const Drive drive = drive_at(file.at("model").at("drivers").at(0), number(answers[answers.size() / 3], "t"));
      const Loads a = random_loads(model, random), b = random_loads(model, random);
      const auto forces = [&](double of_a, double of_b, bool statics) {
        return forces_under<System>(model, mixed(a, of_a, b, of_b), drive, statics);
      };
      const auto neither = forces(0.0, 0.0, false);
      check_sum(forces(1.0, 1.0, false), forces(1.0, 0.0, false), forces(0.0, 1.0, false), neither);
      check_sum(forces(-2.5, 0.5, false), forces(-2.5, 0.0, false), forces(0.0, 0.5, false), neither);
      model.gravity = {};
      const auto none = forces(0.0, 0.0, true), once = forces(1.0, 0.0, true);
      CHECK(largest(none) == 0.0);
      check_sum(forces(2.0, 0.0, true), once, once, none);
      check_sum(none, once, forces(-1.0, 0.0, true), none);
    }
  }

  TEST_CASE("random mechanisms give no findings") {
    for (const char* name : {"slotted_lever_turning_2", "class3_1", "watt_2_3", "chain_10_1"}) {
      CAPTURE(name);
      const auto file = read(std::filesystem::path(LOADPATH_TEST_DATA) / (std::string(name) + ".json"));
      CHECK(diagnose(model_of(file.at("model")).model).empty());
    }
  }
}
