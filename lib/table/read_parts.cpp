#include "lib/table/reader.hpp"

#include <algorithm>

namespace loadpath::table {

std::string Reader::text_of(const Tree& table, std::string_view key, const std::string& row, bool needed) {
  const auto* entry = table.find(key);
  const std::string path = row.empty() ? std::string(key) : row + "." + std::string(key);
  if (entry == nullptr) {
    if (needed) complain(table.place, path, say("'{1}' is missing", key));
    return {};
  }
  if (entry->value.type != Tree::Type::text) complain(entry->value.place, path, say("'{1}' must be a text", key));
  return entry->value.text;
}

Reader::Texts Reader::texts(const Tree& tree, const std::string& key) {
  Texts result;
  if (tree.type != Tree::Type::array) complain(tree.place, key, say("'{1}' must be an array of texts", key));
  for (const Tree& item : tree.items) {
    if (item.type != Tree::Type::text) complain(item.place, key, say("'{1}' must be an array of texts", key));
    result.push_back(item.text);
  }
  return result;
}

Reader::Texts Reader::sources(const Tree& tree, const std::string& key) {
  Texts keys = texts(tree, key);
  for (const Tree& item : tree.items) cited_.push_back({item.text, item.place});
  return keys;
}

std::vector<double> Reader::numbers(const Tree& tree, const std::string& key) {
  std::vector<double> result;
  for (const Tree& item : tree.items) {
    if (item.type == Tree::Type::number) result.push_back(item.number);
  }
  if (!result.empty() && result.size() == tree.items.size()) return result;
  const auto wrong = std::find_if(tree.items.begin(), tree.items.end(),
                                  [](const Tree& item) { return item.type != Tree::Type::number; });
  complain(wrong != tree.items.end() ? wrong->place : tree.place, key, say("'{1}' must be an array of numbers", key));
  return {};
}

void Reader::check_keys(const Tree& table, const Texts& known, const std::string& row) {
  for (const auto& entry : table.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    complain(entry.place, row.empty() ? entry.key : row + "." + entry.key, say("unknown key '{1}'", entry.key),
             did_you_mean(entry.key, known));
  }
}

void Reader::complain(const Place& place, std::string key, Message message, Message hint) {
  issues_.push_back({place, std::move(key), std::move(message), std::move(hint), Severity::error});
}

}  // namespace loadpath::table
