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
                                                {"a.i", {Dimension{}}},
                                                {"a.D", {Dimension::of(1, 0, 0)}},
                                                {"a.d_1", {Dimension::of(1, 0, 0)}},
                                                {"a.l_1", {Dimension::of(1, 0, 0)}},
                                                {"a.delta", {Dimension::of(1, 0, 0)}},
                                                {"a.d_i", {Dimension{}}},
                                                {"a.a", {Dimension::of(1, 0, -2)}},
                                                {"a.F", {Dimension::of(1, 1, -2)}},
                                                {"a.p", {stress}},
                                                {"a.J", {Dimension::of(2, 1, 0)}}};
  return all;
}

loadpath::Outcome<Meant> outcome_of(const std::string& text) {
  const auto parsed = loadpath::Expression::parse(text);
  REQUIRE_MESSAGE(parsed, text);
  const auto declared = [](const std::string& path) -> loadpath::Outcome<loadpath::Signature> {
    return loadpath::Signature{known().at(path).dimension, nullptr};
  };
  return parsed->kind([](const std::string& path) { return known().at(path).kind; }, declared);
}

/// "a frequency"; or "refused".
std::string kind_of(const std::string& text) {
  const auto kind = outcome_of(text);
  return kind ? std::string(loadpath::name_of(*kind)) : "refused";
}

void check(const std::string& kind, std::initializer_list<const char*> texts) {
  for (const char* const text : texts) {
    INFO(std::string(text));
    CHECK(kind_of(text) == kind);
  }
}

/// The message, or the remedy, of expressions that are refused; empty if one is not.
void check_refused(const std::string& message, std::initializer_list<const char*> texts) {
  for (const char* const text : texts) {
    INFO(std::string(text));
    const auto kind = outcome_of(text);
    CHECK((kind ? "" : kind.fault().message.text()) == message);
  }
}
void check_remedy(const std::string& hint, std::initializer_list<const char*> texts) {
  for (const char* const text : texts) {
    INFO(std::string(text));
    const auto kind = outcome_of(text);
    CHECK((kind ? "" : kind.fault().hint.text()) == hint);
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
    check("a frequency", {"a.n/(2*pi)", "a.r/(2*pi)", "a.n*(30/pi)", "a.n*(-(30/pi))"});
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

  TEST_CASE("the remedy of a sum of two kinds") {
    check_remedy("write mises(sigma, tau)", {"a.sigma + a.tau", "a.tau + a.sigma", "a.eq - a.tau"});
    check_remedy("divide the energy by the angle, as in E/(2*pi rad)", {"a.W + a.T", "a.T + a.W"});
    check_remedy("write rev*f for a frequency of turns", {"a.f + a.n", "a.n + a.f", "a.r + a.f"});
  }

  TEST_CASE("16 T/(pi d^3) is the shear stress of a shaft") {
    check("a shear stress", {"16*a.T/(pi*a.d^3)", "-16*a.T/(pi*a.d^3)", "a.T*16/pi/a.d/a.d/a.d",
                             "16*(20 N*m)/(pi*a.d_1^3)", "(16/(pi*a.D^3))*a.T"});
    check("a quantity",
          {"32*a.T/(pi*a.d^3)", "16*a.T/(pi*a.d^2*a.l)", "16*a.T*pi/a.d^3", "16*a.F*a.l/(pi*a.d^3)", "16*a.T/a.d^3",
           "a.T/a.l^3", "16*a.p", "a.T/(pi*a.d^3)", "16*a.F/(pi*a.d*a.l)", "16*a.T/(pi*a.d^3)*a.l"});
  }
}

// What a formula of a circle has in place of a radius, and of a speed in radians per time: each message with
// expressions that differ in one factor from those which it refuses.
TEST_SUITE("quantity conversions") {
  TEST_CASE("2 pi converts a frequency, not an angular velocity") {
    check_refused("2*pi converts revolutions, and an angular velocity is in radians per time already",
                  {"2*pi*a.n", "a.n*pi*2", "-2*pi*a.n", "pi*a.n/30", "2*pi*a.n*a.l", "2*pi*a.n*a.T", "a.P/(2*pi*a.n)",
                   "a.a/(2*pi*a.n)", "2*pi*(10 rpm)", "a.l*2*pi*a.n + a.v", "a.v - 2*pi*a.n*a.l"});
    check_refused("", {"2*a.n", "pi*a.n", "4*pi*a.n", "a.n/(2*pi)", "2*pi*a.f", "2*pi*a.n*a.J", "4*pi^2*a.n^2*a.s",
                       "2*pi*a.n*a.n*a.s", "2*pi*(10 rad/s)", "2*pi*a.f*a.n*a.s", "2*pi*a.n*a.s*a.f", "2*pi*a.f*a.l",
                       "2*pi*(3 Hz)*a.n*a.s", "2*pi*a.n*a.s*(3 Hz)", "max(2*pi*a.n, a.n)", "(2*pi*a.n)^2", "2*pi*a.r",
                       "a.P/(2*pi*a.r)", "pi*a.n/60"});
  }

  TEST_CASE("pi d n takes revolutions per time") {
    check_refused("pi*d*n takes revolutions per time, and an angular velocity is in radians per time",
                  {"pi*a.d*a.n", "a.n*a.D*pi/60", "2*pi*a.n*a.d_1", "pi^2*a.d*a.n"});
    check_refused("", {"pi*a.l*a.n", "a.d*a.n/pi", "pi*a.d*a.n*a.F", "pi*a.d*a.f", "pi*a.d^2*a.n/a.l", "pi*a.d*a.v/a.l",
                       "pi*a.d*a.n^2*a.s"});
  }

  TEST_CASE("an angular velocity has a radius, not a diameter") {
    check_refused("an angular velocity times a diameter is twice the circumferential speed",
                  {"a.n*a.d", "-a.n*a.d", "a.d_1*a.n", "a.n*a.D", "a.n*a.d + a.v", "a.v + a.n*a.d", "a.v - a.n*a.d",
                   "a.n*a.d*2^8/256", "(2 mm)*a.n*a.d/a.l"});
    check_refused("", {"a.n*a.d/2", "a.n*a.l", "a.n*a.l_1", "a.n*a.delta", "a.n*a.l*a.d_i", "a.n*a.d*a.F",
                       "a.n*a.d^2/a.l", "a.n^2*a.d*a.s", "a.n*a.l^0.5*a.d^1.5/a.l", "a.n*a.d*2^9/512", "a.f*a.d",
                       "max(a.n*a.d, a.v)", "2*a.n*a.d", "a.d*a.n*a.m", "a.v*a.d/a.l"});
  }

  TEST_CASE("the area of a circle is pi d^2/4") {
    check_refused("pi*d^2 is four times the area of a circle",
                  {"pi*a.d^2*a.p", "a.F/(pi*a.d^2)", "a.d*a.D*pi*a.p", "-pi*a.d^2*a.p"});
    check_refused("", {"pi*a.d^2/4*a.p", "a.p*pi*a.d*a.l", "a.p*a.d^2/pi", "pi*a.d^2*a.v", "a.F*pi/a.d^2",
                       "a.F*a.l/(pi*a.d^3)", "pi^2*a.d^2*a.p", "pi*a.l^2*a.p", "a.F/(pi*a.l^2)", "pi*a.p*a.d^3/a.l"});
    check_refused("pi*d^2/16 is a quarter of the area of a circle", {"pi*a.d^2/16*a.p", "a.p*a.d^2*pi/16"});
    check_refused("", {"pi*a.d^2*a.p*0.0625", "pi*a.d^3/16*a.p", "pi*a.d*a.l/16*a.p", "pi*a.d^2*a.p/16/2",
                       "a.d^2/16*a.p", "pi*a.d^2/16", "pi*a.d^2*a.p/4/4", "pi*a.d^2*a.p*0.5/8", "pi^2*a.d^2/16*a.p"});
    check_refused("d^2/4 is not the area of a circle",
                  {"a.d^2/4*a.p", "4*a.F/a.d^2", "a.F/(a.d^2/4)", "a.d^2*0.25*a.p", "a.F/a.D^2*4"});
    check_refused(
        "", {"a.d^2*a.p", "a.d^2/4", "a.d*a.l/4*a.p", "a.F/a.d^2", "a.d^2/2*a.p", "4*a.F/(a.d*a.l)", "4*a.F/a.d^2*a.v",
             "a.F*4*a.l/a.d^3", "a.F/4/a.d^2", "4*a.d^2*a.p", "4*a.F/(pi*a.d^2)", "a.p/4*a.l^2", "4*a.F/a.l^2"});
  }

  TEST_CASE("quantities have units: no 9550") {
    check_refused("9550 converts kW and rpm to N m, and these values have units",
                  {"9550*a.P/a.n", "a.T*a.n/9550", "a.P*9549/a.n"});
    check_refused("9.55 converts kW and rpm to N m, and these values have units",
                  {"9.55*a.P/a.n", "a.T*a.n/9.549", "-9.55*a.P/a.n"});
    check_refused("", {"9000*a.P/a.n", "9.6*a.P/a.n", "9550*a.P/a.r", "9550*a.n", "9550*pi*a.P/a.n",
                       "9550*a.n^2*a.T*a.s", "a.P/a.n", "a.T*a.n", "9550*a.n*a.l", "9550*a.T", "9500*a.P/a.n"});
  }

  TEST_CASE("a circumferential speed and a force act at the radius") {
    check_refused("a circumferential speed over a diameter is half the angular velocity",
                  {"a.v/a.d", "-a.v/a.d", "(3 kN)*a.v/a.d/a.F"});
    check_refused("", {"2*a.v/a.d", "a.v/a.l", "a.v/(pi*a.d)", "a.v*a.l/a.d^2", "a.v/a.d*a.F", "a.v/a.d*(a.n*a.s)",
                       "a.v*a.v/a.d/(a.a*a.s)", "a.v*a.d/a.l^2", "a.a*a.s/a.d"});
    check_refused("a force times a quarter of its diameter is half of the torque",
                  {"a.F*a.d/4", "0.25*a.F*a.d", "a.d_1*a.F*0.25", "a.F*a.d/(1/0.25)"});
    check_refused(
        "", {"a.F*a.d/2", "a.F*a.l/4", "a.F*a.d/2/2", "0.5*a.F*a.d*0.5", "a.F*a.d/4*2", "pi*a.F*a.d/4", "a.F*a.d*a.n/4",
             "a.F*a.d^2/4/a.l", "a.F*a.d*a.n*a.s/4", "a.F*a.d/4/4*4", "0.5*a.F*a.d/2", "a.d/4", "a.F*a.d/0.25/16"});
  }

  TEST_CASE("only whole products and the terms of sums have a conversion") {
    check_refused("", {"a.F*(a.l + a.v)", "a.l + a.v", "a.n*(a.d + a.l)", "a.n*(-a.d + a.l)"});
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
