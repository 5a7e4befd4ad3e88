#include "lib/project/references/space/seat_notches.hpp"

#include "lib/project/references/origins.hpp"
#include "lib/project/references/references.hpp"
#include "lib/project/references/space/bodies.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace loadpath::project {

namespace {

constexpr double rounded = 0.02;

std::vector<std::string> elements_of(const Record& record, const char* key) {
  const FieldInfo* const list = find_field(record.type->fields, key);
  std::vector<std::string> all;
  for (std::size_t i = 0; list != nullptr && i < list->size(record.data.get()); ++i)
    all.push_back(key + element_path(*list, record.data.get(), i) + ".");
  return all;
}

class SeatNotches {
 public:
  SeatNotches(const Step& shaft, const Project& project) : shaft_(shaft), project_(project) {}

  std::vector<ReducedLoad> run() {
    const Record& record = shaft_.input().reading.record;
    const auto seats = elements_of(record, "seats"), notches = elements_of(record, "notches");
    for (const std::string& notch : notches) {
      for (const std::string& seat : seats) compare_keyway(notch, seat), compare_hole(notch, seat);
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] double at(const std::string& path) const { return own_value(shaft_, project_, path); }

  /// The step whose record this part of the shaft takes; null if it takes none.
  [[nodiscard]] const Step* source_of(const std::string& path) const {
    const auto& records = shaft_.input().reading.records;
    const auto taken = std::ranges::find(records, path, &Taken::path);
    return taken == records.end() ? nullptr : project_.find(split_step(taken->source).first);
  }

  [[nodiscard]] std::string word(const std::string& path) const {
    const Leaf leaf = find_leaf(shaft_.input().reading.record, path);
    return leaf && leaf.field->type == FieldInfo::Type::choice ? word_of(leaf) : std::string();
  }

  [[nodiscard]] bool is_under(const std::string& notch, const std::string& seat) const {
    return std::abs(at(notch + "x") - at(seat + "x")) <= at(seat + "b") / 2.0;
  }

  /// Whether a seat of the shaft takes the connection of this step.
  [[nodiscard]] bool is_taken(const Step& connection) const {
    const auto& records = shaft_.input().reading.records;
    return std::ranges::any_of(records, [&](const Taken& record) {
      return record.path.ends_with(".connection") && split_step(record.source).first == connection.name();
    });
  }

  void compare_keyway(const std::string& notch, const std::string& seat) {
    const Step* const connection = source_of(notch + "part");
    if (connection == nullptr || word(seat + "integral") != "true" || !is_under(notch, seat)) return;
    if (is_taken(*connection)) return;
    add(seat + "integral", say("the component is integral with the shaft, and the notch of '{1}' lies under it: "
                               "connection = \"={1}.connection\", or {2} = \"...\"",
                               connection->name(), because_key(seat + "integral")));
  }

  void compare_hole(const std::string& notch, const std::string& seat) {
    const Step* const pin = source_of(seat + "connection");
    if (pin == nullptr || word(notch + "kind") != "cross-hole" || !is_under(notch, seat)) return;
    const double d = own_value(*pin, project_, "d"), own = 2.0 * at(notch + "r");
    const bool is_pin = !std::isnan(own_value(*pin, project_, "d_w"));
    if (!is_pin || !(own < (1.0 - rounded) * d)) return;
    add(notch + "r",
        say("{1} is the radius of a hole of {2}, and the pin of '{3}' has {4}; justify it: {5} = \"...\"", notch + "r",
            format_quantity(own, "mm", 4), pin->name(), format_quantity(d, "mm", 4), because_key(notch + "r")));
  }

  void add(const std::string& path, Message message) { found_.push_back({path, std::move(message)}); }

  const Step& shaft_;
  const Project& project_;
  std::vector<ReducedLoad> found_;
};

}  // namespace

std::vector<ReducedLoad> notches_of_seats(const Step& step, const Project& project) {
  if (!is_shaft(step)) return {};
  return SeatNotches(step, project).run();
}

}  // namespace loadpath::project
