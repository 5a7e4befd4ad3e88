#include "lib/project/references/space/bodies.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace loadpath::project {

namespace {

bool has_id(const Step& step, std::string_view id) {
  const Calculator* const calculator = step.input().calculator;
  return id == calculator->id;
}

std::string quoted(const std::string& name) { return "'" + name + "'"; }

/// "seats.wheel.angle" is typed by this name or by its number.
bool is_given(const Reading& reading, const std::string& path) {
  const Leaf leaf = find_leaf(reading.record, path);
  const auto is_it = [&](const Leaf& other) {
    return leaf && other && other.field == leaf.field && other.owner == leaf.owner;
  };
  return std::any_of(reading.typed.begin(), reading.typed.end(),
                     [&](const auto& typed) { return is_it(find_leaf(reading.record, typed.first)); }) ||
         std::any_of(reading.operands.begin(), reading.operands.end(),
                     [&](const Operand& operand) { return is_it(operand.leaf); });
}

/// The centre distance of a pair whose gears lie side by side; NaN of a ring gear or a rack.
double distance_of_axes(const Project& project, const std::string& pair) {
  const double a = magnitude_at(project, pair + ".a_w");
  const double d_1 = magnitude_at(project, pair + ".d_w1"), d_2 = magnitude_at(project, pair + ".d_w2");
  return a > std::max(d_1, d_2) / 2.0 ? a : std::nan("");
}

}  // namespace

bool is_shaft(const Step& step) { return has_id(step, "shaft.design"); }

std::vector<GearOnShaft> gears_on(const Step& shaft, const Project& project) {
  std::vector<GearOnShaft> all;
  for (const Taken& record : shaft.input().reading.records) {
    if (!record.path.starts_with("seats") || !record.path.ends_with(".load")) continue;
    const auto [pair, gear] = split_step(record.source);
    const Step* const source = project.find(pair);
    if (source == nullptr || !has_id(*source, "gear.pair") || (gear != "gear_1" && gear != "gear_2")) continue;
    GearOnShaft found;
    found.seat = prefix_of(record.path), found.pair = pair, found.is_first = gear == "gear_1";
    found.x = own_value(shaft, project, found.seat + "x"), found.b = magnitude_at(project, record.source + ".b_r");
    found.m_n = magnitude_at(project, pair + ".m_n"), found.a = distance_of_axes(project, pair);
    found.d_f = magnitude_at(project, pair + (found.is_first ? ".d_f1" : ".d_f2"));
    found.has_angle = is_given(shaft.input().reading, found.seat + "angle");
    found.body = {Cylinder::Kind::gear,
                  found.seat + "x",
                  (found.is_first ? "gear 1 of " : "gear 2 of ") + quoted(pair),
                  found.x - found.b / 2.0,
                  found.x + found.b / 2.0,
                  magnitude_at(project, pair + (found.is_first ? ".d_a1" : ".d_a2"))};
    all.push_back(std::move(found));
  }
  return all;
}

std::vector<Cylinder> segments_of(const Step& shaft, const Project& project) {
  const Record& record = shaft.input().reading.record;
  const FieldInfo* const pieces = find_field(record.type->fields, "pieces");
  std::vector<Cylinder> all;
  double x = 0.0;
  for (std::size_t i = 0; pieces != nullptr && i < pieces->size(record.data.get()); ++i) {
    const std::string element = element_path(*pieces, record.data.get(), i), path = "pieces" + element + ".";
    const double l = own_value(shaft, project, path + "l");
    const double D = std::fmax(own_value(shaft, project, path + "d"), own_value(shaft, project, path + "d_2"));
    const std::string name = element.starts_with(".") ? quoted(element.substr(1)) : element;
    all.push_back(
        {Cylinder::Kind::segment, path + "d", "segment " + name + " of " + quoted(shaft.name()), x, x + l, D});
    x += l;
  }
  return all;
}

std::vector<Cylinder> bearings_of(const Step& shaft, const Project& project) {
  std::vector<Cylinder> all;
  for (const auto& step : project.steps) {
    if (!has_id(*step, "bearing.rolling")) continue;
    for (const Taken& record : step->input().reading.records) {
      const auto [source, place] = split_step(record.source);
      if (record.path != "load" || source != shaft.name() || !place.starts_with("bearings")) continue;
      const std::string path = "supports" + place.substr(std::string_view("bearings").size()) + ".x";
      const double x = own_value(shaft, project, path), B = magnitude_at(project, step->name() + ".B");
      all.push_back({Cylinder::Kind::bearing, path, "bearing " + quoted(step->name()), x - B / 2.0, x + B / 2.0,
                     magnitude_at(project, step->name() + ".D")});
    }
  }
  return all;
}

}  // namespace loadpath::project
