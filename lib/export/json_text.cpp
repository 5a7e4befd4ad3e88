#include "lib/export/json_text.hpp"

#include "lib/export/json_writer.hpp"

#include <boost/json.hpp>

#include <algorithm>

namespace loadpath::exports {

namespace {

using Items = JsonWriter::Items;

void write(const boost::json::value& value, JsonWriter& out);

void write(const boost::json::array& array, JsonWriter& out) {
  const bool lines = std::any_of(array.begin(), array.end(), [](const auto& item) { return item.is_structured(); });
  out.open_array(lines ? Items::in_lines : Items::side_by_side);
  for (const auto& item : array) write(item, out);
  out.close_array();
}

void write(const boost::json::object& object, JsonWriter& out) {
  out.open_object();
  for (const auto& [key, item] : object) {
    out.key(key);
    write(item, out);
  }
  out.close_object();
}

void write(const boost::json::value& value, JsonWriter& out) {
  if (const auto* object = value.if_object()) return write(*object, out);
  if (const auto* array = value.if_array()) return write(*array, out);
  if (const auto* text = value.if_string()) return out.write(std::string_view(*text));
  if (const auto* number = value.if_double()) return out.write(*number);
  if (value.is_number()) return out.write(value.to_number<std::int64_t>());
  if (const auto* is = value.if_bool()) return out.write(*is);
  out.write_null();
}

}  // namespace

std::string text_of(const boost::json::value& value) {
  JsonWriter out;
  write(value, out);
  return out.take();
}

}  // namespace loadpath::exports
