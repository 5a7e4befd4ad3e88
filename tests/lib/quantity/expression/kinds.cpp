// The kinds of expressions, as a table: a row for each condition of lib/quantity/expression/kinds.cpp.
#include "lib/quantity/kinds.hpp"

#include "lib/quantity/expression/expression.hpp"

#include <doctest/doctest.h>

#include <array>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>

using loadpath::Dimension;
using loadpath::Meant;

namespace {

struct Known {
  Dimension dimension;
  Meant kind = Meant::nothing;
};

const std::map<std::string, Known>& known() {
  constexpr Dimension stress = Dimension::of(-1, 1, -2), work = Dimension::of(2, 1, -2),
                      heat = Dimension::of(0, 0, 0, 1);
  constexpr Dimension frequency = Dimension::of(0, 0, -1), turning = Dimension::of(0, 0, -1, 0, 1);
  static const std::map<std::string, Known> all{{"a.sigma", {stress, Meant::normal_stress}},
                                                {"a.tau", {stress, Meant::shear_stress}},
                                                {"a.eq", {stress, Meant::equivalent_stress}},
                                                {"a.uni", {stress, Meant::uniaxial_stress}},
                                                {"a.f", {frequency, Meant::frequency}},
                                                {"a.n", {turning, Meant::angular_speed}},
                                                {"a.r", {frequency, Meant::rate}},
                                                {"a.W", {work, Meant::work}},
                                                {"a.T", {work, Meant::torque}},
                                                {"a.t", {heat, Meant::temperature}},
                                                {"a.dt", {heat, Meant::difference}},
                                                {"a.v", {Dimension::of(1, 0, -1)}},
                                                {"a.d", {Dimension::of(1, 0, 0)}},
                                                {"a.l", {Dimension::of(1, 0, 0)}},
                                                {"a.P", {Dimension::of(2, 1, -3)}},
                                                {"a.k", {Dimension::of(0, 1, -2)}},
                                                {"a.m", {Dimension::of(0, 1, 0)}},
                                                {"a.s", {Dimension::of(0, 0, 1)}},
                                                {"a.i", {Dimension{}}}};
  return all;
}

/// "a frequency"; or "refused".
std::string kind_of(const std::string& text) {
  const auto parsed = loadpath::Expression::parse(text);
  REQUIRE_MESSAGE(parsed, text);
  const auto declared = [](const std::string& path) -> loadpath::Outcome<loadpath::Signature> {
    return loadpath::Signature{known().at(path).dimension, nullptr};
  };
  const auto kind = parsed->kind([](const std::string& path) { return known().at(path).kind; }, declared);
  return kind ? std::string(loadpath::name_of(*kind)) : "refused";
}

void check(const std::string& kind, std::initializer_list<const char*> texts) {
  for (const char* const text : texts) {
    INFO(std::string(text));
    CHECK(kind_of(text) == kind);
  }
}

constexpr std::array all_kinds{Meant::nothing,
                               Meant::normal_stress,
                               Meant::shear_stress,
                               Meant::equivalent_stress,
                               Meant::uniaxial_stress,
                               Meant::strength,
                               Meant::frequency,
                               Meant::angular_speed,
                               Meant::rate,
                               Meant::work,
                               Meant::torque,
                               Meant::temperature,
                               Meant::difference};

}  // namespace

TEST_SUITE("quantity kinds of expressions") {
  TEST_CASE("sums and choices keep the kind of their operands") {
    check("a normal stress", {"a.sigma + a.sigma", "-a.sigma", "max(a.sigma, a.sigma)", "abs(a.sigma)", "2*a.sigma"});
    check("a quantity", {"a.sigma + a.eq", "a.eq + a.uni", "a.n + a.r"});
    check("a frequency", {"a.f + 3 1/s", "3 1/s + a.f", "a.f - a.f", "a.f/3", "a.f*a.i", "a.i*a.f"});
    check("refused",
          {"a.sigma + a.tau", "a.tau + a.sigma", "a.tau + a.eq", "a.eq + a.tau", "a.uni + a.tau", "a.tau - a.uni",
           "a.f + a.n", "a.n + a.f", "a.f + a.r", "a.r - a.f", "a.W + a.T", "a.T + a.W", "max(a.sigma, a.tau)"});
  }

  TEST_CASE("of two temperatures the difference") {
    check("a temperature difference", {"a.t - a.t", "a.t - 293.15 K", "a.t - 200 K", "a.dt - a.dt", "a.dt + a.dt"});
    check("a temperature", {"a.t - a.dt", "a.t - 60 K", "a.t + a.dt", "a.dt + a.t", "a.t + 300 K"});
  }

  TEST_CASE("pi converts turns and radians") {
    check("radians per time", {"2*pi*a.f", "a.f*2*pi", "a.f*(2*pi)"});
    check("a frequency", {"a.n/(2*pi)", "a.r/(2*pi)", "a.n*(30/pi)"});
    check("an angular velocity", {"a.n*pi", "3*a.n"});
    check("a quantity", {"a.W/(2*pi)", "a.T*2*pi"});
    check("refused", {"a.n*(pi/30)", "a.v/a.d"});  // a conversion that is applied twice, a diameter for a radius
    check("a shear stress", {"a.tau*pi", "a.tau/pi"});
  }

  TEST_CASE("quotients that are radians per time, turns or work") {
    check("radians per time", {"a.v/a.l", "a.P/a.T", "sqrt(a.k/a.m)", "(a.k/a.m)^(1/2)"});
    check("a frequency", {"a.v/(pi*a.d)", "a.P/a.W"});
    check("an energy", {"a.P/a.f", "a.P/(2 Hz)"});
    check("a quantity", {"a.P/a.r", "a.P/(2*pi*a.f)", "(a.P/pi)/a.f", "a.d/a.v", "a.P/a.d", "a.v/a.s", "a.f*a.f",
                         "a.f^2", "1/a.s", "a.s^-1", "a.f^1", "a.f/a.f", "a.T*a.n", "sqrt(a.d)"});
  }

  TEST_CASE("a torque times a frequency, stresses of mises") {
    check("refused", {"a.T*a.f", "a.f*a.T", "mises(a.tau, a.sigma)", "mises(a.sigma, a.sigma)", "mises(a.tau, a.tau)",
                      "mises(a.sigma, a.eq)", "mises(a.sigma, a.uni)"});
    check("an equivalent stress", {"mises(a.sigma, a.tau)", "mises(100 MPa, 20 MPa)"});
  }
}

TEST_SUITE("quantity kinds of fields") {
  TEST_CASE("a field takes its own kind, what is not known, and what includes it") {
    for (const Meant field : all_kinds) {
      for (const Meant given : all_kinds) {
        const bool is_normal = field == Meant::normal_stress, is_equivalent = field == Meant::equivalent_stress;
        bool is_taken = field == given || field == Meant::nothing || given == Meant::nothing || given == Meant::rate;
        if (given == Meant::strength) is_taken = is_taken || is_normal || is_equivalent || field == Meant::shear_stress;
        if (given == Meant::uniaxial_stress) is_taken = is_taken || is_normal || is_equivalent;
        INFO(loadpath::name_of(field), " takes ", loadpath::name_of(given));
        CHECK(loadpath::takes_kind(field, given) == is_taken);
      }
    }
  }

  TEST_CASE("each kind has its name") {
    const std::array names{
        "a quantity", "a normal stress", "a shear stress",          "an equivalent stress", "an equivalent stress",
        "a strength", "a frequency",     "an angular velocity",     "radians per time",     "an energy",
        "a moment",   "a temperature",   "a temperature difference"};
    for (std::size_t i = 0; i < all_kinds.size(); ++i) CHECK(loadpath::name_of(all_kinds[i]) == std::string(names[i]));
  }

  TEST_CASE("a unit means a kind only together with its dimension") {
    const Dimension heat = Dimension::of(0, 0, 0, 1), work = Dimension::of(2, 1, -2), number{};
    const Dimension frequency = Dimension::of(0, 0, -1), turning = Dimension::of(0, 0, -1, 0, 1);
    for (const bool is_marked : {true, false}) {
      const auto kind = [&](const Dimension& dimension) {
        return loadpath::kind_of_unit(dimension, is_marked, is_marked, is_marked);
      };
      CHECK(kind(heat) == (is_marked ? Meant::temperature : Meant::nothing));
      CHECK(kind(work) == (is_marked ? Meant::work : Meant::nothing));
      CHECK(kind(frequency) == (is_marked ? Meant::frequency : Meant::nothing));
      CHECK(kind(turning) == Meant::angular_speed);
      CHECK(kind(number) == Meant::nothing);
    }
  }

  TEST_CASE("a field has a kind only together with its dimension") {
    using loadpath::Kind;
    const Dimension heat = Dimension::of(0, 0, 0, 1), work = Dimension::of(2, 1, -2), number{};
    const auto kind = [](const Dimension& dimension, Kind of, const char* unit) {
      return loadpath::kind_of_field({"x", "of the part", unit, dimension, of});
    };
    for (const Kind of : {Kind::plain, Kind::moment, Kind::energy, Kind::temperature, Kind::difference}) {
      CHECK(kind(number, of, "Hz") == Meant::nothing);
      CHECK(kind(work, of, "Hz") == (of == Kind::moment   ? Meant::torque
                                     : of == Kind::energy ? Meant::work
                                                          : Meant::nothing));
      CHECK(kind(heat, of, "K") == (of == Kind::temperature  ? Meant::temperature
                                    : of == Kind::difference ? Meant::difference
                                                             : Meant::nothing));
      CHECK(kind(Dimension::of(0, 0, -1), of, "kHz") == Meant::frequency);
      CHECK(kind(Dimension::of(0, 0, -1), of, "1/s") == Meant::nothing);
    }
  }
}
