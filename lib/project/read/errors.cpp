#include "lib/project/read/errors.hpp"

namespace loadpath::project {

void add_error(std::vector<Issue>& issues, const Place& place, const std::string& key, Message message, Message hint) {
  issues.push_back({place, key, std::move(message), std::move(hint), Severity::error});
}

std::string text_of(const toml::Tree::Entry& entry, const std::string& key, std::vector<Issue>& issues) {
  if (entry.value.type == toml::Tree::Type::text) return entry.value.text;
  add_error(issues, entry.value.place, key, say("'{1}' takes a text, not {2}", key, toml::word_for(entry.value.type)));
  return {};
}

}  // namespace loadpath::project
