// Many values where a field takes one:
//   { from = "100 N*m", to = "200 N*m", step = "10 N*m" }   or count = 11, or log = 11, each as many times the last
//   ["20 mm", "25 mm"]
//   { each = "R40", from = "20 mm", to = "60 mm" }          the sizes of a stock, all where no ends are given
//   { from = "20 mm", to = "60 mm" }                        any value between: for searches of the best design
// and where its value is uncertain:
//   { mean = "200 N*m", sd = "5 %" }                        normal; distribution = "lognormal"
//   { value = "40 mm", tolerance = "0.1 mm" }               uniform; distribution = "normal" (3 sd), "triangular"
//   { min = "0 mm", max = "1 mm" }, { min, mode, max }      uniform, triangular
//   { scale = "200 MPa", shape = 12 }                       Weibull; with a least value, location = "100 MPa"
#pragma once

#include "lib/quantity/dimension.hpp"
#include "lib/sweep/point/axis.hpp"
#include "lib/sweep/point/distribution.hpp"
#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <functional>
#include <optional>
#include <string>

namespace loadpath::project {

/// Conversion of a text or number to SI: a field refuses values that it does not allow; false, with the issue
/// reported.
using ToSi = std::function<bool(const toml::Tree& literal, double& si)>;
/// An issue at a place of the tree.
using Refuse = std::function<void(const Place& place, Message message, Message hint)>;

/// Whether a value of a project is a list or a range, and no history.
bool is_grid(const toml::Tree& tree);
/// Whether it has a distribution, or is a range of designs without steps.
bool is_uncertain(const toml::Tree& tree);

/// The values of a range or a list in SI, in its order. Empty if an issue was reported.
std::optional<sweep::Axis> read_grid(const toml::Tree& tree, const Dimension& dimension, const ToSi& to_si,
                                     const Refuse& refuse);
std::optional<sweep::Distribution> read_uncertain(const toml::Tree& tree, const Dimension& dimension, const ToSi& to_si,
                                                  const Refuse& refuse);

/// { each = "R40" }: the stock; empty if the tree is none.
std::string stock_of(const toml::Tree& tree);

}  // namespace loadpath::project
