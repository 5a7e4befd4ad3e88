#include "lib/project/references/drives/stages.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

constexpr double same_speed = 0.01;  // of the first shaft and the drive on it
constexpr double of_teeth = 0.02;    // ratios that are typed with few digits
constexpr double of_belts = 0.05;    // slip, and diameters of another line of the belt

/// "2" of "train.shafts[2].T", for the power or torque at the driving side.
struct Place {
  std::string train, number;
};

std::optional<Place> place_of_load(const Step& step) {
  constexpr std::string_view list = "shafts[";
  for (const Operand& operand : step.input().reading.operands) {
    if (operand.path != "P" && operand.path != "T_1") continue;
    for (const auto& reference : operand.expression.references()) {
      const auto path = split_step(reference.path);
      const std::size_t end = path.second.find(']');
      if (!path.second.starts_with(list) || end == std::string::npos) continue;
      std::string number = path.second.substr(list.size(), end - list.size());
      if (number.empty() || number.size() > 3 || number.find_first_not_of("0123456789") != std::string::npos) continue;
      return Place{path.first, std::move(number)};
    }
  }
  return std::nullopt;
}

/// The ratio of a drive by the inputs of both wheels, and the second of them.
struct Ratio {
  std::string wheel;  // "z_2"
  double i, tolerance;
};

std::optional<Ratio> ratio_of(const Step& step, const Project& project) {
  for (const char* const size : {"z", "d"}) {
    const std::string first = std::string(size) + "_1", second = std::string(size) + "_2";
    const double i = own_value(step, project, second) / own_value(step, project, first);
    if (i > 0.0 && std::isfinite(i)) return Ratio{second, i, *size == 'z' ? of_teeth : of_belts};
  }
  return std::nullopt;
}

/// Pairs of gears are compared with the stages by their teeth, and may be parts of one.
bool is_part_of_stage(const Step& step, const Step& train, const Place& place) {
  const Record& record = train.input().reading.record;
  const Leaf kind = find_leaf(record, "stages[" + place.number + "].kind");
  const std::string word = kind ? word_of(kind) : "";
  if (word == "planetary" || word == "other") return true;
  return find_field(step.input().calculator->input->fields, "idler") != nullptr;
}

double speed_at(const Project& project, const std::string& train, std::size_t number) {
  return std::abs(magnitude_at(project, train + ".shafts[" + std::to_string(number) + "].n"));
}

}  // namespace

std::vector<ReducedLoad> ratios_of_stages(const Step& step, const Project& project) {
  const auto place = place_of_load(step);
  const Step* const train = place ? project.find(place->train) : nullptr;
  if (train == nullptr) return {};
  if (find_field(train->input().calculator->input->fields, "stages") == nullptr) return {};
  if (is_part_of_stage(step, *train, *place)) return {};
  const auto own = ratio_of(step, project);
  const std::size_t number = std::stoul(place->number);
  const double n_1 = speed_at(project, place->train, number), n_2 = speed_at(project, place->train, number + 1);
  const double n = std::abs(own_value(step, project, "n_1"));
  if (!own || !(n_2 > 0.0) || !is_near(n, n_1, same_speed)) return {};
  const double i = n_1 / n_2;
  if (is_near(own->i, i, own->tolerance)) return {};
  return {
      {own->wheel, say("the ratio of this drive is {1}, and that of the stage of '{2}', whose load is used, is {3}: "
                       "correct one of them, or because.{4} = \"...\"",
                       format_number(own->i, 4), place->train, format_number(i, 4), own->wheel)}};
}

}  // namespace loadpath::project
