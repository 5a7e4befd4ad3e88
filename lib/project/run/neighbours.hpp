// Neighbours of typed values: a row of a table or a record that has the same field, or a strength that bounds it.
#pragma once

#include "lib/project/run/evaluation/results.hpp"
#include "lib/project/run/field_role.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::project {

/// A bound of the calculator: its index there, and the element of a list that it bounds.
struct BoundPlace {
  std::size_t bound, element;
};

/// A neighbour of a typed value.
struct Neighbour {
  std::string path;
  Leaf leaf;
  Value value;
  Message source;  // "the material 'S235JR'"
  FieldRole kind = FieldRole::identity;
  bool by_size = false;
  double margin = 0.0;         // an allowable stress is below the strength by this factor; 0: it is none
  bool is_full = false;        // the typed value is the strength, or little below it
  std::string row_of = {};     // the table of the row; empty: of a record, or a strength
  bool is_unassessed = false;  // a value that a step would calculate
  bool is_of_body = false;     // a value of another step of the same body
  std::optional<BoundPlace> of_bound = {};
  /// Up to this a typed value needs no reason, whatever the size; NaN: not known.
  double safe = std::numeric_limits<double>::quiet_NaN();
};

/// Without source_values.hpp. `results`: rows are looked up at the resulting size, if there is one yet.
std::vector<Neighbour> neighbours_of(const Evaluation& evaluation, const Results& results, const Known& known);

/// Whether the user typed the input: a record may have filled it.
bool is_typed(const Reading& reading, const std::string& path);

/// Whether the input is the value of another step as it is; a product with it is typed.
bool is_found(const Reading& reading, const std::string& path);

/// The value of largest magnitude of those that are known.
double largest_magnitude(const Value& value);

}  // namespace loadpath::project
