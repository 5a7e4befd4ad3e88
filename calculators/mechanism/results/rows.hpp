// Results of a mechanism as tables of rows: what every thing of one kind gives, under a path with its name.
#pragma once

#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/results/results.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace loadpath::planar {

/// Source of the rows of a thing at a position: the value of its `now`, if it has one, once for all of them; else the
/// position itself.
template <class Thing>
decltype(auto) now_of(const Thing& thing, const Reached& reached) {
  if constexpr (requires { thing.now(reached); }) {
    return thing.now(reached);
  } else if constexpr (requires { thing.now(reached.at); }) {
    return thing.now(reached.at);
  } else {
    return (reached.at);
  }
}
template <class Thing>
using Now = std::remove_cvref_t<decltype(now_of(std::declval<const Thing&>(), std::declval<const Reached&>()))>;

/// A result of a thing, and how its value is read off.
template <class Thing>
struct Row {
  Declaration what;
  double (*read)(const Thing&, const Now<Thing>&);
  bool (*has)(const Thing&) = nullptr;  // null: every thing of the kind
};

/// `where`: which things have it, in words.
template <class Thing, class Quantity>
constexpr Row<Thing> row(const char* path, const char* doc, const Unit<Quantity>& unit, const Facts& facts,
                         double (*read)(const Thing&, const Now<Thing>&), bool (*has)(const Thing&) = nullptr,
                         const char* where = "") {
  return {declare(path, doc, unit, where, facts), read, has};
}
template <class Thing, class Quantity>
constexpr Row<Thing> row(const char* path, const char* doc, const Unit<Quantity>& unit,
                         double (*read)(const Thing&, const Now<Thing>&), bool (*has)(const Thing&) = nullptr,
                         const char* where = "") {
  return row<Thing>(path, doc, unit, {}, read, has, where);
}

/// `thing` has a member `name`; the readers keep a copy of it.
template <class Thing, std::size_t Count>
void add_outputs(const Thing& thing, const std::array<Row<Thing>, Count>& rows, std::vector<Output>& out) {
  std::vector<Row<Thing>> own;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
               [&](const Row<Thing>& r) { return r.has == nullptr || r.has(thing); });
  const auto read = [thing, own](const Reached& reached, std::span<double> values) {
    const auto& now = now_of(thing, reached);
    for (std::size_t n = 0; n < own.size(); ++n) values[n] = own[n].read(thing, now);
  };
  Reading::Together all{own.size(), read};
  if constexpr (std::is_same_v<Now<Thing>, mechanism::Position>) {
    all.read_one = [thing, own](std::span<const mechanism::Position> at, std::size_t place, std::span<double> values) {
      std::ranges::transform(at, values.begin(), [&, read_of = own[place].read](const mechanism::Position& position) {
        return read_of(thing, position);
      });
    };
  }
  const auto together = std::make_shared<const Reading::Together>(std::move(all));
  for (std::size_t n = 0; n < own.size(); ++n) {
    out.push_back(output(own[n].what, thing.name));
    out.back().read = {together, n};
  }
}

template <class Rows>
void list_patterns(const Rows& rows, std::vector<ResultPattern>& patterns) {
  for (const auto& r : rows) patterns.push_back(r.what.pattern);
}

}  // namespace loadpath::planar
