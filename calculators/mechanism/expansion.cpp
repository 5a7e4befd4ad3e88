#include "calculators/mechanism/expansion.hpp"

#include "calculators/mechanism/cycle/cycle.hpp"
#include "calculators/mechanism/cycle/ranges.hpp"
#include "calculators/mechanism/input/model.hpp"
#include "calculators/mechanism/templates/template.hpp"
#include "lib/calculator/record_of.hpp"
#include "lib/mechanism/studies/drive_range.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loadpath::planar {

namespace {

using project::Reading;

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// A point has its coordinates in one of two forms: a message on one of them applies to the point.
std::string told_path(const std::string& path) {
  const bool of_point =
      path.starts_with("ground.") || (path.starts_with("links.") && path.find(".points.") != std::string::npos);
  return of_point ? path.substr(0, path.rfind('.')) : path;
}

/// Values of what the template draws; masses and friction stay the user's.
void put(const Mechanism::Input& drawn, Mechanism::Input& in) {
  std::copy(drawn.ground.begin(), drawn.ground.end(), in.ground.begin());
  for (std::size_t i = 0; i < drawn.joints.size(); ++i) in.joints[i].direction = drawn.joints[i].direction;
  std::copy(drawn.profiles.begin(), drawn.profiles.end(), in.profiles.begin());
  for (std::size_t i = 0; i < drawn.links.size(); ++i) {
    in.links[i].origin = drawn.links[i].origin;
    in.links[i].angle = drawn.links[i].angle;
    std::copy(drawn.links[i].points.begin(), drawn.links[i].points.end(), in.links[i].points.begin());
  }
}

/// For a bar; a link with a mass centre of its own is none (words/masses.hpp).
void set_inertia(planar::Link& link, Length l, const Reading& reading) {
  const std::string path = "links." + std::string(link.name.view());
  if (reading.typed.count(path + ".J") != 0 || reading.typed.count(path + ".S") != 0) return;
  link.J = link.mass * l * l / 12.0;
}

/// The template with its crank at this angle; none if its lengths do not meet there.
std::optional<Mechanism::Input> drawn_at(const templates::MechanismTemplate& shape, const void* parameters,
                                         double angle) {
  Mechanism::Input drawn;
  templates::Sketch sketch(drawn, angle);
  shape.draw(parameters, sketch);
  return sketch.fault() ? std::nullopt : std::optional(std::move(drawn));
}

/// Between which angles the crank can turn, by the first one from `start` on at which it is clear of a stop: "between
/// 15.3 deg and 74.41 deg". None if nothing stops it.
std::optional<Message> part_that_closes(const templates::MechanismTemplate& shape, const void* parameters,
                                        double start) {
  constexpr double turn = 2.0 * pi, step = turn / 360.0;
  for (int k = 0; k < 360; ++k) {
    const double angle = start + k * step;
    const auto drawn = drawn_at(shape, parameters, angle);
    if (!drawn || !drawn_at(shape, parameters, angle - step) || !drawn_at(shape, parameters, angle + step)) continue;
    const auto range = mechanism::drive_range(model_of(*drawn), turn, turn);
    if (!range || !std::isfinite(range->least) || !std::isfinite(range->most)) return std::nullopt;
    const double ahead = turn * std::round((range->assembled - angle) / turn);
    return say("between {1} and {2}", limit_text(range->least - ahead, "deg"), limit_text(range->most - ahead, "deg"));
  }
  return std::nullopt;
}

}  // namespace

Record laid_out(const Template& from) {
  Record record(record_type<Mechanism::Input, Mechanism::inputs>);
  from.lay_out(record.data.get());
  return record;
}

bool is_given_in(const Record& laid, const std::string& path) {
  if (!find_leaf(laid, path)) return false;
  const std::string_view key = std::string_view(path).substr(path.rfind('.') + 1);
  const std::string_view head = std::string_view(path).substr(0, path.find('.'));
  if (head == "ground" || head == "links") return !is_one_of(key, {"name", "mass", "J", "S"});
  if (head == "joints") return is_one_of(key, {"type", "first", "second", "direction", "angle", "profile"});
  if (head == "profiles") return key != "name";
  if (head == "crank") {
    const Leaf joint = find_leaf(laid, "crank.joint");
    return is_one_of(key, {"joint", "to"}) && !joint.field->text(joint.owner).empty();
  }
  return head == "cylinders" && key == "joint";
}

std::vector<FieldFault> check_overrides(const Template& from, const Reading& reading) {
  const Record laid = laid_out(from);
  std::vector<FieldFault> faults;
  for (const auto& entry : reading.typed) {
    const std::string path = told_path(entry.first);
    if (!is_given_in(laid, entry.first) || (!faults.empty() && faults.back().path == path)) continue;
    faults.push_back({path, say("'{1}' comes from the template '{2}'", path, from.id),
                      say("leave it out; mass, J and S of its links, friction in its joints and new points are free")});
  }
  return faults;
}

std::vector<FieldFault> expand(const Template& from, const Reading& reading, Mechanism::Input& in, bool in_words) {
  const auto& shape = static_cast<const templates::MechanismTemplate&>(from);
  const void* parameters = reading.parameters.data.get();
  if (is_whole_turn(in)) {
    if (auto stop = shape.crank_stop(parameters)) {
      const bool has_part = in_words && stop->hint.id == templates::part_of_a_turn().id;
      const auto part = has_part ? part_that_closes(shape, parameters, first_crank_angle(in.crank)) : std::nullopt;
      if (part) stop->hint = templates::part_of_a_turn(*part);
      return {std::move(*stop)};
    }
  }
  Mechanism::Input drawn;
  templates::Sketch sketch(drawn, in.crank.joint.empty() ? unset<double> : first_crank_angle(in.crank));
  shape.draw(parameters, sketch);
  if (sketch.fault()) {
    FieldFault fault = *sketch.fault();
    const bool has_part = in_words && fault.hint.id == templates::start_elsewhere().id;
    const auto part = has_part ? part_that_closes(shape, parameters, first_crank_angle(in.crank)) : std::nullopt;
    if (part) fault.hint = templates::start_elsewhere(*part);
    return {std::move(fault)};
  }
  for (const auto& [link, l] : sketch.bars()) set_inertia(in.links[link], l, reading);
  put(drawn, in);
  return {};
}

account::Table template_table(const Template& from, const Record& parameters) {
  account::Table table{
      say("Template {1}: {2}", from.id, from.title), {say("parameter"), say("meaning"), say("value")}, {}};
  for_each_leaf(parameters, [&](const std::string& path, const Leaf& leaf) {
    const FieldInfo& field = *leaf.field;
    const bool choice = field.type == FieldInfo::Type::choice;
    if (!std::isfinite(leaf.get())) return;  // left out
    account::Cell value = account::Quantity{leaf.get(), field.unit};
    if (choice) value = say(field.choices[static_cast<std::size_t>(leaf.get())].key);
    table.rows.push_back({account::Symbol{path}, say(field.doc), std::move(value)});
  });
  return table;
}

}  // namespace loadpath::planar
