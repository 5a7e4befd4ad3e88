#include "lib/quantity/literal.hpp"

#include "lib/quantity/format.hpp"
#include "lib/quantity/number/cursor.hpp"
#include "lib/quantity/number/number.hpp"
#include "lib/quantity/unit.hpp"
#include "lib/quantity/unit_hint.hpp"

#include <optional>

namespace loadpath {
namespace {

constexpr std::size_t longest = 256;  // bytes; the longest sensible quantity has some forty
constexpr Dimension frequency = Dimension::of(0, 0, -1), angular_speed = Dimension::of(0, 0, -1, 0, 1);
constexpr Dimension acceleration = Dimension::of(1, 0, -2), work = Dimension::of(2, 1, -2),
                    stiffness = Dimension::of(0, 1, -2);

/// A literal in its parts.
struct Written {
  std::string_view text, number, unit_text;
  std::size_t at = 0;
  double value = 0.0;
  ParsedUnit unit;
};

std::string_view without_spaces_behind(std::string_view text) {
  for (std::size_t size = text.size() + 1; text.size() < size;) {
    size = text.size();
    for (const std::string_view space : spaces)
      if (text.ends_with(space)) text.remove_suffix(space.size());
  }
  return text;
}

/// The fault of a text that is invalid in any field.
std::optional<Fault> unreadable(std::string_view text) {
  if (text.size() > longest)
    return Fault{
        longest, text.size() - longest, say("a quantity of more than {1} characters", std::to_string(longest)), {}};
  if (const std::size_t bad = first_invalid_byte(text); bad != std::string_view::npos)
    return Fault{bad, 1, say("this byte is not UTF-8 text"), say("write it in UTF-8")};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (const auto c = static_cast<unsigned char>(text[i]); (c < 0x20 && c != '\t') || c == 0x7F)
      return Fault{i, 1, say("a control character does not belong in a quantity"), {}};
  return {};
}

Outcome<Written> read(std::string_view text) {
  if (auto fault = unreadable(text)) return *std::move(fault);
  Cursor in{without_spaces_behind(text)};
  in.skip_spaces();
  Written w;
  w.at = in.at;
  w.text = in.text.substr(in.at);
  const Outcome<Number> number = read_number(in.text, in.at);
  if (!number) return number.fault();
  w.value = number->value;
  w.number = in.text.substr(in.at, number->end - in.at);
  in.at = number->end;
  in.skip_spaces();
  w.unit_text = in.text.substr(in.at);
  if (in.done()) return w;
  const Outcome<ParsedUnit> unit = read_unit(in.text, in.at);
  if (!unit) return unit.fault();
  w.unit = *unit;
  return w;
}

Fault refuse(const Written& w, Message message, Message hint = {}) {
  return {w.at, w.text.size(), std::move(message), std::move(hint)};
}

Outcome<Literal> in_si(const Written& w) {
  const double si = w.unit.to_si(w.value);
  const bool vanished = si == 0.0 && w.value != 0.0 && w.unit.offset == 0.0;
  if (w.unit.offset != 0.0 && si < 0.0)
    return refuse(w, say("'{1}' is below absolute zero", w.text), say("the lowest temperature is -273.15 °C"));
  if (is_normal_or_zero(si) && !vanished) return Literal{si, w.unit.dimension};
  return refuse(w, say("'{1}' is out of the range of numbers", w.text));
}

std::string named(const Dimension& dimension, Kind kind) {
  std::string name = name_of(dimension);
  if (kind == Kind::energy && dimension == work) name = "energy";
  if (kind == Kind::difference) name = "temperature difference";
  const bool vowel = std::string_view("aeio").find(name[0]) != std::string_view::npos;
  return (vowel ? "an " : "a ") + name;
}

/// "a moment"
std::string named(const Expected& expected) {
  const bool is_load = expected.dimension == stiffness && expected.symbol.starts_with('q');
  return is_load ? "a load per length" : named(expected.dimension, expected.kind);
}

std::string usual_unit(const Expected& expected) {
  return expected.unit.empty() ? readable_unit(0.0, expected.dimension, expected.kind) : std::string(expected.unit);
}

/// The unknown name that is all of the unit of a text: "mn" of "30 mn", not "n" of "30 n*m"; else empty.
std::string_view only_unit(std::string_view text, const Fault& fault) {
  if (fault.message.id != unknown_unit("").id) return {};
  Cursor in{without_spaces_behind(text)};
  in.skip_spaces();
  const Outcome<Number> number = read_number(in.text, in.at);
  if (!number) return {};
  in.at = number->end;
  in.skip_spaces();
  return in.at == fault.at && in.text.size() == fault.at + fault.length ? in.text.substr(in.at) : std::string_view{};
}

Fault with_remedy(std::string_view text, Fault fault, const Expected& expected) {
  const bool number = expected.dimension.is_number();
  if (number && fault.message.id == unknown_unit("").id) fault.hint = say("write the number without a unit");  // 300 HB
  if (const std::string_view name = only_unit(text, fault); !number && !name.empty())
    fault.hint = unknown_unit_hint(name, expected.dimension, usual_unit(expected));
  if (!fault.hint.empty()) return fault;
  fault.hint =
      number ? say("write a plain number") : say("write a number and a unit, as in '30 {1}'", usual_unit(expected));
  return fault;
}

Fault no_unit(const Written& w, const Expected& expected) {
  return refuse(w, say("'{1}' has no unit; {2} is expected", w.number, named(expected)),
                say("write '{1} {2}'", w.number, usual_unit(expected)));
}

Fault wrong_dimension(const Written& w, const Expected& expected) {
  const Dimension &is = w.unit.dimension, &wanted = expected.dimension;
  const Kind kind = w.unit.has(Mark::work) ? Kind::energy : Kind::plain;
  Message message = say("'{1}' is {2}; {3} is expected", w.text,
                        is == stiffness ? "a stiffness or load per length" : named(is, kind), named(expected));
  if (wanted.is_number()) return refuse(w, std::move(message), say("write the number without a unit"));
  const bool is_mass_for_force = is == wanted * acceleration || wanted == is * acceleration;
  if (is_mass_for_force && is == Dimension::of(1, 1, 0))
    return refuse(w, std::move(message), say("lb is a mass: a torque is written in lbf*ft or lbf*in"));
  if (is_mass_for_force)
    return refuse(w, std::move(message), say("a force is written in N, kgf or lbf, a mass in kg or lb"));
  return refuse(w, std::move(message), say("write a unit such as {1}", usual_unit(expected)));
}

/// A rotational speed that is written without its angle: 1/min counts revolutions, all else is refused.
Outcome<Literal> rotational_speed(Written w) {
  if (w.unit.has(Mark::hertz))
    return refuse(w, say("'{1}' is a frequency; an angular velocity is expected", w.text),
                  say("write it in rpm or in rad/s"));
  if (w.unit.names != 1 || !w.unit.has(Mark::minute))
    return refuse(w, say("'{1}' is ambiguous: radians or revolutions", w.text), say("write 'rad/s' or 'rev/s'"));
  w.unit.factor = find_unit("rpm").row->factor;
  w.unit.dimension = angular_speed;
  return in_si(w);
}

std::optional<Fault> wrong_kind(const Written& w, Kind kind) {
  if (w.unit.has(Mark::scale) && kind != Kind::temperature)
    return refuse(w, say("'{1}' is a point on the temperature scale; a difference is expected", w.text),
                  say("write the difference in K"));
  if (w.unit.has(Mark::work) && kind == Kind::moment)
    return refuse(w, say("'{1}' is an energy; a moment is expected", w.text), say("write it in N*m"));
  return {};
}

}  // namespace

Outcome<Literal> parse_literal(std::string_view text, const Expected& expected) {
  const Outcome<Written> w = read(text);
  if (!w) return with_remedy(text, w.fault(), expected);
  const Dimension& is = w->unit.dimension;
  if (w->unit_text.empty() && !expected.dimension.is_number()) return no_unit(*w, expected);
  if (expected.dimension == angular_speed && is == frequency) return rotational_speed(*w);
  if (is != expected.dimension) return wrong_dimension(*w, expected);
  if (auto fault = wrong_kind(*w, expected.kind)) return *std::move(fault);
  return in_si(*w);
}

Outcome<Literal> parse_literal(std::string_view text) {
  const Outcome<Written> w = read(text);
  if (!w) return w.fault();
  return in_si(*w);
}

Meant kind_of_literal(std::string_view text) {
  const Outcome<Written> w = read(text);
  if (!w) return Meant::nothing;
  const auto& unit = w->unit;
  return kind_of_unit(unit.dimension, unit.has(Mark::hertz), unit.has(Mark::work), unit.has(Mark::scale));
}

bool counts_anything(const Dimension& dimension, std::string_view text) {
  const auto has = [text](std::string_view symbol) { return text.find(symbol) != std::string_view::npos; };
  return dimension == frequency && !has("Hz") && !has("s") && !has("rev");  // rpm/rev counts turns
}

Outcome<UnitValue> parse_unit(std::string_view text) {
  if (auto fault = unreadable(text)) return *std::move(fault);
  if (text == "-" || text == "1") return UnitValue{};
  const Outcome<ParsedUnit> unit = read_unit(without_spaces_behind(text), 0);
  if (!unit) return unit.fault();
  return UnitValue{unit->to_si(1.0) - unit->offset, unit->offset, unit->dimension};
}

}  // namespace loadpath
