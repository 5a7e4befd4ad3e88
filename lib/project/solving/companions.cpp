#include "lib/project/solving/companions.hpp"

#include <algorithm>

namespace loadpath::project {

namespace {

/// Among alternatives, "chain.T_1|T_2", the one that `referred` contains; if it contains none, all.
std::vector<std::string> alternatives_of(const std::string& companion, const std::string& prefix,
                                         const std::set<std::string>& referred) {
  std::vector<std::string> all, meant;
  for (std::size_t from = 0; from <= companion.size();) {
    const std::size_t to = std::min(companion.find('|', from), companion.size());
    const std::string key = companion.substr(from, to - from);
    all.push_back(from == 0 ? key : prefix + key);
    if (referred.count(all.back()) != 0) meant.push_back(all.back());
    from = to + 1;
  }
  return meant.empty() ? all : meant;
}

}  // namespace

std::vector<std::string> companions_of(const Project& project, const std::string& path,
                                       const std::set<std::string>& referred) {
  const auto [name, rest] = split_step(path);
  const Step* step = project.find(name);
  std::vector<std::string> all;
  if (step == nullptr) return all;
  for (const std::string& companion : step->companions_of(rest)) {
    for (std::string& one : alternatives_of(companion, path.substr(0, path.rfind('.') + 1), referred))
      all.push_back(std::move(one));
  }
  return all;
}

}  // namespace loadpath::project
