// A project's settings for its own sweep:
//   [project.sweep]
//   results = ["m = rod.mass", "rod.modes.buckling"]
//   samples = 10000
//   seed = 1
//   sampling = "latin"                                    or "random"
//   zip = [["shaft.T", "shaft.n"]]                        these run together
//   correlations = [{ of = ["shaft.T", "shaft.n"], r = 0.8 }]
#pragma once

#include "lib/text/issue.hpp"
#include "lib/toml/tree.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace loadpath::project {

/// A text of a file or of the shell, and its place.
struct Placed {
  std::string text;
  Place place;
};

struct Correlated {
  Placed first, second;
  double r = 0.0;
};

struct SweepSettings {
  std::vector<Placed> results;
  std::uint64_t samples = 1000;
  std::uint64_t seed = 1;
  bool latin = false;
  std::vector<std::vector<Placed>> zip;
  std::vector<Correlated> correlations;
};

/// Reads the table; unknown fields and invalid values become issues.
void read_sweep_settings(const toml::Tree& table, SweepSettings& settings, std::vector<Issue>& issues);

}  // namespace loadpath::project
