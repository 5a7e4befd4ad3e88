// Random mechanisms whose answers come from an independent solver: slider-cranks, four-bars, Watt and Stephenson
// six-bars, slotted levers, class III groups, chains of up to 50 dyads.
#include "lib/mechanism/group_system.hpp"
#include "lib/mechanism/structure.hpp"
#include "lib/mechanism/whole_system.hpp"
#include "tests/lib/mechanism/reference.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

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
    errors.add("angular speed", v.phi, number(theirs, "omega"));
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

  TEST_CASE("random mechanisms give no findings") {
    for (const char* name : {"kulisa_turning_2", "class3_1", "watt_2_3", "chain_10_1"}) {
      CAPTURE(name);
      const auto file = read(std::filesystem::path(LOADPATH_TEST_DATA) / (std::string(name) + ".json"));
      CHECK(diagnose(model_of(file.at("model")).model).empty());
    }
  }
}
