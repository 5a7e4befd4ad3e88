// Results of a mechanism as tables of rows: what every thing of one kind gives, under a path with its name.
#pragma once

#include "calculators/mechanism/planar_outputs.hpp"
#include "lib/units.hpp"

#include <array>
#include <string>
#include <vector>

namespace loadpath::planar {

/// A path with NAME for the thing's own, and how the value is read off a position.
template <class Thing>
struct Row {
  ResultPattern pattern;
  Dimension dimension;
  double (*read)(const Thing&, const mechanism::Position&);
  bool (*has)(const Thing&) = nullptr;  // null: every thing of the kind
};

/// `where`: which things have it, in words.
template <class Thing, class Quantity>
constexpr Row<Thing> row(const char* path, const char* doc, const Unit<Quantity>& unit,
                         double (*read)(const Thing&, const mechanism::Position&), bool (*has)(const Thing&) = nullptr,
                         const char* where = "") {
  return {{path, unit.symbol, doc, where}, unit.dimension(), read, has};
}

inline std::string named(std::string path, const std::string& name) {
  const std::size_t at = path.find("NAME");
  return at == std::string::npos ? path : path.replace(at, 4, name);
}

/// `thing` has a member `name`; the readers keep a copy of it.
template <class Thing, std::size_t Count>
void add_outputs(const Thing& thing, const std::array<Row<Thing>, Count>& rows, std::vector<MechanismOutput>& out) {
  for (const Row<Thing>& r : rows) {
    if (r.has != nullptr && !r.has(thing)) continue;
    out.push_back({named(r.pattern.path, thing.name), r.pattern.doc, r.pattern.unit, r.dimension,
                   [thing, read = r.read](const mechanism::Position& p) { return read(thing, p); }});
  }
}

template <class Rows>
void list_patterns(const Rows& rows, std::vector<ResultPattern>& patterns) {
  for (const auto& r : rows) patterns.push_back(r.pattern);
}

}  // namespace loadpath::planar
