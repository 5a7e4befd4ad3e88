// Values of a mechanism for other steps: signatures, records, and simultaneous results.
#include "calculators/mechanism/results/values.hpp"
#include "calculators/mechanism/step.hpp"

#include <algorithm>
#include <cmath>

namespace loadpath::planar {

namespace {

/// The links, joints or other parts that a result can be of, if that of the path is none of them, nor near one.
std::vector<std::string> sibling_names(const std::string& path, const std::vector<std::string>& paths) {
  const std::size_t point = path.find('.');
  if (point == std::string::npos) return {};
  const std::string part = path.substr(point + 1, path.find('.', point + 1) - point - 1);
  std::vector<std::string> names;
  for (const std::string& known : paths) {
    const std::size_t end = known.find('.', point + 1);
    if (end == std::string::npos || known.compare(0, point + 1, path, 0, point + 1) != 0) continue;
    const std::string one = known.substr(point + 1, end - point - 1);
    if (std::find(names.begin(), names.end(), one) == names.end()) names.push_back(one);
  }
  const bool is_near = std::find(names.begin(), names.end(), part) != names.end() || !nearest(part, names).empty();
  return is_near ? std::vector<std::string>{} : names;
}

}  // namespace

Outcome<Signature> MechanismStep::signature(const std::string& path) const {
  if (outputs_.empty()) return Fault{};  // the model has holes, which are reported
  const auto found = std::find_if(outputs_.begin(), outputs_.end(), [&](const auto& o) { return o.path == path; });
  if (found != outputs_.end())
    return Signature{found->what.dimension, found->is_single ? nullptr : axis_.get(),
                     found->what.facts.is_load && !found->what.facts.is_tension};
  if (const Leaf given = given_at(path)) return Signature{given.field->dimension, nullptr};
  std::vector<std::string> paths;
  for (const auto& o : outputs_) paths.push_back(o.path);
  const Message unknown = say("'{1}' has no result '{2}'", name(), path);
  if (const auto parts = sibling_names(path, paths); !parts.empty())
    return Fault{0, path.size(), unknown, there_is(parts)};
  return Fault{
      0, path.size(), unknown,
      did_you_mean(path, paths, say("`loadpath describe {1}` lists them", input().calculator->id), name() + ".")};
}

std::vector<project::Member> MechanismStep::members(const std::string& path) const {
  std::vector<project::Member> members;
  const auto add = [&](const std::string& of, const std::string& key, const char* as) {
    const std::string full = of + "." + key;
    const bool known = std::any_of(outputs_.begin(), outputs_.end(), [&](const auto& o) { return o.path == full; });
    if (known) members.push_back({as, full});
  };
  for (const Output& o : outputs_) {
    if (o.path.starts_with(path + ".")) members.push_back({o.path.substr(path.size() + 1), o.path});
  }
  const std::string joint = "joints." + std::string(data().crank.joint.view());
  const std::string& shaft = path == "drive" ? joint : path;
  if (path.starts_with("links.")) add(path, "length", "l");
  if (path == "drive") add(path, "M", "T");
  if (path == "drive") add(joint, "F", "F");
  if (shaft.starts_with("joints.")) add(shaft, "x", "F_x"), add(shaft, "y", "F_y");
  return members;
}

Leaf MechanismStep::given_at(const std::string& path) const {
  const project::Reading& reading = input().reading;
  for (const Record* record : {&reading.parameters, &reading.record}) {
    if (record->type == nullptr) continue;
    const Leaf leaf = find_leaf(*record, path);
    const bool number =
        leaf && (leaf.field->type == FieldInfo::Type::quantity || leaf.field->type == FieldInfo::Type::count);
    if (number && std::isfinite(leaf.get())) return leaf;
  }
  return {};
}

std::vector<std::string> MechanismStep::companions_of(const std::string& path) const {
  const auto taken = std::find_if(outputs_.begin(), outputs_.end(), [&](const auto& o) { return o.path == path; });
  if (taken == outputs_.end()) return {};
  std::vector<std::string> all;
  for (const std::string& key : listed_keys(taken->what.facts.with))
    all.push_back(name() + "." + path.substr(0, path.rfind('.') + 1) + key);
  const bool of_crank = path.starts_with("joints.") && taken->name == in_.crank.joint.view();
  if (of_crank) {  // the drive acts on the same shaft
    for (const auto& o : outputs_) {
      if (o.what.facts.kind == Kind::drive_moment) all.push_back(name() + "." + o.path);
    }
  }
  if (!taken->what.facts.loads_crank) return all;
  const auto force = std::find_if(outputs_.begin(), outputs_.end(), [&](const auto& o) {
    return o.what.facts.kind == Kind::joint_force && o.name == in_.crank.joint.view();
  });
  all.push_back(name() + "." + force->path);
  return all;
}

}  // namespace loadpath::planar
