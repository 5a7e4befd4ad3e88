// Writes JSON as text while it is made: indented, keys in the order they come, numbers the shortest that read back.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::exports {

class JsonWriter {
 public:
  /// Whether each item of a list has its own line; numbers share lines.
  enum class Items { in_lines, side_by_side };

  void open_object() { open('{', Items::in_lines); }
  void close_object() { close('}'); }
  void open_array(Items items = Items::in_lines) { open('[', items); }
  void close_array() { close(']'); }

  /// Writes the key of the member whose value follows.
  JsonWriter& key(std::string_view name);

  void write(std::string_view text);
  void write(const char* text) { write(std::string_view(text)); }
  void write(bool value) { item() += value ? "true" : "false"; }
  void write(std::int64_t value) { item() += std::to_string(value); }
  void write(int value) { write(static_cast<std::int64_t>(value)); }
  /// Writes null if it is not finite.
  void write(double value);
  void write_null() { item() += "null"; }
  /// Side by side. `rounding`: of which size a difference of them is nothing (Value::rounding); 0: not known.
  void write(const std::vector<double>& values, double rounding = 0.0);

  template <class Value>
  void member(std::string_view name, const Value& value) {
    key(name).write(value);
  }

  /// All that was written, with an end of line; once everything is closed.
  [[nodiscard]] std::string take();

 private:
  struct Level {
    Items items = Items::in_lines;
    bool empty = true;
  };
  /// Makes room for the next value: a comma, a line.
  std::string& item();
  void start_item(Level& level);
  void open(char bracket, Items items);
  void close(char bracket);
  void quote(std::string_view text);

  std::string text_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace loadpath::exports
