#include "lib/project/references/machine/seats.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace loadpath::project {

namespace {

constexpr double rounded = 1e-3;        // of a value: sizes typed with few digits
constexpr double in_few_digits = 0.05;  // of a moment of inertia that is computed elsewhere

class SeatCheck {
 public:
  SeatCheck(const Step& shaft, const Project& project) : shaft_(shaft), project_(project) {}

  std::vector<ReducedLoad> run() {
    for (const Taken& record : shaft_.input().reading.records) {
      if (record.path.ends_with(".load")) compare_width(record), compare_wheel(record);
      if (record.path.ends_with(".connection")) compare_factor(record), compare_hub(record), compare_strength(record);
      compare_start(record);
    }
    const Record& record = shaft_.input().reading.record;
    const FieldInfo* const seats = find_field(record.type->fields, "seats");
    for (std::size_t i = 0; seats != nullptr && i < seats->size(record.data.get()); ++i) {
      const std::string seat = "seats" + element_path(*seats, record.data.get(), i) + ".";
      compare_gyration(seat), compare_least_gyration(seat);
    }
    for (const Operand& operand : shaft_.input().reading.operands) compare_component(operand), compare_inertia(operand);
    return std::move(found_);
  }

 private:
  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  /// Whether it takes loads that may include an application factor: those of a drive, not those of a mechanism.
  [[nodiscard]] bool takes_loads() const {
    const auto& records = shaft_.input().reading.records;
    return std::any_of(records.begin(), records.end(), [&](const Taken& r) {
      if (!r.path.ends_with(".load")) return false;
      const Step* const source = project_.find(split_step(r.source).first);
      return source == nullptr || find_field(source->input().calculator->input->fields, "K_A") != nullptr;
    });
  }

  /// The rim of a gear may reach over its hub a little; that of a pulley often does.
  void compare_width(const Taken& record) {
    constexpr double least = 0.8;
    const std::string path = prefix_of(record.path) + "b";
    const double rim = magnitude_at(project_, record.source + ".b_r"), b = own_value(shaft_, project_, path);
    if (std::isnan(magnitude_at(project_, record.source + ".h_t")) || !(b < least * rim)) return;
    add(path, say("{1} = {2}, and the rim of '{3}' is {4} wide; justify it: {5} = \"...\"", path,
                  format_quantity(b, "mm", 4), record.source, format_quantity(rim, "mm", 4), because_key(path)));
  }

  /// A gear that its load comes from has a size: its mass, and the moment of inertia that belongs to it.
  void compare_wheel(const Taken& record) {
    constexpr double steel = 7850.0, most = 5.0;  // times a solid disc: with a long hub, or a part next to it
    constexpr double least = 0.25;  // of a solid disc, with half of its diameter: most of the mass is in the hub
    const std::string seat = prefix_of(record.path);
    if (std::isnan(magnitude_at(project_, record.source + ".h_t"))) return;
    const double d = magnitude_at(project_, record.source + ".d_w"), b = magnitude_at(project_, record.source + ".b_r");
    const double mass = own_value(shaft_, project_, seat + "mass"), I_p = own_value(shaft_, project_, seat + "I_p");
    const double disc = steel * std::numbers::pi / 4.0 * d * d * b, I_disc = mass * d * d / 8.0;
    if (mass > most * disc)
      add(seat + "mass", say("{1} = {2}, and a solid disc with the sizes of '{3}' has {4}; justify it: {5} = \"...\"",
                             seat + "mass", format_quantity(mass, "kg", 3), record.source,
                             format_quantity(disc, "kg", 3), because_key(seat + "mass")));
    if (I_p < least * I_disc)
      add(seat + "I_p",
          say("{1} = {2} is too low for a mass of {3} with the diameter of '{4}', {5}: a disc has {6}; "
              "justify it: {7} = \"...\"",
              seat + "I_p", format_quantity(I_p, "kg*m^2", 3), format_quantity(mass, "kg", 3), record.source,
              format_quantity(d, "mm", 4), format_quantity(I_disc, "kg*m^2", 3), because_key(seat + "I_p")));
  }

  /// The components of a tooth force belong together: their senses are those of the record.
  void compare_component(const Operand& operand) {
    const auto& references = operand.expression.references();
    const std::size_t dot = operand.path.rfind('.');
    if (!operand.path.starts_with("seats") || operand.expression.is_reference() || references.size() != 1) return;
    const std::string key = operand.path.substr(dot + 1), source = references.front().path;
    const std::string gear = source.substr(0, source.rfind('.'));
    if (!key.starts_with("F_") || !source.ends_with("." + key)) return;
    if (std::isnan(magnitude_at(project_, gear + ".h_t"))) return;
    add(operand.path, say("{1} is not the component of '{2}' as it is: take all with load = \"={2}\", or "
                          "{3} = \"...\"",
                          operand.path, gear, because_key(operand.path)));
  }

  /// A connection whose torque is typed has the application factor of its shaft, unless the loads of the shaft
  /// include it.
  void compare_factor(const Taken& record) {
    const Step* const connection = project_.find(split_step(record.source).first);
    if (connection == nullptr || takes_loads() || steps_loading(connection->input().reading).contains(shaft_.name()))
      return;
    const double own = own_value(shaft_, project_, "K_A"), of_connection = own_value(*connection, project_, "K_A");
    if (!(of_connection > (1.0 + rounded) * own)) return;
    add("K_A", say("K_A = {1}, and its connection '{2}' has {3}; justify it: because.K_A = \"...\"",
                   format_number(own, 4), connection->name(), format_number(of_connection, 4)));
  }

  /// The hub that a key, spline or fit is calculated with is the one on the shaft.
  void compare_hub(const Taken& record) {
    const Step* const connection = project_.find(split_step(record.source).first);
    if (connection == nullptr) return;
    const std::string path = prefix_of(record.path) + "b";
    const double b = own_value(shaft_, project_, path), l_n = own_value(*connection, project_, "l_n");
    if (!(b < (1.0 - rounded) * l_n)) return;
    add(path, say("{1} = {2}, and the hub of '{3}' is {4} long; justify it: {5} = \"...\"", path,
                  format_quantity(b, "mm", 4), connection->name(), format_quantity(l_n, "mm", 4), because_key(path)));
  }

  /// The yield strength of the shaft in its connection. A thinner seat of a table's steel has up to a quarter more.
  void compare_strength(const Taken& record) {
    constexpr double most = 1.25;
    const Step* const connection = project_.find(split_step(record.source).first);
    if (connection == nullptr) return;
    const double there = own_value(*connection, project_, "R_e_1");
    const double R_e = magnitude_at(project_, shaft_.name() + ".R_e");
    if (!(there > most * R_e)) return;
    add(record.path, say("'{1}' is calculated with a shaft of R_e = {2}, and this shaft has {3}; justify it: {4} = "
                         "\"...\"",
                         connection->name(), format_quantity(there, "MPa", 4), format_quantity(R_e, "MPa", 4),
                         because_key(record.path)));
  }

  /// The start that a key or spline is calculated for goes through the shaft, too.
  void compare_start(const Taken& record) {
    const Step* const connection = project_.find(split_step(record.source).first);
    if (connection == nullptr || !connects(*connection) || !has_peak_factor()) return;
    const double T_max = std::abs(own_value(*connection, project_, "T_max"));
    const double T = std::abs(own_value(*connection, project_, "T")), K_A = own_value(*connection, project_, "K_A");
    const double k_max = own_value(shaft_, project_, "k_max"), peak = T_max / T / std::fmax(1.0, K_A);
    if (!(peak > (1.0 + rounded) * std::fmax(1.0, k_max))) return;
    add("k_max", say("k_max = {1}, and '{2}' carries T_max = {3} K_A T: give k_max, or because.k_max = \"...\"",
                     format_number(std::fmax(1.0, k_max), 4), connection->name(), format_number(peak, 4)));
  }
  [[nodiscard]] bool has_peak_factor() const {
    return find_field(shaft_.input().calculator->input->fields, "k_max") != nullptr;
  }

  /// No mass on a shaft lies so near to its axis: a ring around the thinnest diameter d, or a disc of it, has at least
  /// m d^2/8.
  void compare_least_gyration(const std::string& seat) {
    const double mass = own_value(shaft_, project_, seat + "mass"), J = own_value(shaft_, project_, seat + "J");
    double d = std::nan("");
    for_each_leaf(shaft_.input().reading.record, [&](const std::string& path, const Leaf&) {
      if (path.starts_with("pieces") && path.ends_with(".d")) d = std::fmin(d, own_value(shaft_, project_, path));
    });
    const double least = mass * d * d / 8.0;
    if (!(J < (1.0 - rounded) * least)) return;
    add(seat + "J",
        say("{1} = {2} is too low for a mass of {3} that turns with a shaft of {4}, at least {5}; justify it: "
            "{6} = \"...\"",
            seat + "J", format_quantity(J, "kg*m^2", 3), format_quantity(mass, "kg", 3), format_quantity(d, "mm", 4),
            format_quantity(least, "kg*m^2", 3), because_key(seat + "J")));
  }

  /// A mass that is taken from a flywheel or a disc has its moment of inertia, in proportion.
  void compare_inertia(const Operand& operand) {
    if (!operand.path.starts_with("seats") || !operand.path.ends_with(".mass")) return;
    const std::string seat = prefix_of(operand.path);
    for (const auto& reference : operand.expression.references()) {
      const std::string wheel = split_step(reference.path).first;
      const double share = own_value(shaft_, project_, operand.path) / magnitude_at(project_, reference.path);
      double of_wheel = std::nan("");
      for (const char* const key : {".J_F", ".J", ".J_z"})
        of_wheel = std::fmax(of_wheel, magnitude_at(project_, wheel + key));
      for (const char* const key : {"J", "I_p"}) {
        if (!(own_value(shaft_, project_, seat + key) < (1.0 - in_few_digits) * share * of_wheel)) continue;
        add(seat + key,
            say("{1} is below the moment of inertia of '{2}', whose mass is taken, {3}: take it from "
                "there, or {4} = \"...\"",
                seat + key, wheel, format_quantity(share * of_wheel, "kg*m^2", 3), because_key(seat + key)));
      }
    }
  }

  /// A body of the width of the seat with this moment of inertia has at least a ninth of the mass of a solid steel
  /// disc: no rim lies further out than three times its radius of gyration.
  void compare_gyration(const std::string& seat) {
    constexpr double steel = 7850.0, least = 1.0 / 9.0;
    const double mass = own_value(shaft_, project_, seat + "mass"), b = own_value(shaft_, project_, seat + "b");
    const double J = std::fmax(own_value(shaft_, project_, seat + "J"), own_value(shaft_, project_, seat + "I_p"));
    // Of a disc J = m D^2 / 8 and m = rho pi D^2 b / 4, so that m^2 = 2 pi rho b J.
    const double of_disc = std::sqrt(2.0 * std::numbers::pi * steel * b * J);
    if (!(mass < least * of_disc)) return;
    add(seat + "mass", say("{1} = {2} is too low for J = {3} and {4} = {5}: a steel disc has {6}; justify it: "
                           "{7} = \"...\"",
                           seat + "mass", format_quantity(mass, "kg", 3), format_quantity(J, "kg*m^2", 3), seat + "b",
                           format_quantity(b, "mm", 4), format_quantity(of_disc, "kg", 3), because_key(seat + "mass")));
  }

  const Step& shaft_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> values_of_seats(const Step& step, const Project& project) {
  return SeatCheck(step, project).run();
}

}  // namespace loadpath::project
