#include "calculators/mechanism/planar_names.hpp"

#include "calculators/mechanism/planar_model.hpp"

#include <algorithm>

namespace loadpath {

namespace {

using Planar = PlanarMechanism;

template <class Items>
bool has(const Items& items, const Name& name) {
  return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
}

}  // namespace

std::string path_of(const char* list, const Name& name, const char* field) {
  return std::string(list) + "." + std::string(name.view()) + (*field == '\0' ? "" : "." + std::string(field));
}

bool NameFaults::require(bool found, const Name& name, const std::string& path, std::string_view kind,
                         const std::vector<std::string>& names) {
  if (found) return true;
  const Message message = kind == "link"    ? say("there is no link '{1}'", name.view())
                          : kind == "joint" ? say("there is no joint '{1}'", name.view())
                                            : say("there is no spring '{1}'", name.view());
  add(path, message, did_you_mean(name.view(), names, there_is(names)));
  return false;
}

bool NameFaults::require_link(const Name& name, const std::string& path) {
  auto names = names_in(in_.links);
  names.emplace_back("ground");
  return require(name.view() == "ground" || has(in_.links, name), name, path, "link", names);
}

bool NameFaults::require_joint(const Name& name, const std::string& path) {
  return require(has(in_.joints, name), name, path, "joint", names_in(in_.joints));
}

bool NameFaults::require_spring(const Name& name, const std::string& path) {
  return require(has(in_.springs, name), name, path, "spring", names_in(in_.springs));
}

bool NameFaults::require_point(int link, const Name& name, const std::string& path) {
  if (find_point(in_, link, name) != nullptr) return true;
  const bool fixed = link == mechanism::ground;
  const auto k = static_cast<std::size_t>(link);
  const auto names = fixed ? names_in(in_.ground) : names_in(in_.links[k].points);
  const std::string owner(fixed ? "ground" : in_.links[k].name.view());
  add(path, say("the link '{1}' has no point '{2}'", owner, name.view()),
      did_you_mean(
          name.view(), names,
          say("give '{1}' among the points of '{2}', or name another point with points = [...]", name.view(), owner)));
  return false;
}

}  // namespace loadpath
