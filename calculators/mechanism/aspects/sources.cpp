#include "calculators/mechanism/aspects/sources.hpp"

#include <algorithm>
#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Structure;

template <class Items, class Holds>
bool any_of(const Items& items, Holds holds) {
  return std::any_of(items.begin(), items.end(), holds);
}

template <class Holds>
bool any_law(const Mechanism::Input& in, Holds holds) {
  return any_of(in.profiles, [&](const CamProfile& profile) {
    return any_of(profile.segments, [&](const CamProfile::Segment& segment) { return holds(segment.law); });
  });
}

struct Cited {
  const char* key;
  bool (*used)(const Mechanism::Input&, const Structure&);
};

constexpr std::array cited{
    Cited{"Trajectories",
          [](const auto& in, const auto&) {
            return any_law(in, [](CamProfile::Law law) { return law != CamProfile::Law::dwell; });
          }},
    Cited{"Rothbart",
          [](const auto& in, const auto&) {
            return any_law(in, [](CamProfile::Law law) { return law == CamProfile::Law::modified_sine; });
          }},
    Cited{"SolidWorks",
          [](const auto& in, const auto&) {
            return any_law(in, [](CamProfile::Law law) { return law == CamProfile::Law::modified_trapezoid; });
          }},
    Cited{"Inventor",
          [](const auto& in, const auto&) {
            return any_of(in.joints, [](const auto& j) { return j.efficiency != 1.0 || is_set(j.efficiency_back); });
          }},
    Cited{"NovaSolver",
          [](const auto& in, const auto&) {
            return any_of(in.joints, [](const auto& j) { return is_set(j.efficiency_back); });
          }},
    Cited{"NIST", [](const auto& in, const auto&) { return !in.accuracy.empty(); }},
    Cited{"Torkia", [](const auto& in, const auto&) { return !in.accuracy.empty(); }},
    Cited{"Wojtyra", [](const auto&, const Structure& structure) { return !structure.redundant.empty(); }}};

}  // namespace

std::vector<std::string> occasional_sources() {
  std::vector<std::string> keys;
  keys.reserve(cited.size());
  for (const Cited& source : cited) keys.emplace_back(source.key);
  return keys;
}

std::vector<std::string> sources_used(const Mechanism::Input& in, const Structure& structure) {
  std::vector<std::string> keys;
  for (const Cited& source : cited) {
    if (source.used(in, structure)) keys.emplace_back(source.key);
  }
  return keys;
}

}  // namespace loadpath::planar
