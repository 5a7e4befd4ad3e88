#include "lib/project/unknown_series.hpp"

#include <algorithm>
#include <functional>

namespace loadpath::project {

namespace {

std::vector<std::string_view> parts_of(std::string_view name) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t end = std::min(name.find('.', from), name.size());
    parts.push_back(name.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

/// A name as a pattern of its kind: `links.rod.N` for `link.*.N` is `links.*.N`. Empty if they have unlike parts.
std::string likened(std::string_view name, std::string_view pattern) {
  const auto own = parts_of(name), wanted = parts_of(pattern);
  if (own.size() != wanted.size()) return {};
  std::string like;
  for (std::size_t k = 0; k < own.size(); ++k) {
    like.append(k == 0 ? "" : ".").append(fits_pattern(own[k], wanted[k]) ? wanted[k] : own[k]);
  }
  return like;
}

void add_once(std::string name, std::vector<std::string>& names) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

using Visit = std::function<void(const std::string& step, const Entry& result)>;
void for_each_result(const Project& project, const Visit& visit) {
  for (const auto& step : project.steps) {
    for (const Entry& e : step->account().results) visit(step->name(), e);
  }
}

FieldFault fault_of(const Project& project, const std::string& pattern) {
  std::vector<std::string> near, heads;
  bool is_value = false;
  for_each_result(project, [&](const std::string& step, const Entry& e) {
    is_value = is_value || (!e.value.is_series() && fits_pattern(step, e.path, pattern));
    if (!e.value.is_series()) return;
    add_once(likened(e.path, pattern), near);
    add_once(likened(step + "." + e.path, pattern), near);
    const std::size_t dot = e.path.find('.');
    add_once(dot == std::string::npos ? e.path : e.path.substr(0, dot) + ".*", heads);
  });
  if (is_value)
    return {pattern, say("'{1}' is one value, not a series", pattern), say("leave it out: JSON lists every value")};
  const Message none = heads.empty() ? say("every result is one value") : there_is(heads);
  return {pattern, say("unknown series '{1}'", pattern), did_you_mean(pattern, near, none)};
}

}  // namespace

std::vector<FieldFault> unknown_series(const SeriesChoice& choice, const Project& project) {
  std::vector<FieldFault> faults;
  for (const std::string& pattern : choice.patterns()) {
    bool chosen = false;
    for_each_result(project, [&](const std::string& step, const Entry& e) {
      chosen = chosen || (e.value.is_series() && fits_pattern(step, e.path, pattern));
    });
    if (!chosen) faults.push_back(fault_of(project, pattern));
  }
  return faults;
}

}  // namespace loadpath::project
