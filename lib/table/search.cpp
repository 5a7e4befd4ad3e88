#include "lib/table/search.hpp"

#include "lib/quantity/literal.hpp"
#include "lib/table/rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace loadpath::table {

namespace {

constexpr std::pair<std::string_view, std::string_view> plain_words[] = {
    {"mass", "m"}, {"weight", "m"}, {"area", "A"}, {"depth", "h"}, {"height", "h"}, {"width", "b"}};

constexpr std::string_view signs[] = {">=", "<=", "!=", ">", "<", "="};  // the longer ones first

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// "in", "in^4", "lb/ft"
bool is_customary(std::string_view unit) { return unit == "in" || unit.starts_with("in^") || unit.starts_with("lb"); }

std::vector<std::string> keys_of(const std::vector<const Table*>& tables) {
  std::vector<std::string> keys;
  for (const Table* table : tables) {
    for (const Column& column : table->columns) {
      if (std::find(keys.begin(), keys.end(), column.key) == keys.end()) keys.push_back(column.key);
    }
  }
  return keys;
}

/// The column of a key or of a plain word, `at` bytes into the text.
Outcome<const Column*> column_named(std::string_view word, std::size_t at, const std::vector<const Table*>& tables) {
  if (const Column* column = find_column(tables, word)) return column;
  for (const auto& [plain, key] : plain_words) {
    const Column* column = plain == word ? find_column(tables, key) : nullptr;
    if (column != nullptr) return column;
  }
  auto keys = keys_of(tables);
  for (const auto& [plain, key] : plain_words) {
    if (find_column(tables, key) != nullptr) keys.emplace_back(plain);
  }
  return Fault{at, std::max<std::size_t>(1, word.size()), say("unknown column '{1}' in these tables", word),
               did_you_mean(word, keys, there_is(keys))};
}

std::size_t offset(std::string_view text, std::string_view part) {
  return static_cast<std::size_t>(part.data() - text.data());
}

/// A quantity of the column; a name of a unit is read as anywhere else.
Outcome<double> value_of(std::string_view text, std::string_view part, const Column& column) {
  const std::string_view unit = column.unit == "-" ? std::string_view() : std::string_view(column.unit);
  const auto literal = parse_literal(part, Expected{column.dimension, Kind::plain, unit});
  if (literal) return literal->si;
  Fault fault = literal.fault();
  fault.at += offset(text, part);
  return fault;
}

/// "h => 200 mm", "h == 200 mm": the sign that was meant.
std::optional<Fault> misspelt_sign(std::string_view text, std::string_view part) {
  constexpr std::pair<std::string_view, std::string_view> wrong[] = {{"=>", ">="}, {"=<", "<="}, {"==", "="}};
  for (const auto& [sign, meant] : wrong) {
    const std::size_t at = part.find(sign);
    if (at == std::string_view::npos) continue;
    return Fault{offset(text, part) + at, sign.size(), say("unknown sign '{1}'", sign), say("write {1}", meant)};
  }
  return {};
}

Outcome<Comparison> read_comparison(std::string_view text, std::string_view part,
                                    const std::vector<const Table*>& tables) {
  if (auto fault = misspelt_sign(text, part)) return *std::move(fault);
  for (const std::string_view sign : signs) {
    const std::size_t at = part.find(sign);
    if (at == std::string_view::npos) continue;
    const std::string_view key = trimmed(part.substr(0, at)), value = trimmed(part.substr(at + sign.size()));
    const auto column = column_named(key, offset(text, part), tables);
    if (!column) return column.fault();
    if (value.empty())
      return Fault{offset(text, part) + at, sign.size(), say("a value is missing after '{1}'", sign), {}};
    const auto si = value_of(text, value, **column);
    if (!si) return si.fault();
    return Comparison{(*column)->key, std::string(sign), *si};
  }
  return Fault{offset(text, part), std::max<std::size_t>(1, part.size()), say("'{1}' compares nothing", part),
               say("write a column, one of >= <= > < = !=, and a quantity: I_min >= 300 cm^4")};
}

}  // namespace

const Column* find_column(const std::vector<const Table*>& tables, std::string_view key) {
  const Column* customary = nullptr;
  for (const Table* table : tables) {
    const Column* const column = table->column(key);
    if (column != nullptr && !is_customary(column->unit)) return column;
    if (customary == nullptr) customary = column;
  }
  return customary;
}

bool Comparison::holds(double value) const {
  if (std::isnan(value)) return false;
  constexpr double rounding = 1e-12;  // rounding of unit conversions
  const bool same = std::fabs(value - si) <= rounding * std::fabs(si);
  if (sign == ">=") return value > si || same;
  if (sign == "<=") return value < si || same;
  if (sign == ">") return value > si && !same;
  if (sign == "<") return value < si && !same;
  return (sign == "=") == same;
}

double searched_value(const Row& row, std::string_view key) {
  const auto find = [&](const std::vector<Value>& values) {
    return std::find_if(values.begin(), values.end(), [&](const Value& v) { return v.key == key; });
  };
  if (const auto found = find(row.values); found != row.values.end()) return found->si;
  for (const Step& step : row.by_size) {
    if (const auto found = find(step.values); found != step.values.end()) return found->si;
  }
  return std::nan("");
}

Outcome<Condition> read_condition(std::string_view text, const std::vector<const Table*>& tables) {
  constexpr std::string_view joint = " and ";
  Condition condition;
  for (std::string_view rest = text;;) {
    const std::size_t end = std::min(rest.find(joint), rest.size());
    auto comparison = read_comparison(text, trimmed(rest.substr(0, end)), tables);
    if (!comparison) return comparison.fault();
    condition.push_back(std::move(*comparison));
    if (end == rest.size()) return condition;
    rest.remove_prefix(end + joint.size());
  }
}

Outcome<Order> read_order(std::string_view text, const std::vector<const Table*>& tables) {
  std::string_view key = trimmed(text);
  if (key.empty()) return Order{};
  const bool falls = key.starts_with('-');
  if (falls) key.remove_prefix(1);
  const auto column = column_named(key, offset(text, key), tables);
  if (!column) return column.fault();
  return Order{(*column)->key, falls};
}

std::vector<Entry> search(const std::vector<const Table*>& tables, const Condition& condition, const Order& order) {
  std::vector<std::pair<double, Entry>> found;
  for (const Entry& entry : entries_of(tables)) {
    const bool matches = std::all_of(condition.begin(), condition.end(), [&](const Comparison& comparison) {
      return comparison.holds(searched_value(*entry.row, comparison.key));
    });
    if (!matches) continue;
    const double rank = order.key.empty() ? 0.0 : searched_value(*entry.row, order.key);
    found.emplace_back(std::isnan(rank) ? std::numeric_limits<double>::infinity() : order.falls ? -rank : rank, entry);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Entry> entries;
  entries.reserve(found.size());
  for (const auto& [rank, entry] : found) entries.push_back(entry);
  return entries;
}

}  // namespace loadpath::table
