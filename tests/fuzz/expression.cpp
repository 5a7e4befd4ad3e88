// Any text is parsed, checked and evaluated without a crash; faults lie in the text; no value is infinite.
#include "lib/quantity/expression/expression.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace {

using namespace loadpath;

const Axis cycle{"lever", "crank angle", "deg", {0, 1, 2, 3, 4, 5}, {.1, .2, .2, .2, .2, .1}, 6.283185307179586};
const Axis open_axis{"column", "height", "m", {5, 3, 2, 1}, {}, 0.0};
const Value values[] = {
    {{Dimension::of(2, 1, -2), &cycle}, {1, -7, 3e300, 4, 0, 2}},
    {{Dimension::of(1, 1, -2), &open_axis}, {1, 0, std::numeric_limits<double>::infinity(), 4}},
    {{Dimension::of(1, 0, 0), nullptr}, {-0.04}},
    {{Dimension{}, nullptr}, {1e308}},
};

/// Every path is something: which, its last letter decides.
const Value& known(const std::string& path) {
  return values[static_cast<unsigned char>(path.back()) % std::size(values)];
}

Outcome<Signature> declared(const std::string& path) {
  if (path.back() == 'q') return Fault{0, 1, say("nothing here"), say("look elsewhere")};
  return known(path).signature;
}

void require(bool holds) {
  if (!holds) std::abort();
}

void require_sound(const Fault& fault, std::string_view text) {
  require(!fault.message.empty() && !fault.hint.empty() && !fault.message.text().empty());
  require(fault.length > 0 && fault.at <= text.size() && fault.at + fault.length <= text.size() + 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  const auto parsed = Expression::parse(text);
  if (!parsed) return require_sound(parsed.fault(), text), 0;
  for (const auto& reference : parsed->references()) {
    require(text.substr(reference.at).starts_with(reference.path));
  }
  const auto signature = parsed->check(declared);
  if (!signature) return require_sound(signature.fault(), text), 0;
  const Value value = parsed->evaluate(known);
  require(value.signature.dimension == signature->dimension && value.signature.axis == signature->axis);
  require(value.si.size() == (value.is_series() ? value.signature.axis->at.size() : 1));
  for (const double x : value.si) require(!std::isinf(x));
  return 0;
}
