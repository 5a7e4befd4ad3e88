#include "lib/draw/motion/data.hpp"

#include "lib/draw/motion/numbers.hpp"
#include "lib/quantity/format.hpp"

namespace loadpath::draw {
namespace {

constexpr double length_step = 0.05;    // view units
constexpr double angle_step = 0.0005;   // rad: 0.2 view units at the edge of the picture
constexpr double force_steps = 2000.0;  // steps of the largest component

template <class Items, class Write>
std::string list(const Items& items, const Write& write) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) text += (i == 0 ? "" : ",") + write(items[i]);
  return text + "]";
}

std::string column(const std::vector<double>& values, double step) {
  std::vector<long> changes;
  changes.reserve(values.size());
  long last = 0;
  for (const double v : values) {
    const long whole = std::lround(v / step);
    changes.push_back(whole - last);
    last = whole;
  }
  const bool constant = std::all_of(changes.begin() + 1, changes.end(), [](long c) { return c == 0; });
  if (constant) changes.resize(1);
  return list(changes, [](long c) { return std::to_string(c); });
}

template <class Items, class Read>
std::string column_of(const Items& items, double step, const Read& read) {
  std::vector<double> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(read(item));
  return column(values, step);
}

std::string link_data(const figure::Motion::Link& link, const Fit& fit) {
  using Pose = figure::Motion::Pose;
  return "[" + column_of(link.poses, length_step, [&](const Pose& p) { return fit.at(p.at).x; }) + "," +
         column_of(link.poses, length_step, [&](const Pose& p) { return fit.at(p.at).y; }) + "," +
         column_of(link.poses, angle_step, [](const Pose& p) { return p.phi; }) + "]";
}

std::string force_data(const figure::Motion::Force& force, const Fit& fit) {
  double most = 0.0;
  for (const Point f : force.values) most = std::max({most, std::fabs(f.x), std::fabs(f.y)});
  const double step = most > 0.0 ? most / force_steps : 1.0;
  std::string text = "[" + format_number(step, 7) + "," + column_of(force.values, step, [](Point f) { return f.x; }) +
                     "," + column_of(force.values, step, [](Point f) { return f.y; });
  if (!force.places.empty()) {
    text += "," + column_of(force.places, length_step, [&](Point p) { return fit.at(p).x; }) + "," +
            column_of(force.places, length_step, [&](Point p) { return fit.at(p).y; });
  }
  return text + "]";
}

std::string signs(const figure::Motion::Couple& couple) {
  std::string text = "\"";
  for (const double m : couple.values) text += m > 0.0 ? '+' : m < 0.0 ? '-' : '0';
  return text + "\"";
}

std::string plan_data(const figure::Motion::LinkPlan& plan, const PlanFit& fit) {
  return "[" + format_number(fit.scale, 7) + "," +
         list(plan.sides,
              [](const figure::Motion::Side& side) {
                return "[" + std::to_string(side.force) + "," + (side.sense < 0.0 ? "-1" : "1") + "]";
              }) +
         "]";
}

std::string texts(const figure::Motion::Number& number) {
  std::string text = "\"";
  for (std::size_t k = 0; k < number.si.size(); ++k) text += (k == 0 ? "" : " ") + number_text(number, k);
  return text + "\"";
}

}  // namespace

std::string motion_data(const figure::Motion& motion, const Fit& scheme, const std::vector<PlanFit>& plans) {
  std::vector<std::string> shapes;
  shapes.reserve(plans.size());
  for (std::size_t k = 0; k < plans.size(); ++k) shapes.push_back(plan_data(motion.plans[k], plans[k]));
  const auto as_is = [](const std::string& text) { return text; };
  return "{\"shown\":" + std::to_string(motion.shown) + ",\"step\":" + format_number(length_step) +
         ",\"turn\":" + format_number(angle_step) + ",\"newton\":" + format_number(scheme.newton, 7) +
         ",\"at\":" + texts(motion.axis) +
         ",\n\"links\":" + list(motion.links, [&](const auto& link) { return link_data(link, scheme); }) +
         ",\n\"forces\":" + list(motion.forces, [&](const auto& force) { return force_data(force, scheme); }) +
         ",\n\"couples\":" + list(motion.couples, signs) + ",\n\"plans\":" + list(shapes, as_is) +
         ",\n\"numbers\":" + list(motion.numbers, texts) + "}";
}

}  // namespace loadpath::draw
