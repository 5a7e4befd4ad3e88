#include "lib/project/read/meant/elsewhere.hpp"

#include "lib/quantity/literal.hpp"

#include <initializer_list>

namespace loadpath::project {

namespace {

using Type = FieldInfo::Type;

/// "crank = { speed = "... rad/s" }"
std::string written_within(const FieldInfo& outer, const FieldInfo& inner) {
  const bool in_unit = inner.type == Type::quantity && std::string_view(inner.unit) != "-";
  const std::string value = in_unit ? "\"... " + std::string(inner.unit) + "\"" : "...";
  const std::string table = "{ " + std::string(inner.key) + " = " + value + " }";
  return std::string(outer.key) + " = " + (outer.type == Type::list ? "[" + table + "]" : table);
}

/// The first of these inputs that is a length of this meaning; null if there is none.
const FieldInfo* length_of(std::span<const FieldInfo> fields, std::initializer_list<const char*> keys,
                           std::string_view meaning) {
  for (const char* const key : keys) {
    const FieldInfo* const field = find_field(fields, key);
    const bool is_length =
        field != nullptr && field->type == Type::quantity && field->dimension == Dimension::of(1, 0, 0);
    if (is_length && std::string_view(field->doc).find(meaning) != std::string_view::npos) return field;
  }
  return nullptr;
}

}  // namespace

Message input_within(std::string_view key, std::span<const FieldInfo> fields) {
  constexpr int most = 2;
  std::string names, examples;
  int count = 0;
  for (const FieldInfo& outer : fields) {
    const bool has_inputs = (outer.type == Type::group || outer.type == Type::list) && outer.has_fields();
    const FieldInfo* const inner = has_inputs ? find_input(outer.fields, key) : nullptr;
    if (inner == nullptr || inner->type == Type::name || count++ >= most) continue;
    names += (names.empty() ? "" : " and ") + std::string(outer.key);
    examples += (examples.empty() ? "" : " or ") + written_within(outer, *inner);
  }
  return count == 0 ? Message{} : say("it is an input of {1}: write {2}", names, examples);
}

Message element_called(std::string_view name, std::span<const FieldInfo> fields, void* owner) {
  for (const FieldInfo& list : fields) {
    const FieldInfo* const own = list.type == Type::list ? find_field(list.fields, "name") : nullptr;
    if (own == nullptr || own->type != Type::name) continue;
    for (std::size_t i = 0; i < list.size(owner); ++i) {
      if (own->text(list.element(owner, i)) == name)
        return say("did you mean '{1}'?", std::string(list.key).append(".").append(name));
    }
  }
  return {};
}

Message value_within(std::string_view value, const FieldInfo& table, const std::string& path) {
  std::vector<std::string> keys;
  for (const FieldInfo& field : table.fields) {
    keys.emplace_back(field.key);
    if (field.type != Type::quantity || std::string_view(field.unit) == "-") continue;
    const auto literal = parse_literal(value, Expected{field.dimension, field.kind, field.unit, field.key});
    if (!literal) continue;
    const std::string inner = "{ " + std::string(field.key) + " = \"" + std::string(value) + "\" }";
    return path.ends_with(']') ? say("write {1} = [{2}]", path.substr(0, path.rfind('[')), inner)
                               : say("write {1} = {2}", path, inner);
  }
  return there_is(keys);
}

Message torque_of_power(const toml::Tree::Entry& entry, std::span<const FieldInfo> fields) {
  constexpr Dimension power = Dimension::of(2, 1, -3), torque = Dimension::of(2, 1, -2);
  const FieldInfo* const T = find_field(fields, "T");
  const auto typed = parse_literal(entry.value.text);
  if (entry.key != "P" || T == nullptr || T->dimension != torque || !typed || typed->dimension != power) return {};
  return say("write the torque of the power at its speed: T = \"={1}/(1450 rpm)\"", entry.value.text);
}

namespace {

/// "write the radius: R = "=1200 mm/2"", for a diameter; of a torus, which has two radii, both.
Message radius_meant(const toml::Tree::Entry& entry, std::span<const FieldInfo> fields) {
  const FieldInfo* const radius = length_of(fields, {"R", "r"}, "radius");
  if (radius == nullptr) return {};
  const auto typed = parse_literal(entry.value.text);
  if (!typed || typed->dimension != radius->dimension)
    return say("write the radius: {1} = \"... {2}\"", radius->key, radius->unit);
  const FieldInfo* const ring = entry.key.starts_with('D') ? length_of(fields, {"R_0"}, "radius") : nullptr;
  if (ring == nullptr) return say("write the radius: {1} = \"={2}/2\"", radius->key, entry.value.text);
  return say("write the radius that is meant: {1} = \"={5}/2\" ({2}) or {3} = \"={5}/2\" ({4})", radius->key,
             radius->doc, ring->key, ring->doc, entry.value.text);
}

/// "write r and measured = "inner"", for a radius of a wall with the surface that it is measured to: r_i, R_m.
Message surface_meant(const std::string& key, std::span<const FieldInfo> fields) {
  if (key.size() != 3 || key[1] != '_' || find_field(fields, "measured") == nullptr) return {};
  const FieldInfo* const radius = length_of(fields, {key[0] == 'R' ? "R" : "r"}, "radius");
  const char* const surface = key[2] == 'm'                    ? "mean"
                              : key[2] == 'i'                  ? "inner"
                              : key[2] == 'a' || key[2] == 'o' ? "outer"
                                                               : nullptr;
  if (radius == nullptr || surface == nullptr) return {};
  return say("write {1} and measured = \"{2}\"", radius->key, surface);
}

}  // namespace

Message size_meant(const toml::Tree::Entry& entry, std::span<const FieldInfo> fields) {
  const std::string& key = entry.key;
  if (key == "D" || key == "d" || key == "D_i" || key == "D_a" || key == "d_i" || key == "d_a")
    return radius_meant(entry, fields);
  if (Message surface = surface_meant(key, fields); !surface.empty()) return surface;
  const FieldInfo* const thickness =
      key == "t" || key == "s" || key == "e" ? length_of(fields, {"delta"}, "thickness") : nullptr;
  return thickness == nullptr ? Message{} : say("did you mean '{1}' ({2})?", thickness->key, thickness->doc);
}

}  // namespace loadpath::project
