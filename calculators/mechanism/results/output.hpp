// Outputs of a planar mechanism to other steps: results with their paths, and their evaluation from the solution.
#pragma once

#include "calculators/mechanism/results/declaration.hpp"
#include "lib/mechanism/model/position.hpp"
#include "lib/text/issue.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace loadpath::planar {

class Results;
struct Solved;

/// A position, and what mechanism::PositionFunctions derives there: null where that is not known.
struct Reached {
  const mechanism::Position& at;
  const mechanism::Position* derivative;
};

/// How results are read off a position: those of one thing together, so that what they share is found once.
struct Reading {
  struct Together {
    std::size_t count = 0;
    std::function<void(const Reached&, std::span<double> values)> read;
    /// One of them at each of the positions, if it follows from these alone; null: they share what is found there.
    std::function<void(std::span<const mechanism::Position>, std::size_t place, std::span<double> values)> read_one =
        nullptr;
  };
  std::shared_ptr<const Together> together;
  std::size_t place = 0;  // position of this result among them

  Reading() = default;
  Reading(std::shared_ptr<const Together> all, std::size_t own) : together(std::move(all)), place(own) {}
  /// Output of a single result: a function of the position.
  template <class Read>
  requires std::is_invocable_r_v<double, Read, const mechanism::Position&> Reading(
      Read read)  // NOLINT(google-explicit-constructor)
      : together(std::make_shared<const Together>(
            Together{1, [read](const Reached& reached, std::span<double> values) { values[0] = read(reached.at); }})) {}
};

struct Output {
  struct Values {
    std::vector<double> si;  // one for every position, or one
    Message missing;         // why there are none, or not everywhere; empty: there are, or it goes without saying
    Values(std::vector<double> values, Message reason = {})  // NOLINT(google-explicit-constructor)
        : si(std::move(values)), missing(std::move(reason)) {}
  };
  Declaration what;
  std::string name;  // name of its object: "A"; empty for the full mechanism
  std::string path;  // "joints.A.F"
  Reading read = {};
  /// In place of `read`, of all that is solved.
  std::function<Values(const Solved&)> read_cycle = {};
  bool is_single = false;
  /// In place of `read`, of the results before it; these kinds of them.
  std::function<Values(const Results&)> read_results = {};
  std::vector<Kind> results_read = {};
};

/// The path with this name in place of NAME.
std::string named(const char* path, const std::string& name);
/// Not read off anything yet.
Output output(const Declaration& what, const std::string& name);

}  // namespace loadpath::planar
