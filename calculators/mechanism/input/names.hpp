// Finds the objects of the names in a mechanism, and collects faults of names.
#pragma once

#include "calculators/mechanism/input/mechanism.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::planar {

inline void append(std::vector<FieldFault> more, std::vector<FieldFault>& faults) {
  std::move(more.begin(), more.end(), std::back_inserter(faults));
}

class NameFaults {
 public:
  explicit NameFaults(const Mechanism::Input& in) : in_(in) {}

  [[nodiscard]] const Mechanism::Input& input() const { return in_; }
  [[nodiscard]] bool none() const { return faults_.empty(); }
  [[nodiscard]] std::vector<FieldFault> take() { return std::move(faults_); }

  void add(std::string path, Message message, Message hint = {}) {
    faults_.push_back({std::move(path), std::move(message), std::move(hint)});
  }
  void add(std::vector<FieldFault> more) { append(std::move(more), faults_); }

  /// False, and a fault at `path`, where the mechanism has no such link; the ground is one.
  bool require_link(const Name& name, const std::string& path);
  bool require_joint(const Name& name, const std::string& path);
  bool require_spring(const Name& name, const std::string& path);
  bool require_course(const Name& name, const std::string& path);
  /// Requires a point of an existing link, or of the ground.
  bool require_point(int link, const Name& name, const std::string& path);

 private:
  bool require(bool found, const Name& name, const std::string& path, std::string_view kind,
               const std::vector<std::string>& names);

  const Mechanism::Input& in_;
  std::vector<FieldFault> faults_;
};

inline std::string text(const Name& name) { return std::string(name.view()); }

/// The element of a list that has this name; nullptr where there is none.
template <class Items>
auto find_named(const Items& items, const Name& name) -> decltype(&*items.begin()) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? nullptr : &*found;
}
/// The place in its list of one that is there.
template <class Items>
std::size_t index_of(const Items& items, const Name& name) {
  return static_cast<std::size_t>(find_named(items, name) - &*items.begin());
}

/// The names of the elements of a list.
template <class Items>
std::vector<std::string> names_in(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) names.emplace_back(item.name.view());
  return names;
}

/// The index of a link, or mechanism::ground.
int link_index(const Mechanism::Input& in, const Name& name);
/// The point of a link in the link's axes; nullptr where it has none of that name.
const planar::Point* find_point(const Mechanism::Input& in, int link, const Name& name);

/// Some of the values of a choice.
template <class Value>
class Some {
 public:
  constexpr Some(std::initializer_list<Value> values) {
    for (const Value value : values) bits_ |= 1U << static_cast<unsigned>(value);
  }
  [[nodiscard]] constexpr bool has(Value value) const { return (bits_ >> static_cast<unsigned>(value) & 1U) != 0; }

 private:
  unsigned bits_ = 0;
};

/// The path of a named element of a list, or of a field of it: "links.rod.S".
std::string path_of(const char* list, std::string_view name, std::string_view field = {});
inline std::string path_of(const char* list, const Name& name, std::string_view field = {}) {
  return path_of(list, name.view(), field);
}

}  // namespace loadpath::planar
