#include "lib/project/read/expectations.hpp"

#include "lib/project/read/errors.hpp"
#include "lib/project/read/reading.hpp"
#include "lib/quantity/number/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loadpath::project {

namespace {

using toml::Tree;

/// within = "0.5 %", a part of the value, or a quantity like it: "0.1 mm", of a plain number with a sign, "±0.01".
void read_within(const Tree& tree, Expectation& e, std::vector<Issue>& issues) {
  const Message remedy = e.unit.empty() || e.unit == "-"
                             ? say("write a part of the value, \"0.5 %\", or a difference from it, \"±0.01\"")
                             : say("write a part of the value, \"0.5 %\", or a quantity like it, \"0.1 {1}\"", e.unit);
  if (tree.type != Tree::Type::text) {
    return add_error(issues, tree.place, "expect.within", say("within is a text with a unit"), remedy);
  }
  constexpr std::string_view sign = "±";
  const bool is_difference = tree.text.starts_with(sign);
  const std::size_t start = is_difference ? sign.size() : 0;
  auto literal = parse_literal(std::string_view(tree.text).substr(start));
  if (literal && literal->dimension == Dimension::of(0, 0, 0, 1))  // 0.1 K, never a point on the scale
    literal = parse_literal(tree.text, Expected{literal->dimension, Kind::difference, "K"});
  if (!literal) {
    const Fault& fault = literal.fault();
    return add_error(issues, place_in(tree.place, tree.text, start + fault.at, fault.length), "expect.within",
                     fault.message, fault.hint.empty() ? remedy : fault.hint);
  }
  const Place place = place_in(tree.place, tree.text, 0, tree.text.size());
  if (!(literal->si > 0.0)) return add_error(issues, place, "expect.within", say("within must be > 0"), remedy);
  if (tree.text.find('%') != std::string::npos) {
    if (literal->si >= 1.0) return add_error(issues, place, "expect.within", say("within must be < 100 %"), remedy);
    e.within = literal->si;
  } else if (literal->dimension.is_number() && !is_difference) {
    add_error(issues, place, "expect.within",
              say("'{1}' may be a part of the value or a difference from it", tree.text), remedy);
  } else if (literal->dimension == e.is.dimension) {
    e.within_si = literal->si;
  } else if (!e.unit.empty()) {  // else `is` has been told already
    add_error(issues, place, "expect.within",
              say("'{1}' ({2}) is not a tolerance of '{3}' ({4})", tree.text, name_of(literal->dimension), e.is_text,
                  name_of(e.is.dimension)),
              remedy);
  }
}

/// digits = 3, or within = "0.5 %" or "0.1 mm"; neither of an infinite value.
void read_tolerance(const Tree& tree, Expectation& e, std::vector<Issue>& issues) {
  if (const auto* digits = tree.find("digits")) {
    const double n = digits->value.number;
    if (digits->value.type != Tree::Type::number || n < 1 || n > 15 || n != std::floor(n)) {
      add_error(issues, digits->value.place, "expect.digits", say("digits must be an integer from 1 to 15"));
    } else {
      e.digits = static_cast<int>(n);
    }
  }
  if (const auto* within = tree.find("within")) read_within(within->value, e, issues);
  const bool has_digits = tree.find("digits") != nullptr, has_within = tree.find("within") != nullptr;
  if (std::isinf(e.is.si)) {
    if (has_digits || has_within) add_error(issues, tree.place, "expect", say("an infinite value has no tolerance"));
  } else if (has_digits == has_within) {
    add_error(issues, tree.place, "expect", say("an expectation has either digits or within"));
  }
}

/// What is expected: a quantity, or "inf" of a plain number.
void read_expected(const Tree& tree, Expectation& e, std::vector<Issue>& issues) {
  if (e.is_text == "inf" || e.is_text == "-inf") {
    e.number = e.is.si = (e.is_text[0] == '-' ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
    e.unit = "-";
    return;
  }
  const auto is = parse_literal(e.is_text);
  if (!is) {
    add_error(issues, place_in(tree.place, e.is_text, is.fault().at, is.fault().length), "expect.is",
              is.fault().message, is.fault().hint);
    return;
  }
  e.is = *is;
  const auto number = read_number(e.is_text, 0);
  e.number = number->value;
  e.unit = e.is_text.substr(std::min(e.is_text.find_first_not_of(' ', number->end), e.is_text.size()));
  if (e.unit.empty()) e.unit = "-";
}

std::optional<Expectation> read_expectation(const Tree& tree, std::vector<Issue>& issues) {
  const std::size_t before = issues.size();
  Expectation e;
  for (const Tree::Entry& entry : tree.entries) {
    static const std::vector<std::string> keys{"value", "is", "digits", "within", "source", "note"};
    if (std::find(keys.begin(), keys.end(), entry.key) == keys.end()) {
      add_error(issues, entry.place, "expect", say("'{1}' is not a field here", entry.key),
                did_you_mean(entry.key, keys));
    }
  }
  for (const auto& [key, target] :
       {std::pair{"value", &e.text}, {"is", &e.is_text}, {"source", &e.source}, {"note", &e.note}}) {
    if (const auto* entry = tree.find(key)) *target = text_of(*entry, std::string("expect.") + key, issues);
  }
  if (e.text.empty() || e.is_text.empty() || e.source.empty()) {
    add_error(issues, tree.place, "expect", say("an expectation needs value, is and source"));
    return std::nullopt;
  }
  e.place = tree.find("value")->value.place;
  if (e.text.starts_with('=')) {
    e.text.erase(0, 1);
    ++e.place.column;
  }
  auto parsed = Expression::parse(e.text);
  if (!parsed) {
    add_error(issues, place_in(e.place, e.text, parsed.fault().at, parsed.fault().length), "expect.value",
              parsed.fault().message, parsed.fault().hint);
  } else {
    e.value = std::move(*parsed);
  }
  read_expected(tree.find("is")->value, e, issues);
  read_tolerance(tree, e, issues);
  return issues.size() == before ? std::optional(std::move(e)) : std::nullopt;
}

}  // namespace

void read_expectations(const Tree& tree, std::vector<Expectation>& expectations, std::vector<Issue>& issues) {
  if (tree.type != Tree::Type::array)
    return add_error(issues, tree.place, "expect", say("write expectations as [[expect]]"));
  for (const Tree& item : tree.items) {
    if (auto expectation = read_expectation(item, issues)) expectations.push_back(std::move(*expectation));
  }
}

}  // namespace loadpath::project
