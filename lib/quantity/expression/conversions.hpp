// Conversions that a product makes twice, or not at all: 2*pi times an angular velocity, a diameter for a radius.
#pragma once

#include "lib/quantity/expression/tree.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace loadpath::expression::conversions {

using KindOf = std::function<Meant(const std::string& path)>;

inline constexpr Dimension length = Dimension::of(1, 0, 0), per_time = Dimension::of(0, 0, -1),
                           speed = Dimension::of(1, 0, -1);
inline constexpr Dimension of_power = Dimension::of(2, 1, -3), work = Dimension::of(2, 1, -2);
inline constexpr Dimension force = Dimension::of(1, 1, -2), stress = Dimension::of(-1, 1, -2);

/// "d", "D", "shaft.d_1", "segments[2].d".
inline bool names_diameter(const std::string& path) {
  const std::string name = path.substr(path.rfind('.') + 1);
  return (name[0] == 'd' || name[0] == 'D') && (name.size() == 1 || name[1] == '_');
}

/// The factors of a product, each to its power.
struct Factors {
  double number = 1.0;                    // literals but pi
  int pi = 0, speeds = 0, diameters = 0;  // powers
  int velocities = 0;                     // linear speeds
  int moments = 0;                        // torques, bending moments
  int quarters = 0, sixteenths = 0;       // written as "/4" or "0.25", as "/16"
  bool has_frequency = false;             // 2*pi may belong to it
};

class Product {
 public:
  Product(const Tree& tree, const KindOf& of, const Declared& declared) : tree_(tree), of_(of), declared_(declared) {}

  /// 16 T/(pi d^3): the shear stress of a solid shaft by a torque.
  [[nodiscard]] bool is_stress_of_torsion(const Node& node) const {
    Factors f;
    collect(node, 1, f);
    return std::abs(f.number) == 16.0 && f.pi == -1 && f.diameters == -3 && f.moments == 1;
  }

  Fault judge(const Node& node) const {
    switch (node.operation) {
      case Operation::negate:
        return judge(node.kids[0]);
      case Operation::add:
      case Operation::subtract: {
        Fault first = judge(node.kids[0]);
        return first.message.empty() ? judge(node.kids[1]) : first;
      }
      case Operation::multiply:
      case Operation::divide:
        return judge_product(node);
      default:
        return {};
    }
  }

 private:
  Fault judge_product(const Node& node) const {
    const auto signature = check(tree_, node, declared_);
    const Dimension dimension = signature ? signature->dimension.without_angle() : Dimension{};
    Factors f;
    collect(node, 1, f);
    const auto fault = [&](Message message, Message hint) {
      return Fault{node.at, node.length, std::move(message), std::move(hint)};
    };
    const bool is_two_pi = f.pi == f.speeds && f.diameters == 0 && std::abs(f.number) == std::pow(2.0, f.pi);
    const bool is_of_minutes = f.pi == 1 && f.diameters == 0 && std::abs(30.0 * std::abs(f.number) - 1.0) < 1e-12;
    if (f.has_frequency) return {};
    if (Fault found = judge_units(node, f, dimension); !found.message.empty()) return found;
    if ((f.speeds == 1 && (is_two_pi || is_of_minutes) && dimension == per_time) ||
        (std::abs(f.speeds) == 1 && is_two_pi && (dimension == speed || dimension == of_power || dimension == work)))
      return fault(say("2*pi converts revolutions, and an angular velocity is in radians per time already"),
                   say("leave out 2*pi"));
    if (f.speeds == 1 && f.pi > 0 && f.diameters == 1 && dimension == speed)
      return fault(say("pi*d*n takes revolutions per time, and an angular velocity is in radians per time"),
                   say("write d/2 in place of pi*d"));
    const bool is_bare = std::abs(f.number) == 1.0;
    if (f.speeds == 1 && f.pi == 0 && f.diameters == 1 && dimension == speed && is_bare)
      return fault(say("an angular velocity times a diameter is twice the circumferential speed"),
                   say("write d/2; if d is a distance, give it another name"));
    const bool is_of_circle = (f.pi == 1 && f.diameters == 2) || (f.pi == -1 && f.diameters == -2);
    if (is_of_circle && is_bare && (dimension == force || dimension == stress))
      return fault(say("pi*d^2 is four times the area of a circle"), say("write pi*d^2/4"));
    if (f.pi == 1 && f.diameters == 2 && f.sixteenths == 1 && std::abs(f.number) == 1.0 / 16.0 && dimension == force)
      return fault(say("pi*d^2/16 is a quarter of the area of a circle"),
                   say("write pi*d^2/4; a share of it is a value of its own"));
    return {};
  }

  /// Formulas of textbooks for numbers without units, and formulas of circles without pi or 2.
  [[nodiscard]] static Fault judge_units(const Node& node, const Factors& f, const Dimension& dimension) {
    const auto fault = [&](Message message, Message hint) {
      return Fault{node.at, node.length, std::move(message), std::move(hint)};
    };
    const double number = std::abs(f.number), factor = number < 1.0 ? 1.0 / number : number;
    const auto is_about = [&](double value) { return std::abs(factor - value) < 1e-3 * value; };
    if (f.pi == 0 && std::abs(f.speeds) == 1 && (dimension == of_power || dimension == work) &&
        (is_about(9550.0) || is_about(9.55)))
      return fault(say("{1} converts kW and rpm to N m, and these values have units", in_digits(factor)),
                   say("leave it out"));
    if (f.pi == 0 && f.speeds == 0 && f.velocities == 1 && f.diameters == -1 && number == 1.0 && dimension == per_time)
      return fault(say("a circumferential speed over a diameter is half the angular velocity"),
                   say("write 2*v/d; if d is a distance, give it another name"));
    if (f.pi == 0 && f.speeds == 0 && f.diameters == 1 && f.quarters == 1 && number == 0.25 && dimension == work)
      return fault(say("a force times a quarter of its diameter is half of the torque"),
                   say("write d/2; if d is a distance, give it another name"));
    const bool is_area = (f.diameters == 2 && number == 0.25 && dimension == force) ||
                         (f.diameters == -2 && number == 4.0 && dimension == stress);
    if (f.pi == 0 && is_area) return fault(say("d^2/4 is not the area of a circle"), say("write pi*d^2/4"));
    return {};
  }

  static std::string in_digits(double factor) { return factor > 1e3 ? "9550" : "9.55"; }

  void collect(const Node& node, int power, Factors& f) const {
    switch (node.operation) {
      case Operation::multiply:
      case Operation::divide:
        collect(node.kids[0], power, f);
        collect(node.kids[1], node.operation == Operation::multiply ? power : -power, f);
        return;
      case Operation::negate:
        collect(node.kids[0], power, f);  // no rule depends on a sign
        return;
      case Operation::power:
        if (is_constant(node.kids[1])) {
          const double exponent = constant(node.kids[1]);
          if (exponent == std::round(exponent) && std::abs(exponent) <= 8.0)
            collect(node.kids[0], power * static_cast<int>(exponent), f);
        }
        return;
      case Operation::literal:
        collect_literal(node, power, f);
        return;
      case Operation::reference:
        if (of_(node.path) == Meant::angular_speed) f.speeds += power;
        f.has_frequency = f.has_frequency || of_(node.path) == Meant::frequency;
        if (names_diameter(node.path) && has_dimension(node, length)) f.diameters += power;
        if (has_dimension(node, speed)) f.velocities += power;
        if (has_dimension(node, work)) f.moments += power;
        return;
      default:
        return;
    }
  }

  void collect_literal(const Node& node, int power, Factors& f) const {
    const bool is_in_radians = tree_.written(node).find("rad") != std::string::npos;  // "10*pi*1 rad/s"
    if (node.kind == Meant::angular_speed && !is_in_radians) f.speeds += power;
    f.has_frequency = f.has_frequency || node.kind == Meant::frequency;
    if (node.dimension == work) f.moments += power;
    if (!node.dimension.is_number()) return;
    f.quarters += (node.si == 4.0 && power == -1) || (node.si == 0.25 && power == 1) ? 1 : 0;
    f.sixteenths += node.si == 16.0 && power == -1 ? 1 : 0;
    if (node.si == std::numbers::pi)
      f.pi += power;
    else
      f.number *= std::pow(node.si, power);
  }

  [[nodiscard]] bool has_dimension(const Node& node, const Dimension& dimension) const {
    const auto signature = check(tree_, node, declared_);
    return signature && signature->dimension == dimension;
  }

  const Tree& tree_;
  const KindOf& of_;
  const Declared& declared_;
};

/// The first product of the tree with such a conversion; a Fault without a message if there is none. `of`: the kinds of
/// references. Only whole products are looked at, and the terms of sums: a part of one may go on to something else.
inline Fault wrong_conversion(const Tree& tree, const KindOf& of, const Declared& declared) {
  return Product(tree, of, declared).judge(tree.root);
}

}  // namespace loadpath::expression::conversions
