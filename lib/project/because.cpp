#include "lib/project/because.hpp"

#include <algorithm>
#include <cctype>

namespace loadpath::project {

namespace {

using toml::Tree;

std::vector<std::string> input_keys(const Calculator& calculator) {
  std::vector<std::string> keys;
  for (const FieldInfo& field : calculator.input->fields) keys.emplace_back(field.key);
  return keys;
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
  const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0 || c >= 0x80; };
  return tree.type == Tree::Type::text && tree.text.find('\n') == std::string::npos &&
         std::any_of(tree.text.begin(), tree.text.end(), is_word);
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
