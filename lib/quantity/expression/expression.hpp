// The expression language of project files: "=1.4 * peak(lever.drive.M) / (30 MPa)", dimensions checked when read.
//
//   sum     + - * / ^ and parentheses, unary minus; ^ binds tightest and its exponent is a constant number
//   number  decimal point only (a comma separates arguments), directly followed by a unit: 30 MPa, 2 N*m, 60 deg
//           (a unit's own * / ^ bind only inside the unit text, which ends before a reference, a call, a number and pi:
//           `2 N*m*lever.drive.phi`, `40 mm*cos(20 deg)`, `2 m*pi`); `1/min` and `W/(m*K)` are units
//   name    always with a dot: lever.drive.M, shaft.segments[2].tau, shaft.segments.journal.tau; a part that is not a
//           name in quotes: tables.sections."IPE 330".I_y
//   const   pi, rev (one turn: rev*f: angular velocity of f turns per time), g (9.80665 m/s^2; inside the unit of a
//           number g is the gram: `5 g`, `2 kN/g`, but `80 kg * (g)`)
//   calls   peak min max mean rms amplitude range at(series, place) abs sqrt cbrt exp ln sin cos tan asin acos
//           atan atan2 hypot(x, y) mises(sigma, tau)
//           max(a, b) and min(a, b) are element-wise, max(series) and min(series) reduce; at takes a place in the axis'
//           unit
#pragma once

#include "lib/quantity/expression/references.hpp"
#include "lib/quantity/kinds.hpp"
#include "lib/quantity/series.hpp"
#include "lib/text/issue.hpp"

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath {

namespace expression {
struct Tree;
/// The names of all functions, "peak", "hypot".
std::vector<std::string> function_names();
}  // namespace expression

/// Factors that a value contains, by the inputs that they are, with their values: "chain.K_A", 1.4. Two are of one kind
/// where their last names are the same, and those of one kind are equal where their values are.
using Factors = std::map<std::string, double>;
using FactorsOf = std::function<Factors(const std::string& path)>;
/// "chain.K_A": "K_A".
std::string kind_of(const std::string& factor);
/// The factor of this kind; empty if there is none.
std::string of_kind(const Factors& factors, const std::string& kind);
/// One of these that has no equal among the others; empty if every one has.
std::string without_equal(const Factors& factors, const Factors& others);

/// The reduction of the series that a value depends on.
struct Reduced {
  enum class Left {
    no_series,  // it comes from none
    whole,      // every position: the series itself, times a constant, a sum or a resultant of such
    square,     // the same, squared
    peak,       // the largest magnitude
    once,       // one reduction of an entire series, times a constant
    less        // anything else
  };
  Left left = Left::no_series;
  bool is_signed = false;     // it, or the series, is negative somewhere
  bool of_load = false;       // the series is of a force, a moment, a stress, a power
  std::string function = {};  // function that reduced it: "mean"
  std::string argument = {};  // argument of that function, as written: "press.joints.B.F"
  std::string text = {};      // the part that lost the rest: "mean(press.joints.B.F)"
  std::string factor = {};    // constant factor of an entire series, as written: "0.5"
};
using ReducedOf = std::function<Reduced(const std::string& path)>;

class Expression {
 public:
  using Reference = expression::Reference;
  using Declared = expression::Declared;
  using Known = expression::Known;
  using Column = expression::Column;

  Expression();
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  /// Parses `text` (without the leading '=').
  static Outcome<Expression> parse(std::string_view text);

  [[nodiscard]] const std::vector<Reference>& references() const;
  /// Whether it consists of one reference, which may also refer to non-numbers.
  [[nodiscard]] bool is_reference() const;
  /// Replaces references by other expressions: `by` gives the one for a path, null to keep the path. Messages about
  /// them point to the reference. Returns false, with nothing changed, if the result would exceed the size limit.
  using Written = std::function<const Expression*(const std::string& path)>;
  bool write_out(const Written& by);
  /// The references whose value it passes on unchanged, or as one of several: by itself, in "peak(limit.sigma_D)", in
  /// a sum, times a number. Their origin is that of the result; any other product has its own.
  [[nodiscard]] std::vector<Reference> handed_on() const;
  /// Dimension and axis of the result, or the first fault: unknown names, unlike dimensions or axes, °C, wrong
  /// arguments.
  [[nodiscard]] Outcome<Signature> check(const Declared& declared) const;
  /// The part that changes the sign convention of tension and compression: a function, "peak", or a path,
  /// "press.joints.A.F"; empty if there is none. An explicit sign in front of it counts as intended.
  [[nodiscard]] std::string_view unsigned_part(const Declared& declared) const;
  /// The meaning of the value beyond its dimension (lib/quantity/kinds.hpp). A sum of unlike kinds is a fault.
  using KindOf = std::function<Meant(const std::string& path)>;
  [[nodiscard]] Outcome<Meant> kind(const KindOf& of, const Declared& declared) const;
  /// Whether it contains pi: 2*pi*f converts revolutions to radians.
  [[nodiscard]] bool holds_pi() const;
  /// The plain number that a product of references is multiplied with: 0.5 of "values.P/values.n/2". NaN of anything
  /// else: a sum, a power, a call, a number with a unit, pi.
  [[nodiscard]] double plain_number() const;
  /// The factors of its references: of a product all, of a quotient without those of the divisor, of a root of a
  /// square once. A factor that would count twice, and a sum in which only some operands include one, are faults.
  [[nodiscard]] Outcome<Factors> factors(const FactorsOf& of) const;
  /// The remaining dependence on series, given that of its references.
  [[nodiscard]] Reduced reduced(const ReducedOf& of) const;
  /// The value. A result that is not finite is NaN (never an infinity).
  [[nodiscard]] Value evaluate(const Known& known) const;
  /// The same, to the bit, where every reference is one value, for many points at once: `column` gives the n values of
  /// a path. False if it takes a place of a series.
  bool evaluate(const Column& column, std::span<double> out) const;

 private:
  std::unique_ptr<const expression::Tree> tree_;
  std::vector<Reference> references_;
};

}  // namespace loadpath
