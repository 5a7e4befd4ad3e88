#include "lib/project/series_choice.hpp"

#include "lib/project/project.hpp"

#include <algorithm>
#include <functional>

namespace loadpath::project {

namespace {

/// Where it fails it goes on from the last *, which then stands for one character more.
bool fits(std::string_view text, std::string_view pattern) {
  std::size_t t = 0, p = 0, star = std::string_view::npos, taken = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++taken;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool fits(std::string_view step, std::string_view path, std::string_view pattern) {
  return fits(path, pattern) || fits(std::string(step) + "." + std::string(path), pattern);
}

std::vector<std::string_view> parts_of(std::string_view name) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t end = std::min(name.find('.', from), name.size());
    parts.push_back(name.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

/// A name as a pattern of its kind: `links.rod.N` for `link.*.N` is `links.*.N`. Empty where they have unlike parts.
std::string likened(std::string_view name, std::string_view pattern) {
  const auto own = parts_of(name), wanted = parts_of(pattern);
  if (own.size() != wanted.size()) return {};
  std::string like;
  for (std::size_t k = 0; k < own.size(); ++k) {
    like.append(k == 0 ? "" : ".").append(fits(own[k], wanted[k]) ? wanted[k] : own[k]);
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
    is_value = is_value || (!e.value.is_series() && fits(step, e.path, pattern));
    if (!e.value.is_series()) return;
    add_once(likened(e.path, pattern), near);
    add_once(likened(step + "." + e.path, pattern), near);
    const std::size_t dot = e.path.find('.');
    add_once(dot == std::string::npos ? e.path : e.path.substr(0, dot) + ".*", heads);
  });
  if (is_value)
    return {pattern, say("'{1}' is one value, not a series", pattern),
            say("leave it out: JSON tells every single value")};
  const Message none = heads.empty() ? say("every result is one value") : there_is(heads);
  return {pattern, say("there is no series '{1}'", pattern), did_you_mean(pattern, near, none)};
}

}  // namespace

bool SeriesChoice::holds(std::string_view step, std::string_view path) const {
  return patterns_.empty() || std::any_of(patterns_.begin(), patterns_.end(),
                                          [&](const auto& pattern) { return fits(step, path, pattern); });
}

std::vector<FieldFault> SeriesChoice::check(const Project& project) const {
  std::vector<FieldFault> faults;
  for (const std::string& pattern : patterns_) {
    bool chosen = false;
    for_each_result(project, [&](const std::string& step, const Entry& e) {
      chosen = chosen || (e.value.is_series() && fits(step, e.path, pattern));
    });
    if (!chosen) faults.push_back(fault_of(project, pattern));
  }
  return faults;
}

}  // namespace loadpath::project
