#include "lib/project/references/agreement/drive_lines.hpp"

#include "lib/calculator/meaning.hpp"
#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/sources.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

constexpr double slip = 0.1;      // of the speed of a motor
constexpr double digits = 0.01;   // of a speed that is typed twice
constexpr double weakest = 0.85;  // motor moment over the torque of the shaft: rounded values, losses

bool is_run_speed(std::string_view what) { return what == speed_of_run; }
bool is_run_moment(std::string_view what) { return what == moment_of_motor; }
bool is_flywheel_inertia(std::string_view what) { return what == inertia_of_flywheel; }

/// The shafts of a mechanism have a torque over the cycle, which a flywheel evens out.
bool is_train(const Step& step) { return std::string_view(step.input().calculator->id) == "drive.train"; }

/// The number of shafts of a train: of each stage the one behind it, and the first.
std::size_t shafts_of(const Step& train) {
  const Reading& reading = train.input().reading;
  const FieldInfo* const stages = find_field(train.input().calculator->input->fields, "stages");
  return stages->size(reading.record.data.get()) + 1;
}

/// The steps that refer to one of these, and those that refer to them in turn.
std::set<std::string> with_followers(std::set<std::string> names, const Project& project) {
  for (std::size_t before = 0; before != names.size();) {
    before = names.size();
    for (const auto& step : project.steps) {
      const std::set<std::string> sources = steps_named_in(step->input().reading);
      const auto is_among = [&](const std::string& source) { return names.contains(source); };
      if (std::ranges::any_of(sources, is_among)) names.insert(step->name());
    }
  }
  return names;
}

/// A shaft of the run: its torque, and the paths that others take it by.
struct LineShaft {
  std::string step;
  double T = std::nan("");
  std::vector<std::string> paths;
};

class LineCheck {
 public:
  LineCheck(const Step& run, const Project& project) : run_(run), project_(project) {}

  std::vector<ReducedLoad> run() {
    if (!is_run()) return {};
    const double n_1 = std::abs(own_value(run_, project_, "n_1")), n_2 = std::abs(own_value(run_, project_, "n_2"));
    const double from = std::isnan(n_1) ? 0.0 : n_1;
    speed_ = std::fmax(from, n_2);
    moment_ = largest_moment();
    if (!(speed_ > 0.0) || !(moment_ > 0.0)) return {};
    const std::vector<LineShaft> shafts = shafts_of_line();
    for (const LineShaft& shaft : shafts) {
      if (n_2 > from) compare_strength(shaft);
      compare_start(shaft);
    }
    if (n_2 > from) compare_flywheels();
    return std::move(found_);
  }

 private:
  void add(Message message) { found_.push_back({"motor", std::move(message)}); }

  [[nodiscard]] bool is_run() const {
    const Calculator& calculator = *run_.input().calculator;
    return means(calculator, "n_2", &is_run_speed) && means(calculator, "motor[1].M", &is_run_moment);
  }

  [[nodiscard]] double largest_moment() const {
    double most = std::nan("");
    for_each_leaf(run_.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
      if (!leaf.field->is_number() || !means(*run_.input().calculator, path, &is_run_moment)) return;
      most = std::fmax(most, std::abs(own_value(run_, project_, path)));
    });
    return most;
  }

  /// The shaft of a train that has the speed of the run, "train.shafts[1]"; none without its torque.
  void add_shafts(const std::string& train, double share, std::vector<LineShaft>& all) const {
    const Step* const step = project_.find(train);
    if (step == nullptr || !is_train(*step)) return;
    const std::size_t count = shafts_of(*step);
    for (std::size_t k = 1; k <= count; ++k) {
      const std::string shaft = train + ".shafts[" + std::to_string(k) + "].";
      const double n = std::abs(magnitude_at(project_, shaft + "n")), T = std::abs(magnitude_at(project_, shaft + "T"));
      if (std::isnan(n)) return;
      if (!(T > 0.0) || std::abs(speed_ - n) > share * n) continue;
      LineShaft found{train, T, {shaft + "T"}};
      if (k == 1) found.paths.push_back(train + ".T_1");
      all.push_back(std::move(found));
      return;
    }
  }

  /// Of the trains that it refers to; else of the only one in the file with a first shaft of this speed.
  [[nodiscard]] std::vector<LineShaft> shafts_of_line() const {
    std::vector<LineShaft> named, others;
    for (const std::string& train : steps_named_in(run_.input().reading)) add_shafts(train, slip, named);
    if (!named.empty()) return named;
    for (const auto& other : project_.steps) {
      if (!is_train(*other)) continue;
      const double n = std::abs(magnitude_at(project_, other->name() + ".shafts[1].n"));
      if (is_near(speed_, n, digits)) add_shafts(other->name(), digits, others);
    }
    return others.size() == 1 ? others : std::vector<LineShaft>{};
  }

  /// A motor that does not reach the torque of its shaft at any speed.
  void compare_strength(const LineShaft& shaft) {
    if (!(moment_ < weakest * shaft.T)) return;
    add(
        say("the motor moment of {1} is less than the torque of '{2}' at this speed, {3}: correct one of them, or "
            "because.motor = \"...\"",
            format_quantity(moment_, "N*m", 4), shaft.step, format_quantity(shaft.T, "N*m", 4)));
  }

  [[nodiscard]] bool takes(const Step& step, const LineShaft& shaft) const {
    bool found = false;
    for_each_reference(step.input().reading, [&](const std::string& path) {
      found = found || std::ranges::find(shaft.paths, path) != shaft.paths.end();
    });
    return found;
  }

  /// The largest that a shaft or a connection of this line has.
  [[nodiscard]] double peak_factor(const std::string& train) const {
    const std::set<std::string> line = with_followers({train, run_.name()}, project_);
    double most = 1.0;
    for (const auto& step : project_.steps) {
      if (line.contains(step->name())) most = std::fmax(most, peak_factor_of(*step, project_));
    }
    return most;
  }

  /// A start or a stop goes through all that is assessed for the torque of this shaft.
  void compare_start(const LineShaft& shaft) {
    if (!(moment_ > shaft.T)) return;
    const double peak = peak_factor(shaft.step);
    for (const auto& part : project_.steps) {
      const Calculator* const calculator = part->input().calculator;
      if (part.get() == &run_ || !takes(*part, shaft)) continue;
      const FieldInfo* const field = find_field(calculator->input->fields, "K_A");
      if (field == nullptr || !field->is_factor) continue;
      const double K_A = std::fmax(1.0, own_value(*part, project_, "K_A"));
      if (!(moment_ > K_A * shaft.T * peak)) continue;
      add(
          say("the moment of {1} is {2} times the torque of '{3}', which '{4}' takes with K_A = {5}: give K_A, k_max "
              "or T_max for it, or because.motor = \"...\"",
              format_quantity(moment_, "N*m", 4), format_number(moment_ / shaft.T, 3), shaft.step, part->name(),
              format_number(K_A, 4)));
      return;
    }
  }

  /// The speed of the wheel over that of the run; 1 at the same speed, NaN if the wheel is on no shaft of the run.
  [[nodiscard]] double ratio_of(const Step& wheel) const {
    const double omega = std::abs(own_value(wheel, project_, "omega"));
    if (is_near(omega, speed_, slip)) return 1.0;
    for (const Operand& operand : run_.input().reading.operands) {
      const auto& references = operand.expression.references();
      if (!operand.expression.is_reference() || !operand.path.ends_with(".J")) continue;
      if (split_step(references.front().path).first != wheel.name()) continue;
      return std::abs(own_value(run_, project_, prefix_of(operand.path) + "u"));
    }
    return std::nan("");
  }

  /// A motor that does not reach the mean moment of a flywheel, which it drives at the end of the run.
  void compare_flywheels() {
    for (const auto& wheel : project_.steps) {
      const Calculator* const calculator = wheel->input().calculator;
      if (!means(*calculator, "J", &is_flywheel_inertia)) continue;
      if (wheel->word("work") != "absorbed") continue;
      const double T = std::abs(magnitude_at(project_, wheel->name() + ".M_m")) * ratio_of(*wheel);
      if (!(moment_ < weakest * T)) continue;
      add(
          say("the motor moment of {1} is less than the mean moment of '{2}' at this speed, {3}: correct one of them, "
              "or because.motor = \"...\"",
              format_quantity(moment_, "N*m", 4), wheel->name(), format_quantity(T, "N*m", 4)));
    }
  }

  const Step& run_;
  const Project& project_;
  double speed_ = std::nan(""), moment_ = std::nan("");
  std::vector<ReducedLoad> found_;
};

}  // namespace

double peak_factor_of(const Step& step, const Project& project) {
  const double T = std::abs(own_value(step, project, "T")), T_max = std::abs(own_value(step, project, "T_max"));
  const double ratio = T > 0.0 ? T_max / T : 1.0;
  return std::fmax(std::fmax(1.0, own_value(step, project, "k_max")), ratio);
}

std::vector<ReducedLoad> torques_of_line(const Step& step, const Project& project) {
  return LineCheck(step, project).run();
}

}  // namespace loadpath::project
