// Reads the random mechanisms and the answers of an independent solver in tests/mechanism/data; its README.md describes
// the fields.
#pragma once

#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <boost/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace loadpath::mechanism::reference {

namespace json = boost::json;

inline std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(LOADPATH_TEST_DATA)) {
    if (file.path().extension() == ".json") files.push_back(file.path());
  }
  std::ranges::sort(files);
  return files;
}

inline json::value read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return json::parse(text.str());
}

inline double number(const json::value& object, const char* key) { return object.at(key).to_number<double>(); }
inline double optional_number(const json::value& object, const char* key) {
  const auto* value = object.as_object().if_contains(key);
  return value ? value->to_number<double>() : 0.0;
}
inline Vec vec(const json::value& pair) { return {pair.at(0).to_number<double>(), pair.at(1).to_number<double>()}; }
inline std::string text(const json::value& object, const char* key) {
  return json::value_to<std::string>(object.at(key));
}

struct Named {
  Model model;
  std::map<std::string, int> links{{"ground", ground}};
  [[nodiscard]] int link(const json::value& object, const char* key) const { return links.at(text(object, key)); }
};

inline void add_links(const json::value& given, Named& named) {
  for (const auto& body : given.at("bodies").as_array()) {
    const auto& pose = body.at("pose");
    named.links[text(body, "name")] = static_cast<int>(named.model.links.size());
    named.model.links.push_back({text(body, "name"), number(body, "m"), number(body, "J"), vec(body.at("com")),
                                 Pose{vec(pose).x, vec(pose).y, pose.at(2).to_number<double>()}});
  }
}

inline void add_joints(const json::value& given, Named& named) {
  for (const auto& joint : given.at("joints").as_array()) {
    const bool revolute = text(joint, "type") == "revolute";
    named.model.joints.push_back({text(joint, "name"), revolute ? JointKind::revolute : JointKind::prismatic,
                                  named.link(joint, "i"), named.link(joint, "j"), vec(joint.at("pi")),
                                  vec(joint.at("pj")), optional_number(joint, "dir"), optional_number(joint, "ang")});
  }
}

inline void add_loads(const json::value& given, Named& named) {
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

inline Named model_of(const json::value& given) {
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

inline Drive drive_at(const json::value& driver, double t) {
  const double speed = number(driver, "w"), acceleration = number(driver, "eps");
  return {number(driver, "q0") + (speed + acceleration * t / 2.0) * t, speed + acceleration * t, acceleration};
}

}  // namespace loadpath::mechanism::reference
