#include "api/translate.hpp"
#include "lib/quantity/literal.hpp"
#include "lib/quantity/unit.hpp"

#include <loadpath/units.hpp>

namespace loadpath::api {

namespace {

ParsedUnit unit_of(std::string_view text) {
  if (text == "-" || text == "1") return {};
  const Outcome<ParsedUnit> unit = read_unit(text, 0);
  if (!unit) refuse(unit.fault().message, unit.fault().hint);
  return *unit;
}

}  // namespace

void convert(std::span<double> values, std::string_view from, std::string_view to) {
  const ParsedUnit source = unit_of(from), target = unit_of(to);
  if (source.dimension != target.dimension)
    refuse(say("'{1}' is a unit of {2}, '{3}' of {4}", from, name_of(source.dimension), to, name_of(target.dimension)));
  for (double& value : values) value = target.from_si(source.to_si(value));
}

double in_si(std::string_view quantity) {
  const Outcome<Literal> literal = parse_literal(quantity);
  if (!literal) refuse(literal.fault().message, literal.fault().hint);
  return literal->si;
}

}  // namespace loadpath::api
