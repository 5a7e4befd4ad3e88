// Any bytes are a quantity or a fault that points into them; what is read is a number that can be written and read
// again.
#include "lib/quantity/literal.hpp"

#include "lib/quantity/format.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace loadpath;

namespace {

void demand(bool holds) {
  if (!holds) std::abort();
}

void points_into(std::string_view text, const Fault& fault) {
  demand(!fault.message.text().empty());
  demand(fault.at <= text.size() && fault.length >= 1);
  demand(fault.at + fault.length <= text.size() || fault.length == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Outcome<Literal> literal = parse_literal(text);
  if (!literal) return points_into(text, literal.fault()), 0;
  demand(std::isfinite(literal->si));
  const Outcome<Literal> again = parse_literal(format_exact(literal->si));
  demand(again && again->si == literal->si);
  const Expected expected{literal->dimension, Kind::temperature, {}};
  const Outcome<Literal> expected_again = parse_literal(text, expected);
  demand(expected_again && expected_again->si == literal->si);
  for (const Kind kind : {Kind::moment, Kind::difference})
    if (const auto kept = parse_literal(text, {literal->dimension, kind, "mm"}); !kept) points_into(text, kept.fault());
  return 0;
}
