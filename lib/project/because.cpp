#include "lib/project/because.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace loadpath::project {

namespace {

using toml::Tree;

std::vector<std::string> input_keys(const Calculator& calculator) {
  std::vector<std::string> keys;
  for (const FieldInfo& field : calculator.input->fields) keys.emplace_back(field.key);
  return keys;
}

/// Whether a text has a word that is more than a consent: "ok", "not needed" and "n/a" give no reason.
bool says_why(const std::string& text) {
  constexpr std::array<std::string_view, 24> consents{
      "ok",       "okay",       "yes", "no", "none", "not",  "needed",  "necessary",
      "required", "applicable", "n",   "a",  "fine", "good", "all",     "todo",
      "accepted", "accept",     "is",  "it", "tbd",  "na",   "ignored", "ignore"};
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c >= 0x80; };
  std::string word;
  for (const char c : text + " ") {
    if (is_letter(static_cast<unsigned char>(c))) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      if (std::ranges::find(consents, std::string_view(word)) == consents.end()) return true;
      word.clear();
    }
  }
  return false;
}

void read_justification(const Tree::Entry& entry, StepInput& input, std::vector<Issue>& issues) {
  const std::string key = input.name + ".because." + entry.key;
  const Calculator& calculator = *input.calculator;
  const FieldInfo* const meant = find_input(calculator.input->fields, entry.key);
  if (meant == nullptr && find_field_at(calculator.input->fields, entry.key) == nullptr) {
    issues.push_back(
        {entry.place, key, say("'{1}' has no input '{2}'", calculator.id, entry.key),
         did_you_mean(entry.key, input_keys(calculator), say("`loadpath describe {1}` lists them", calculator.id)),
         Severity::error});
  } else if (!is_reason(entry.value)) {
    issues.push_back({entry.value.place, key, say("a value is justified by a text of one line"),
                      say("write because.{1} = \"certificate 4711\"", entry.key), Severity::error});
  } else {
    input.because[meant == nullptr ? entry.key : meant->key] = {entry.value.text, entry.place};
  }
}

}  // namespace

bool is_reason(const Tree& tree) {
  return tree.type == Tree::Type::text && tree.text.find('\n') == std::string::npos && says_why(tree.text);
}

void read_because(const Tree& table, StepInput& input, std::vector<Issue>& issues) {
  const auto* because = table.find("because");
  if (because == nullptr) return;
  const std::string key = input.name + ".because";
  if (because->value.type != Tree::Type::table) {
    issues.push_back({because->value.place, key,
                      say("'{1}' is a table of reasons, not {2}", "because", toml::word_for(because->value.type)),
                      say("name the inputs: because = { R_e = \"certificate 4711\" }"), Severity::error});
  } else {
    for (const Tree::Entry& entry : because->value.entries) read_justification(entry, input, issues);
  }
}

const Typed* reason_for(const StepInput& input, const std::string& path) {
  for (const std::string& key : {path, path.substr(0, path.find_first_of(".["))}) {
    if (const auto found = input.because.find(key); found != input.because.end()) return &found->second;
  }
  return nullptr;
}

}  // namespace loadpath::project
