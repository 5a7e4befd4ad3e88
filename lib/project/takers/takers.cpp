#include "lib/project/takers/takers.hpp"

#include <utility>

namespace loadpath::project {

namespace {

/// "shaft" of "shaft.T"; of a value its path, "values.P".
std::string source_in(const std::string& path) {
  return path.starts_with("values.") ? path : path.substr(0, path.find('.'));
}

/// Every step and value that a reading refers to.
void for_each_source(const Reading& reading, const std::function<void(std::string)>& visit) {
  for_each_reference(reading, [&](const std::string& path) { visit(source_in(path)); });
  for (const Taken& record : reading.records) visit(source_in(record.source));
  for (const auto& [key, typed] : reading.typed) {
    if (!typed.shared.empty()) visit(typed.shared);
  }
}

}  // namespace

void Takers::add(const std::string& name, const Reading& reading) {
  const std::size_t position = size_++;
  by_name_.emplace(name, position);
  for_each_source(reading, [&](std::string source) {
    std::vector<std::size_t>& takers = takers_[std::move(source)];
    if (takers.empty() || takers.back() != position) takers.push_back(position);
  });
}

std::optional<std::size_t> Takers::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? std::nullopt : std::optional(found->second);
}

const std::vector<std::size_t>& Takers::of(std::string_view source) const {
  static const std::vector<std::size_t> none;
  const auto found = takers_.find(source);
  return found == takers_.end() ? none : found->second;
}

}  // namespace loadpath::project
