#include "calculators/mechanism/input/names.hpp"

#include "lib/mechanism/model/model.hpp"

namespace loadpath::planar {

std::string path_of(const char* list, std::string_view name, std::string_view field) {
  const std::string path = list + ("." + std::string(name));
  return field.empty() ? path : path + "." + std::string(field);
}

bool NameFaults::require(bool found, const Name& name, const std::string& path, std::string_view kind,
                         const std::vector<std::string>& names) {
  if (found) return true;
  const Message message = kind == "link"     ? say("unknown link '{1}'", name.view())
                          : kind == "joint"  ? say("unknown joint '{1}'", name.view())
                          : kind == "spring" ? say("unknown spring '{1}'", name.view())
                                             : say("unknown load curve '{1}'", name.view());
  add(path, message, did_you_mean(name.view(), names, there_is(names)));
  return false;
}

bool NameFaults::require_link(const Name& name, const std::string& path) {
  auto names = names_in(in_.links);
  names.emplace_back("ground");
  return require(name.view() == "ground" || find_named(in_.links, name) != nullptr, name, path, "link", names);
}

bool NameFaults::require_joint(const Name& name, const std::string& path) {
  return require(find_named(in_.joints, name) != nullptr, name, path, "joint", names_in(in_.joints));
}

bool NameFaults::require_spring(const Name& name, const std::string& path) {
  return require(find_named(in_.springs, name) != nullptr, name, path, "spring", names_in(in_.springs));
}

bool NameFaults::require_course(const Name& name, const std::string& path) {
  return require(find_named(in_.courses, name) != nullptr, name, path, "course", names_in(in_.courses));
}

bool NameFaults::require_point(int link, const Name& name, const std::string& path) {
  if (find_point(in_, link, name) != nullptr) return true;
  const bool fixed = link == mechanism::ground;
  const auto k = static_cast<std::size_t>(link);
  const auto names = fixed ? names_in(in_.ground) : names_in(in_.links[k].points);
  const std::string owner(fixed ? "ground" : in_.links[k].name.view());
  const std::string known = names.empty() ? "" : there_is(names).text() + "; or ";
  const bool of_joint = path.starts_with("joints");  // which names its points in two links
  add(path, say("the link '{1}' has no point '{2}'", owner, name.view()),
      did_you_mean(name.view(), names,
                   of_joint ? say("{1}give '{2}' among the points of '{3}', or name another point with points = [...]",
                                  known, name.view(), owner)
                            : say("{1}give '{2}' among the points of '{3}'", known, name.view(), owner)));
  return false;
}

int link_index(const Mechanism::Input& in, const Name& name) {
  return find_named(in.links, name) == nullptr ? mechanism::ground : static_cast<int>(index_of(in.links, name));
}

const planar::Point* find_point(const Mechanism::Input& in, int link, const Name& name) {
  return link == mechanism::ground ? find_named(in.ground, name)
                                   : find_named(in.links[static_cast<std::size_t>(link)].points, name);
}

}  // namespace loadpath::planar
