// Helpers for the tests of sweeps: a shaft at 14,000 points, 55 blocks, and folders byte by byte.
#pragma once

#include "tests/cli/process.hpp"

#include <chrono>
#include <string>

namespace loadpath::test {

inline const std::string swept_shaft = R"(
[shaft]
calculator = "shaft.torsion"
tau_adm = "30 MPa"
G = "81 GPa"
theta_adm = "0.25 deg/m"
l = "1 m"
d = { from = "30 mm", to = "60 mm", count = 7 }
T = { mean = "200 N*m", sd = "10 %" }
[project.sweep]
samples = 2000
results = ["tau = shaft.tau_max", "shaft.theta_max"]
)";

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Every file of two folders, byte by byte.
inline bool same_folders(const Desk& desk, const std::string& a, const std::string& b) {
  return desk.shell("diff -r " + a + " " + b).code == 0;
}

/// The duration of an action here: the time of a kill before its end must not depend on the computer's speed.
template <class Action>
std::chrono::microseconds duration_of(const Action& action) {
  const auto begun = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);
}

/// Shell commands that wait until a folder holds solved points or process $at has ended.
inline std::string until_solved(const std::string& folder) {
  return "until loadpath sweep --status " + folder +
         " 2>/dev/null | grep -q '^solved   0 to' || ! kill -0 $at; do sleep 0.02; done; ";
}

}  // namespace loadpath::test
