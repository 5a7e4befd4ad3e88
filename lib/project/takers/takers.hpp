// Steps by name, and by what they refer to: a check of a step against those that take its values goes through these
// only, not through all steps of a project with thousands.
#pragma once

#include "lib/project/read/reading.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

class Takers {
 public:
  /// Adds the next step of the file.
  void add(const std::string& name, const Reading& reading);

  /// The number of steps.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The position of a step in the file; nothing if there is none.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// The positions of the steps that refer to a step, "shaft", or to a value, "values.P", in increasing order.
  [[nodiscard]] const std::vector<std::size_t>& of(std::string_view source) const;

 private:
  std::size_t size_ = 0;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::map<std::string, std::vector<std::size_t>, std::less<>> takers_;
};

}  // namespace loadpath::project
