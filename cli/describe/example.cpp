#include "cli/describe/example.hpp"

#include "cli/describe/lines.hpp"
#include "lib/quantity/format.hpp"

#include <algorithm>

namespace loadpath::cli {

namespace {

using toml::Tree;
using Words = std::vector<std::string>;

bool is_scalar(const Tree& value) { return value.type == Tree::Type::text || value.type == Tree::Type::number; }

/// A number of the example as people write it.
std::string text_of(const Tree& value) {
  return value.type == Tree::Type::number ? format_exact(value.number) : value.text;
}

Tree read_example(const Calculator& calculator) {
  std::vector<Issue> none;
  return toml::read_toml(calculator.example, calculator.id, none);
}

bool is_step_of(const Tree& tree, std::string_view id) {
  const Tree::Entry* const named = tree.find("calculator");
  return named != nullptr && named->value.text == id;
}

/// Whether the shell has an option of this name.
bool is_flag(const Calculator& c, const std::string& key) {
  const auto groups = table_groups(c);
  const bool is_parameter = std::any_of(c.templates.begin(), c.templates.end(), [&](const Template* t) {
    return find_field(t->parameters->fields, key) != nullptr;
  });
  return is_parameter || find_field(c.input->fields, key) != nullptr || (key == "template" && !c.templates.empty()) ||
         std::find(groups.begin(), groups.end(), key) != groups.end();
}

/// A word as every shell takes it. In double quotes where that is enough: these are what users write.
std::string quoted(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-+";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  if (word.find_first_of("\"$`\\!") == std::string::npos) return "\"" + word + "\"";
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The options of a step; none where one of its values is neither text nor a number.
Words flags_of(const Calculator& calculator, const Tree& step) {
  Words flags;
  for (const Tree::Entry& entry : step.entries) {
    if (entry.key == "calculator" || entry.key == "title" || entry.key == "note") continue;
    if (!is_scalar(entry.value) || !is_flag(calculator, entry.key)) return {};
    flags.push_back("--" + entry.key + " " + quoted(text_of(entry.value)));
  }
  return flags;
}

/// The words in lines that end in a backslash, which continues a command.
std::string in_lines(std::string line, const Words& words, std::size_t width) {
  constexpr std::size_t continuation = 2;  // " \"
  std::string all;
  for (const std::string& word : words) {
    if (length_of(line) + 1 + length_of(word) + continuation > width) {
      all += line + " \\\n";
      line = "     ";
    }
    line += " " + word;
  }
  return all + line + "\n";
}

}  // namespace

Tree example_step(const Calculator& calculator) {
  for (const Tree::Entry& entry : read_example(calculator).entries) {
    if (is_step_of(entry.value, calculator.id)) return entry.value;
  }
  return {};
}

std::string as_typed(const Tree& value) {
  if (value.type != Tree::Type::text) return text_of(value);
  const bool is_literal = value.text.find_first_of("\"\\\n") != std::string::npos;
  return is_literal ? "'" + value.text + "'" : "\"" + value.text + "\"";
}

std::string shell_example(const Calculator& calculator, std::size_t width) {
  const Tree file = read_example(calculator);
  const auto is_heading = [](const Tree::Entry& entry) { return entry.key == "project"; };
  const bool has_one_step = std::count_if(file.entries.begin(), file.entries.end(), is_heading) + 1 ==
                            static_cast<std::ptrdiff_t>(file.entries.size());
  if (!has_one_step) return "";
  const Words flags = flags_of(calculator, example_step(calculator));
  const std::string_view id = calculator.id, element = calculator.element();
  const std::string command = "  loadpath " + std::string(element) + " " + std::string(id.substr(element.size() + 1));
  return flags.empty() ? "" : in_lines(command, flags, width);
}

}  // namespace loadpath::cli
