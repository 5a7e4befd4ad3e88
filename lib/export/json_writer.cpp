#include "lib/export/json_writer.hpp"

#include "lib/quantity/decimal.hpp"
#include "lib/quantity/format.hpp"

#include <boost/json.hpp>

#include <algorithm>
#include <cmath>

namespace loadpath::exports {

namespace {

bool is_plain(char c) { return static_cast<unsigned char>(c) >= 0x20U && c != '"' && c != '\\'; }

}  // namespace

void JsonWriter::quote(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_plain)) {
    text_.append("\"").append(text).append("\"");
  } else {
    text_ += boost::json::serialize(boost::json::string(text));
  }
}

void JsonWriter::start_item(Level& level) {
  const bool in_lines = level.items == Items::in_lines;
  if (!level.empty) text_ += in_lines ? "," : ", ";
  level.empty = false;
  if (in_lines) text_.append(1, '\n').append(2 * levels_.size(), ' ');
}

std::string& JsonWriter::item() {
  if (!after_key_ && !levels_.empty()) start_item(levels_.back());
  after_key_ = false;
  return text_;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  start_item(levels_.back());
  quote(name);
  text_ += ": ";
  after_key_ = true;
  return *this;
}

void JsonWriter::open(char bracket, Items items) {
  item() += bracket;
  levels_.push_back({items, true});
}

void JsonWriter::close(char bracket) {
  const Level level = levels_.back();
  levels_.pop_back();
  if (!level.empty && level.items == Items::in_lines) text_.append(1, '\n').append(2 * levels_.size(), ' ');
  text_ += bracket;
}

void JsonWriter::write(std::string_view text) {
  item();
  quote(text);
}

void JsonWriter::write(double value) {
  if (!std::isfinite(value)) return write_null();
  append_exact(value, item());
}

void JsonWriter::write(const std::vector<double>& values, double rounding) {
  open_array(Items::side_by_side);
  const Decimals decimals = Decimals::within(rounding);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) text_ += ", ";
    if (std::isfinite(values[k]))
      decimals.append_exact(values[k], text_);
    else
      text_ += "null";
  }
  close_array();
}

std::string JsonWriter::take() {
  text_ += '\n';
  return std::move(text_);
}

}  // namespace loadpath::exports
