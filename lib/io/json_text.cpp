#include "lib/io/json_text.hpp"

#include "lib/quantity/format.hpp"

#include <boost/json.hpp>

namespace loadpath::io {

namespace {

bool is_flat(const boost::json::array& array) {
  for (const auto& item : array) {
    if (item.is_structured()) return false;
  }
  return true;
}

void write(const boost::json::value& value, const std::string& indent, std::string& out);

void write(const boost::json::array& array, const std::string& indent, std::string& out) {
  const bool flat = is_flat(array);
  const std::string inner = indent + "  ";
  out += '[';
  for (std::size_t i = 0; i < array.size(); ++i) {
    out += i == 0 ? "" : flat ? ", " : ",";
    if (!flat) out += "\n" + inner;
    write(array[i], inner, out);
  }
  out += flat || array.empty() ? "]" : "\n" + indent + "]";
}

void write(const boost::json::object& object, const std::string& indent, std::string& out) {
  const std::string inner = indent + "  ";
  out += '{';
  bool first = true;
  for (const auto& [key, item] : object) {
    out += (first ? "\n" : ",\n") + inner + boost::json::serialize(boost::json::string(key)) + ": ";
    write(item, inner, out);
    first = false;
  }
  out += object.empty() ? "}" : "\n" + indent + "}";
}

void write(const boost::json::value& value, const std::string& indent, std::string& out) {
  if (const auto* object = value.if_object()) return write(*object, indent, out);
  if (const auto* array = value.if_array()) return write(*array, indent, out);
  if (const auto* number = value.if_double()) {
    append_exact(*number, out);
  } else {
    out += boost::json::serialize(value);
  }
}

}  // namespace

std::string text_of(const boost::json::value& value) {
  std::string out;
  write(value, "", out);
  return out + "\n";
}

}  // namespace loadpath::io
