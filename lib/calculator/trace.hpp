// A formula is written once: STEP computes it and hands its text to the tracer. With NoTrace every step vanishes; with
// Trace the report prints the same line symbolically, with numbers, with its value and its reason.
#pragma once

#include "lib/quantity/whole.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath {

/// Declares `symbol` as the value of `formula` and passes it to the tracer. The text of `formula` must be in the
/// language of lib/formula, which reads an input as `in.d`, a result as `r.F_c`, and prints d and F_c; `why` is a
/// clause of a standard, a book with its equation, or the physical reason.
#define STEP(symbol, formula, why)      \
  const auto symbol = reduced(formula); \
  trace.step(#symbol, #formula, why, symbol)

/// A STEP whose value is the result of that name.
#define STEP_TO(result, symbol, formula, why) \
  STEP(symbol, formula, why);                 \
  (result).symbol = symbol

/// The value of `formula`, traced under a symbol that is not a local variable: the return value of a function, or a
/// symbol that only the caller of a shared formula knows.
#define NAMED_STEP(symbol, formula, why) trace.named(symbol, #formula, why, reduced(formula))

/// For sweeps and searches.
struct NoTrace {
  struct Scope {};
  static constexpr bool traces = false;
  template <class... Arguments>
  void step(const Arguments&...) {}
  template <class Quantity>
  [[nodiscard]] Quantity named(const char*, const char*, const char*, const Quantity& q) {
    return q;
  }
  template <class Quantity>
  Quantity value(const char*, const Quantity& q, const char*) {
    return q;
  }
  double angle(const char*, double radians, const char*) { return radians; }
  AngularSpeed speed(const char*, AngularSpeed omega, const char*) { return omega; }
  template <class... Arguments>
  [[nodiscard]] Scope scope(const Arguments&...) {
    return {};
  }
};

/// One line of a calculation.
struct Line {
  std::string scope;  // "segments[2]"; empty at the top
  const char* symbol = "";
  const char* formula = "";  // empty: found by a helper (a sum, a root), not by a formula
  const char* why = "";
  double si = 0.0;
  Dimension dimension;
};

class Trace {
 public:
  static constexpr bool traces = true;

  class [[nodiscard]] Scope {
   public:
    Scope(Trace& trace, const char* list, std::size_t i);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Trace& trace_;
    std::string outer_;
  };

  template <class Quantity>
  void step(const char* symbol, const char* formula, const char* why, const Quantity& q) {
    add(symbol, formula, why, in_si(q), dimension_of<Quantity>);
  }
  template <class Quantity>
  [[nodiscard]] Quantity named(const char* symbol, const char* formula, const char* why, const Quantity& q) {
    step(symbol, formula, why, q);
    return q;
  }
  /// A value from a helper that later steps use, traced and returned.
  template <class Quantity>
  Quantity value(const char* symbol, const Quantity& q, const char* why) {
    step(symbol, "", why, q);
    return q;
  }
  /// The same of an angle, which in C++ is a plain number of radians.
  double angle(const char* symbol, double radians, const char* why) {
    add(symbol, "", why, radians, Dimension::of(0, 0, 0, 0, 1));
    return radians;
  }
  /// The same of an angular velocity, which in C++ has the dimension of a frequency.
  AngularSpeed speed(const char* symbol, AngularSpeed omega, const char* why) {
    add(symbol, "", why, in_si(omega), Dimension::of(0, 0, -1, 0, 1));
    return omega;
  }
  /// Lines until the end of the scope belong to element i of a list of the result.
  Scope scope(const char* list, std::size_t i) { return {*this, list, i}; }

  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

 private:
  void add(const char* symbol, const char* formula, const char* why, double si, Dimension dimension);

  std::string scope_;
  std::vector<Line> lines_;
};

}  // namespace loadpath
