#include "lib/project/read/spread.hpp"

#include "lib/quantity/literal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace loadpath::project {

namespace {

using sweep::Axis;
using toml::Tree;

bool is_literal(const Tree& tree) { return tree.type == Tree::Type::text || tree.type == Tree::Type::number; }

/// Data reused for reading each of many values.
struct Many {
  const Tree& tree;
  const Dimension& dimension;
  const ToSi& to_si;
  const Refuse& refuse;

  [[nodiscard]] std::optional<double> value(std::string_view key) const;
  [[nodiscard]] std::optional<double> difference(const Tree& value, std::string_view key) const;
  [[nodiscard]] std::optional<std::uint64_t> count(const Tree::Entry& entry) const;
  [[nodiscard]] std::optional<double> number(std::string_view key) const;
  [[nodiscard]] std::optional<double> spread(std::string_view key, double middle) const;
  [[nodiscard]] bool has_only(const std::vector<std::string>& keys) const;
  [[nodiscard]] std::optional<Axis> made(Outcome<Axis> axis, const Place& place) const;
  [[nodiscard]] bool is_one_of(const std::string& law, const std::vector<std::string>& laws) const;
};

bool Many::has_only(const std::vector<std::string>& keys) const {
  for (const Tree::Entry& entry : tree.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    refuse(entry.place, say("'{1}' is not a valid key here", entry.key), did_you_mean(entry.key, keys, there_is(keys)));
    return false;
  }
  return true;
}

/// Nothing if the key is missing, or its value refused.
std::optional<double> Many::value(std::string_view key) const {
  const auto* entry = tree.find(key);
  double si = 0.0;
  if (entry == nullptr) {
    refuse(tree.place, say("'{1}' is missing", key), {});
    return std::nullopt;
  }
  return to_si(entry->value, si) ? std::optional(si) : std::nullopt;
}

std::optional<std::uint64_t> Many::count(const Tree::Entry& entry) const {
  constexpr double most = 1e15;
  const double n = entry.value.number;
  if (entry.value.type == Tree::Type::number && n == std::floor(n) && n >= 2.0 && n <= most)
    return static_cast<std::uint64_t>(n);
  refuse(entry.value.place, say("'{1}' must be an integer, 2 or more", entry.key), say("write {1} = 11", entry.key));
  return std::nullopt;
}

/// A difference of two values: of temperatures in kelvin.
std::optional<double> Many::difference(const Tree& value, std::string_view key) const {
  if (value.type == Tree::Type::number && dimension.is_number()) return value.number;
  const auto literal = value.type == Tree::Type::text ? parse_literal(value.text, {dimension, Kind::difference, ""})
                                                      : Outcome<Literal>(Fault{});
  if (literal) return literal->si;
  refuse(value.place, say("'{1}' must be a {2}: it is the difference of two values", key, name_of(dimension)),
         literal.fault().hint);
  return std::nullopt;
}

/// A spread about the middle: a difference, or a part of it, "5 %".
std::optional<double> Many::spread(std::string_view key, double middle) const {
  const auto* entry = tree.find(key);
  if (entry == nullptr) {
    refuse(tree.place, say("'{1}' is missing", key), {});
    return std::nullopt;
  }
  const Tree& value = entry->value;
  if (value.type == Tree::Type::text && value.text.ends_with('%')) {
    const auto part = parse_literal(value.text);
    if (part && part->dimension.is_number()) return std::abs(middle) * part->si;
  }
  return difference(value, key);
}

/// A plain number, as the shape of a law.
std::optional<double> Many::number(std::string_view key) const {
  const auto* entry = tree.find(key);
  if (entry != nullptr && entry->value.type == Tree::Type::number) return entry->value.number;
  refuse(entry == nullptr ? tree.place : entry->value.place, say("'{1}' is a number", key), say("write {1} = 2", key));
  return std::nullopt;
}

std::optional<Axis> Many::made(Outcome<Axis> axis, const Place& place) const {
  if (axis) return std::move(*axis);
  refuse(place, axis.fault().message, axis.fault().hint);
  return std::nullopt;
}

std::optional<Axis> list_of(const Many& many) {
  std::vector<double> values;
  for (const Tree& item : many.tree.items) {
    double si = 0.0;
    if (!is_literal(item)) {
      many.refuse(item.place, say("a value is expected, not {1}", toml::word_for(item.type)), {});
      return std::nullopt;
    }
    if (!many.to_si(item, si)) return std::nullopt;
    values.push_back(si);
  }
  return many.made(Axis::list(std::move(values)), many.tree.place);
}

std::optional<Axis> range_of(const Many& many) {
  if (!many.has_only({"from", "to", "step", "count", "log"})) return std::nullopt;
  const auto* step = many.tree.find("step");
  const auto* count = many.tree.find("count");
  const auto* log = many.tree.find("log");
  if ((step != nullptr) + (count != nullptr) + (log != nullptr) != 1) {
    many.refuse(many.tree.place, say("a range has from, to, and one of step, count, log"),
                say("write { from = ..., to = ..., count = 11 }"));
    return std::nullopt;
  }
  const auto from = many.value("from"), to = many.value("to");
  if (!from || !to) return std::nullopt;
  if (step != nullptr) {
    const auto wide = many.difference(step->value, "step");
    return wide ? many.made(Axis::by_step(*from, *to, *wide), step->value.place) : std::nullopt;
  }
  const auto n = many.count(count != nullptr ? *count : *log);
  if (!n) return std::nullopt;
  return many.made(count != nullptr ? Axis::by_count(*from, *to, *n) : Axis::logarithmic(*from, *to, *n),
                   many.tree.place);
}

bool Many::is_one_of(const std::string& law, const std::vector<std::string>& laws) const {
  if (std::find(laws.begin(), laws.end(), law) != laws.end()) return true;
  const auto* entry = tree.find("distribution");
  refuse(entry == nullptr ? tree.place : entry->value.place, say("'{1}' is not one of these distributions", law),
         there_is(laws));
  return false;
}

/// { mean, sd }
std::optional<sweep::Law> law_of_mean(const Many& many, const std::string& law) {
  if (!many.has_only({"mean", "sd", "distribution"}) || !many.is_one_of(law, {"normal", "lognormal"}))
    return std::nullopt;
  const auto mean = many.value("mean");
  const auto sd = mean ? many.spread("sd", *mean) : std::nullopt;
  if (!sd) return std::nullopt;
  if (law == "normal") return sweep::Normal{*mean, *sd};
  return sweep::Lognormal{*mean, *sd};
}

/// { value, tolerance }: a uniform distribution within, or a normal law with its ends at three standard deviations.
std::optional<sweep::Law> law_of_tolerance(const Many& many, const std::string& law) {
  if (!many.has_only({"value", "tolerance", "distribution"}) ||
      !many.is_one_of(law, {"uniform", "triangular", "normal"}))
    return std::nullopt;
  const auto value = many.value("value");
  const auto t = value ? many.spread("tolerance", *value) : std::nullopt;
  if (!t) return std::nullopt;
  if (law == "normal") return sweep::Normal{*value, *t / 3.0};
  if (law == "triangular") return sweep::Triangular{*value - *t, *value, *value + *t};
  return sweep::Uniform{*value - *t, *value + *t};
}

/// { min, max }, { min, mode, max }
std::optional<sweep::Law> law_of_ends(const Many& many, const std::string& law) {
  const bool peaked = many.tree.find("mode") != nullptr;
  if (!many.has_only({"min", "mode", "max", "distribution"}) ||
      !many.is_one_of(law, {peaked ? "triangular" : "uniform"}))
    return std::nullopt;
  const auto min = many.value("min"), max = many.value("max");
  if (!min || !max) return std::nullopt;
  if (!peaked) return sweep::Uniform{*min, *max};
  const auto mode = many.value("mode");
  if (!mode) return std::nullopt;
  return sweep::Triangular{*min, *mode, *max};
}

/// { scale, shape }, with a least value { scale, shape, location }
std::optional<sweep::Law> law_of_scale(const Many& many, const std::string& law) {
  if (!many.has_only({"scale", "shape", "location", "distribution"}) || !many.is_one_of(law, {"weibull"}))
    return std::nullopt;
  const auto* location = many.tree.find("location");
  const auto least = location == nullptr ? std::optional(0.0) : many.value("location");
  const auto* scale = many.tree.find("scale");
  const auto wide = scale == nullptr ? many.value("scale") : many.difference(scale->value, "scale");
  const auto shape = many.number("shape");
  if (!least || !wide || !shape) return std::nullopt;
  return sweep::Weibull{*wide, *shape, *least};
}

/// The law implied by the keys of the table, if no distribution is named.
std::string usual_law(const Tree& tree) {
  if (const auto* named = tree.find("distribution")) return named->value.text;
  if (tree.find("mean") != nullptr) return "normal";
  if (tree.find("shape") != nullptr) return "weibull";
  return tree.find("mode") != nullptr ? "triangular" : "uniform";
}

/// { from, to }
bool is_range_of_designs(const Tree& tree) {
  return tree.type == Tree::Type::table && tree.entries.size() == 2 && tree.find("from") != nullptr &&
         tree.find("to") != nullptr;
}

std::optional<sweep::Law> law_of_range(const Many& many) {
  const auto from = many.value("from"), to = many.value("to");
  if (!from || !to) return std::nullopt;
  return sweep::Uniform{std::min(*from, *to), std::max(*from, *to), true};
}

std::optional<sweep::Law> law_of(const Many& many) {
  if (is_range_of_designs(many.tree)) return law_of_range(many);
  const std::string law = usual_law(many.tree);
  if (many.tree.find("mean") != nullptr) return law_of_mean(many, law);
  if (many.tree.find("value") != nullptr) return law_of_tolerance(many, law);
  if (many.tree.find("shape") != nullptr) return law_of_scale(many, law);
  return law_of_ends(many, law);
}

}  // namespace

bool is_grid(const Tree& tree) {
  return tree.type == Tree::Type::array ||
         (tree.type == Tree::Type::table && tree.find("from") != nullptr && !is_range_of_designs(tree));
}

bool is_uncertain(const Tree& tree) {
  constexpr std::array keys{"mean", "tolerance", "value", "min", "max", "scale", "shape"};
  return tree.type == Tree::Type::table &&
         (is_range_of_designs(tree) ||
          std::any_of(keys.begin(), keys.end(), [&](const char* key) { return tree.find(key) != nullptr; }));
}

std::optional<Axis> read_grid(const Tree& tree, const Dimension& dimension, const ToSi& to_si, const Refuse& refuse) {
  const Many many{tree, dimension, to_si, refuse};
  return tree.type == Tree::Type::array ? list_of(many) : range_of(many);
}

std::optional<sweep::Distribution> read_uncertain(const Tree& tree, const Dimension& dimension, const ToSi& to_si,
                                                  const Refuse& refuse) {
  const auto law = law_of({tree, dimension, to_si, refuse});
  if (!law) return std::nullopt;
  if (Message wrong = sweep::refusal(*law); !wrong.empty()) {
    refuse(tree.place, std::move(wrong), {});
    return std::nullopt;
  }
  return sweep::Distribution(*law);
}

std::string stock_of(const Tree& tree) {
  const auto* each = tree.type == Tree::Type::table ? tree.find("each") : nullptr;
  return each != nullptr && each->value.type == Tree::Type::text ? each->value.text : std::string();
}

}  // namespace loadpath::project
