#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "lib/project/own_tables.hpp"
#include "lib/project/read/reading.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/unit_hint.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/table/tables.hpp"

#include <cmath>
#include <iostream>
#include <map>
#include <memory>

namespace loadpath::cli {

namespace {

int refuse(const std::string& text, std::size_t skipped, const char* what, Fault fault) {
  if (fault.hint.empty() && fault.message.id == unknown_unit("").id)
    fault.hint = say("`loadpath convert --help` lists the units");
  const Place place = project::place_in({what, 1, 1, 1}, text, fault.at + skipped, fault.length);
  terminal::show_issues({{place, "", fault.message, fault.hint, Severity::error}}, {{what, text}});
  return wrong_input;
}

/// The values of built-in tables, by their paths.
class TableValues {
 public:
  TableValues() {
    std::vector<project::NamedFile> files;
    std::vector<Issue> issues;
    tables_ = project::read_own_tables({}, "", catalogue(), files, issues);
  }

  Outcome<Signature> signature(const std::string& path) {
    if (!path.starts_with("tables."))
      return Fault{0, path.size(), say("'{1}' refers to a project, and there is none here", path), {}};
    const auto referred = tables_->value_at(path);
    if (!referred) return referred.fault();
    values_[path] = {{referred->dimension, nullptr}, {referred->value.si}};
    return values_[path].signature;
  }
  [[nodiscard]] const Value& value(const std::string& path) const { return values_.at(path); }

 private:
  std::shared_ptr<const table::Tables> tables_;
  std::map<std::string, Value> values_;
};

struct Converted {
  double si = 0.0;
  Dimension dimension;
  Meant kind = Meant::nothing;
  bool turns = false;  // pi makes radians of turns
};

/// The value of an expression without its `=`: of numbers, and of tables.
Outcome<Converted> value_of(std::string_view text) {
  const auto parsed = Expression::parse(text);
  if (!parsed) return parsed.fault();
  TableValues tables;
  const auto declared = [&](const std::string& path) { return tables.signature(path); };
  const auto signature = parsed->check(declared);
  if (!signature) return signature.fault();
  const auto kind = parsed->kind([](const std::string&) { return Meant::nothing; }, declared);
  if (!kind) return kind.fault();
  const double si = parsed->evaluate([&](const std::string& path) -> const Value& { return tables.value(path); }).si[0];
  if (std::isfinite(si)) return Converted{si, signature->dimension, *kind, parsed->holds_pi()};
  return Fault{0, text.size(), say("undefined: division by zero, or root of a negative number"), {}};
}

/// A fault is that of a quantity in the target unit, where one is given: "3 mn" to mm.
Outcome<Converted> literal_of(std::string_view text, const std::string& unit) {
  const auto literal = parse_literal(text);
  if (literal) return Converted{literal->si, literal->dimension};
  const auto target = parse_unit(unit);
  if (unit.empty() || !target) return literal.fault();
  return parse_literal(text, Expected{target->dimension, Kind::plain, unit}).fault();
}

/// The unit that a misspelt target means, of the dimension of the quantity.
Fault unknown_target(const std::string& unit, const Converted& literal, Fault fault) {
  const bool is_all = fault.at == 0 && fault.length == unit.size();
  if (fault.message.id != unknown_unit("").id || !is_all || literal.dimension.is_number()) return fault;
  fault.hint = unknown_unit_hint(unit, literal.dimension, readable_unit(literal.si, literal.dimension));
  return fault;
}

}  // namespace

/// "2700 lbf*in", or an expression without steps: "=2 * pi * 3 rad/s".
int convert(const ConvertOptions& options) {
  const std::string& text = options.quantity;
  const bool expression = text.starts_with('=');
  const auto read = expression ? value_of(std::string_view(text).substr(1)) : literal_of(text, options.unit);
  if (!read) return refuse(text, expression ? 1 : 0, "quantity", read.fault());
  const Converted literal = *read;
  const std::string unit = !options.unit.empty()           ? options.unit
                           : literal.dimension.is_number() ? "-"
                                                           : readable_unit(literal.si, literal.dimension);
  const auto target = parse_unit(unit);
  if (!target) return refuse(unit, 0, "unit", unknown_target(unit, literal, target.fault()));
  // A literal states its kind, so that Hz is not taken for rad/s; an expression is compared without its angle.
  const bool fits = expression ? fits_but_for_angle(target->dimension, literal.dimension, literal.kind, literal.turns)
                               : target->dimension == literal.dimension;
  if (!fits) {
    std::cerr << "loadpath: '" << text << "' is a " << name_of(literal.dimension) << ", '" << unit << "' is a unit of "
              << name_of(target->dimension) << "\n";
    if (literal.dimension.is_number() && !expression)
      std::cerr << "  = help: a value with a blank needs quotes: loadpath convert \"" << text << " " << unit << "\"\n";
    if (literal.dimension != target->dimension &&
        literal.dimension.without_angle() == target->dimension.without_angle())
      std::cerr << "  hint: turns per time times rev, as in \"=rev*50 Hz\"; an angle over rev counts turns\n";
    return wrong_input;
  }
  std::cout << format_quantity(literal.si, unit, 10) << "\n";
  return passed;
}

}  // namespace loadpath::cli
