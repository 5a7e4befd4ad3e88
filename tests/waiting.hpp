// Tests wait for observable events, never for a time: computers differ, and may be busy with other work.
#pragma once

#include <chrono>
#include <thread>

namespace loadpath::test {

/// Waits until a condition holds; false if it does not within minutes.
template <class Condition>
bool becomes(const Condition& condition) {
  constexpr std::chrono::minutes patience{5};
  constexpr std::chrono::milliseconds between_looks{20};
  const auto begun = std::chrono::steady_clock::now();
  while (!condition()) {
    if (std::chrono::steady_clock::now() - begun > patience) return false;
    std::this_thread::sleep_for(between_looks);
  }
  return true;
}

}  // namespace loadpath::test
