#include "cli/files/starters.hpp"

#include "calculators/catalogue.hpp"
#include "cli/settings/settings.hpp"
#include "lib/project/layout/layout.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/text/embedded.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <tuple>

namespace loadpath::cli {

namespace {

using toml::Tree;

constexpr std::string_view folder = "reference/init/";

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.emplace_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

/// The range of a scalar in its line: for a text with its quotes.
std::pair<std::size_t, std::size_t> span_of(const Tree& value) {
  const bool quoted = value.type == Tree::Type::text;
  const auto column = static_cast<std::size_t>(value.place.column);
  return {column - (quoted ? 2 : 1), static_cast<std::size_t>(value.place.length) + (quoted ? 2 : 0)};
}

Starter starter_of(const embedded::File& file) {
  Starter starter;
  starter.name = file.name.substr(folder.size(), file.name.size() - folder.size() - std::string_view(".toml").size());
  starter.text = file.text;
  std::vector<Issue> none;
  const Tree tree = toml::read_toml(file.text, std::string(file.name), none);
  const auto lines = lines_of(file.text);
  starter.title = tree.find("project")->value.find("title")->value.text;
  for (const Tree::Entry& entry : tree.find("values")->value.entries) {
    const auto [from, length] = span_of(entry.value);
    const std::string& line = lines[static_cast<std::size_t>(entry.place.line) - 1];
    const std::size_t comment = line.find("# ", from + length);
    std::string written = line.substr(from, length);
    if (entry.value.type == Tree::Type::text) written = entry.value.text;
    starter.values.push_back({entry.key, comment == std::string::npos ? entry.key : line.substr(comment + 2), written});
  }
  return starter;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out + "\"";
}

bool is_scalar(const Tree& value) { return value.type == Tree::Type::text || value.type == Tree::Type::number; }

using Change = std::tuple<int, std::pair<std::size_t, std::size_t>, std::string>;  // line, range in it, replacement

/// The changes to the text by the settings; an issue for an unknown field, or one without a single value.
std::vector<Change> changes_of(const Starter& starter, const std::vector<std::string>& settings,
                               std::vector<Issue>& issues) {
  Tree tree = toml::read_toml(starter.text, starter.name, issues);
  std::vector<Change> changes;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Setting setting = read_setting(settings[i], static_cast<int>(i) + 1, issues);
    const Tree* const old = setting.path.empty() ? nullptr : find_set(tree, setting, issues);
    if (old == nullptr) continue;
    const Tree value = value_of(setting, old->type == Tree::Type::text && setting.path[0].key != "values", issues);
    if (!is_scalar(*old)) {
      issues.push_back({setting.path.back().place, "",
                        say("'{1}' is {2}", setting.path.back().key, word_for(old->type)),
                        say("change it in the file, once it is written"), Severity::error});
      continue;
    }
    const bool bare =
        value.type == Tree::Type::text && !setting.text.starts_with('"') && !setting.text.starts_with('\'');
    changes.emplace_back(old->place.line, span_of(*old), bare ? quoted(setting.text) : setting.text);
  }
  return changes;
}

/// Issues that a reader, or the solver, has with a project.
void try_out(const Starter& starter, const std::string& file, const std::vector<std::string>& settings,
             std::vector<Issue>& issues) {
  project::Project project = read_set(starter.text, file, settings, issues);
  if (!has_errors(issues)) project::solve(project, issues, {.pictures = false, .formulas = false});
}

}  // namespace

const std::vector<Starter>& starters() {
  static const std::vector<Starter> all = [] {
    std::vector<Starter> found;
    for (const embedded::File& file : embedded::reference()) {
      if (file.name.starts_with(folder)) found.push_back(starter_of(file));
    }
    std::sort(found.begin(), found.end(), [](const Starter& a, const Starter& b) { return a.name < b.name; });
    return found;
  }();
  return all;
}

const Starter* find_starter(const std::string& name) {
  const auto found =
      std::find_if(starters().begin(), starters().end(), [&](const Starter& s) { return s.name == name; });
  return found == starters().end() ? nullptr : &*found;
}

std::vector<std::string> with_table(std::vector<std::string> settings) {
  for (std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals != std::string::npos && equals > 0 && setting.find('.') > equals) setting.insert(0, "values.");
  }
  return settings;
}

std::string filled(const Starter& starter, const std::string& file, std::vector<std::string> settings,
                   std::vector<Issue>& issues) {
  settings = with_table(std::move(settings));
  auto changes = changes_of(starter, settings, issues);
  if (!has_errors(issues)) try_out(starter, file, settings, issues);
  if (has_errors(issues)) return {};
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
    return std::pair(std::get<0>(a), std::get<1>(a)) > std::pair(std::get<0>(b), std::get<1>(b));
  });
  auto lines = lines_of(starter.text);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const auto& [line, span, by] = changes[i];
    const bool again =
        i + 1 < changes.size() && std::get<0>(changes[i + 1]) == line && std::get<1>(changes[i + 1]) == span;
    if (!again) lines[static_cast<std::size_t>(line) - 1].replace(span.first, span.second, by);  // the last counts
  }
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return project::layout_of(text, file, calculators(), issues);
}

}  // namespace loadpath::cli
