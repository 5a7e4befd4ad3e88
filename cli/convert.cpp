#include "cli/commands.hpp"
#include "lib/project/read/reading.hpp"
#include "lib/quantity/expression/expression.hpp"
#include "lib/quantity/format.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <cmath>
#include <iostream>

namespace loadpath::cli {

namespace {

int refuse(const std::string& text, std::size_t skipped, const char* what, const Fault& fault) {
  const Place place = project::place_in({what, 1, 1, 1}, text, fault.at + skipped, fault.length);
  terminal::show_issues({{place, "", fault.message, fault.hint, Severity::error}}, {{what, text}});
  return wrong_input;
}

}  // namespace

/// "2700 lbf*in", or an expression without references: "=2 * pi * 3 rad/s".
int convert(const ConvertOptions& options) {
  const std::string& text = options.quantity;
  const bool expression = text.starts_with('=');
  Literal literal;
  if (expression) {
    const auto parsed = Expression::parse(std::string_view(text).substr(1));
    if (!parsed) return refuse(text, 1, "quantity", parsed.fault());
    const auto signature = parsed->check([](const std::string& path) -> Outcome<Signature> {
      return Fault{0, path.size(), say("'{1}' refers to a project, and there is none here", path), {}};
    });
    if (!signature) return refuse(text, 1, "quantity", signature.fault());
    static const Value none;
    literal = {parsed->evaluate([](const std::string&) -> const Value& { return none; }).si[0], signature->dimension};
    if (!std::isfinite(literal.si)) {
      return refuse(
          text, 1, "quantity",
          {0, text.size() - 1, say("there is no such number: a division by zero, or a root of a negative"), {}});
    }
  } else {
    const auto parsed = parse_literal(text);
    if (!parsed) return refuse(text, 0, "quantity", parsed.fault());
    literal = *parsed;
  }
  const std::string unit = !options.unit.empty()           ? options.unit
                           : literal.dimension.is_number() ? "-"
                                                           : readable_unit(literal.si, literal.dimension);
  const auto target = parse_unit(unit);
  if (!target) return refuse(unit, 0, "unit", target.fault());
  // A literal says what it is, so that Hz is not taken for rad/s; an expression is compared without its angle.
  const bool fits = expression ? target->dimension.without_angle() == literal.dimension.without_angle()
                               : target->dimension == literal.dimension;
  if (!fits) {
    std::cerr << "loadpath: '" << text << "' is a " << name_of(literal.dimension) << ", '" << unit << "' is a unit of "
              << name_of(target->dimension) << "\n";
    return wrong_input;
  }
  std::cout << format_quantity(literal.si, unit, 10) << "\n";
  return passed;
}

}  // namespace loadpath::cli
