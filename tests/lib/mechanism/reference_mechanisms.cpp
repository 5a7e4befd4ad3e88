// Random mechanisms whose answers come from an independent solver: slider-cranks, four-bars, Watt and Stephenson
// six-bars, slotted levers, class III groups, chains of up to 50 dyads.
#include "lib/mechanism/group_system.hpp"
#include "lib/mechanism/structure.hpp"
#include "lib/mechanism/whole_system.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace loadpath::mechanism;
namespace json = boost::json;

json::value read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return json::parse(text.str());
}

double number(const json::value& object, const char* key) { return object.at(key).to_number<double>(); }
double optional_number(const json::value& object, const char* key) {
  const auto* value = object.as_object().if_contains(key);
  return value ? value->to_number<double>() : 0.0;
}
Vec vec(const json::value& pair) { return {pair.at(0).to_number<double>(), pair.at(1).to_number<double>()}; }
std::string text(const json::value& object, const char* key) { return json::value_to<std::string>(object.at(key)); }

struct Named {
  Model model;
  std::map<std::string, int> links{{"ground", ground}};
  [[nodiscard]] int link(const json::value& object, const char* key) const { return links.at(text(object, key)); }
};

void add_links(const json::value& given, Named& named) {
  for (const auto& body : given.at("bodies").as_array()) {
    const auto& pose = body.at("pose");
    named.links[text(body, "name")] = static_cast<int>(named.model.links.size());
    named.model.links.push_back({text(body, "name"), number(body, "m"), number(body, "J"), vec(body.at("com")),
                                 Pose{vec(pose).x, vec(pose).y, pose.at(2).to_number<double>()}});
  }
}

void add_joints(const json::value& given, Named& named) {
  for (const auto& joint : given.at("joints").as_array()) {
    const bool revolute = text(joint, "type") == "revolute";
    named.model.joints.push_back({text(joint, "name"), revolute ? JointKind::revolute : JointKind::prismatic,
                                  named.link(joint, "i"), named.link(joint, "j"), vec(joint.at("pi")),
                                  vec(joint.at("pj")), optional_number(joint, "dir"), optional_number(joint, "ang")});
  }
}

void add_loads(const json::value& given, Named& named) {
  for (const auto& load : given.at("loads").as_array()) {
    Load added{.name = text(load, "name"), .link = named.link(load, "body"), .point = {}, .force = {}};
    if (text(load, "type") == "moment") {
      added.moment = number(load, "M");
    } else {
      added.point = vec(load.at("p"));
      added.force = vec(load.at("F"));
      added.turns_with_link = text(load, "frame") == "body";
    }
    named.model.loads.push_back(added);
  }
}

Named model_of(const json::value& given) {
  Named named;
  add_links(given, named);
  add_joints(given, named);
  add_loads(given, named);
  named.model.gravity = vec(given.at("gravity"));
  for (const auto& driver : given.at("drivers").as_array()) {
    named.model.drivers.push_back(
        {text(driver, "name"), Driver::Kind::rotary, named.link(driver, "i"), named.link(driver, "j")});
  }
  return named;
}

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
  const double speed = number(driver, "w");
  const double acceleration = number(driver, "eps");
  System system(named.model);
  REQUIRE(system.assemble() == Status::closed);
  Position mine = blank_position(named.model);
  Errors errors;
  const auto& answers = file.at("answers").as_array();
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto& answer = answers[k * stride % answers.size()];
    const double t = number(answer, "t");
    const Drive drive{number(driver, "q0") + (speed + acceleration * t / 2.0) * t, speed + acceleration * t,
                      acceleration};
    REQUIRE(system.solve({&drive, 1}, mine) == Status::closed);
    double energy = 0.0;
    compare_motion(named.model, mine, answer, errors, energy);
    compare_forces(named, mine, answer, drive.speed, errors);
  }
  return errors.worst(kind);
}

template <class System>
void check_all(std::size_t stride) {
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(LOADPATH_TEST_DATA)) files.push_back(file.path());
  std::ranges::sort(files);
  REQUIRE(files.size() == 34);
  for (const auto& path : files) {
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
