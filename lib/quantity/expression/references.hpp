// The references of an expression: as written in the text, as declared when the file is read, and with their values.
#pragma once

#include "lib/quantity/series.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace loadpath::expression {

/// A reference as written, and its position in the text (bytes).
struct Reference {
  std::string path;
  std::size_t at = 0;
};
/// The signature of a path, when the file is read; a Fault (its `at` is ignored) for an unknown path.
using Declared = std::function<Outcome<Signature>(const std::string& path)>;
/// The value of a path, when the project is solved; the paths are those that passed `check`.
using Known = std::function<const Value&(const std::string& path)>;
/// The number of a path that is not a series.
using Single = std::function<double(const std::string& path)>;
/// The values of a path at many points.
using Column = std::function<const double*(const std::string& path)>;

}  // namespace loadpath::expression
