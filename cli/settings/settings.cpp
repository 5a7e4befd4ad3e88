#include "cli/settings/settings.hpp"

#include "calculators/catalogue.hpp"
#include "lib/project/solving/read_project.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace loadpath::cli {

namespace {

using toml::Tree;
using Part = Setting::Part;

constexpr const char* source = "--set";

void add(std::vector<Issue>& issues, const Place& place, Message message, Message hint = {}) {
  issues.push_back({place, "", std::move(message), std::move(hint), Severity::error});
}

/// "links.crank", "pieces[2]", `materials."IPE 330"` in parts; nothing if one is empty.
std::vector<Part> parts_of(std::string_view path, int line) {
  std::vector<Part> parts;
  for (std::size_t at = 0; at <= path.size();) {
    const bool quoted = at < path.size() && path[at] == '"';
    const std::size_t from = quoted ? at + 1 : at;
    const std::size_t to = std::min(quoted ? path.find('"', from) : path.find_first_of(".[", from + 1), path.size());
    std::string key(path.substr(std::min(from, path.size()), to - std::min(from, path.size())));
    parts.push_back({key, {source, line, static_cast<int>(from) + 1, std::max(1, static_cast<int>(key.size()))}});
    at = to + (quoted ? 1 : 0);
    if (key.empty() || key[0] == '.' || key.find('"') != std::string::npos) return {};
    if (at >= path.size()) break;
    if (path[at] == '.') ++at;
  }
  return parts;
}

/// The number of a counted element, from 1; 0 if the part is a name.
std::size_t number_of(const Part& part) {
  if (part.key.size() < 3 || part.key.front() != '[' || part.key.back() != ']') return 0;
  std::size_t number = 0;
  for (const char c : part.key.substr(1, part.key.size() - 2)) {
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 || number > 1'000'000) return 0;
    number = number * 10 + static_cast<std::size_t>(c - '0');
  }
  return number;
}

std::string name_of(const Tree& element) {
  const Tree::Entry* const name = element.find("name");
  return name == nullptr ? "" : name->value.text;
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// The element of a list: by its number, or the name that it has.
Tree* element_of(Tree& list, const Part& part, std::vector<Issue>& issues) {
  const std::size_t number = number_of(part);
  if (number >= 1 && number <= list.items.size()) return &list.items[number - 1];
  std::vector<std::string> names;
  for (Tree& item : list.items) {
    if (number == 0 && name_of(item) == part.key) return &item;
    if (!name_of(item).empty()) names.push_back(name_of(item));
  }
  Message counted = say("elements are counted from 1: [1] to [{1}]", std::to_string(list.items.size()));
  if (!names.empty() && part.key.front() == '[')
    counted = say("elements are counted from 1, [1] to [{1}], or named: {2}", std::to_string(list.items.size()),
                  listed(names));
  const bool is_name = !names.empty() && part.key.front() != '[';
  add(issues, part.place, say("unknown element '{1}'", part.key),
      is_name ? did_you_mean(part.key, names, there_is(names)) : std::move(counted));
  return nullptr;
}

Tree* entry_of(Tree& table, const std::string& key) {
  const auto found =
      std::find_if(table.entries.begin(), table.entries.end(), [&](const Tree::Entry& e) { return e.key == key; });
  return found == table.entries.end() ? nullptr : &found->value;
}

/// "shaft.pieces[2]": the path down to this part.
std::string path_to(const Setting& setting, std::size_t last) {
  std::string path;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::string& key = setting.path[i].key;
    path += (path.empty() || key.front() == '[' ? "" : ".") + key;
  }
  return path;
}

/// The table that the last part of a path is a key of, made where it is not there; null with an issue.
Tree* holder_of(Tree& project, const Setting& setting, std::vector<Issue>& issues) {
  Tree* at = &project;
  for (std::size_t i = 0; i + 1 < setting.path.size(); ++i) {
    const Part& part = setting.path[i];
    if (at->type == Tree::Type::array) {
      at = element_of(*at, part, issues);
    } else if (Tree* const known = entry_of(*at, part.key)) {
      at = known;
    } else {
      Tree table;
      table.place = part.place;
      at->entries.push_back({part.key, part.place, std::move(table)});
      at = &at->entries.back().value;
    }
    if (at == nullptr) return nullptr;
    if (at->type != Tree::Type::table && at->type != Tree::Type::array) {
      add(issues, part.place, say("'{1}' is {2}, and has no fields", part.key, toml::word_for(at->type)),
          say("set the value itself: --set {1}=VALUE", path_to(setting, i)));
      return nullptr;
    }
  }
  return at;
}

/// Whether a field takes a word even where that looks like a number: a name of a row, a title.
bool is_word(const Tree& project, const Setting& setting) {
  const std::string& step = setting.path.front().key;
  const std::string& key = setting.path[1].key;
  if (step == "project") return key != "sweep";
  if (key == "title" || key == "note" || key == "accept" || key == "because") return true;
  const Tree::Entry* const table = project.find(step);
  const Tree::Entry* const id = table == nullptr ? nullptr : table->value.find("calculator");
  const Calculator* const calculator = id == nullptr ? nullptr : find_calculator(calculators(), id->value.text);
  if (calculator == nullptr) return false;
  const auto groups = table_groups(*calculator);
  if (std::find(groups.begin(), groups.end(), key) != groups.end()) return true;
  std::string path;
  for (std::size_t i = 1; i < setting.path.size(); ++i) {
    const std::string& part = setting.path[i].key;
    path += (path.empty() || part.front() == '[' ? "" : ".") + part;
  }
  const FieldInfo* const field = find_field_at(calculator->input->fields, path);
  return field != nullptr && field->is_word();
}

/// The remedy for a path that begins with a field in place of its step, and for a step that does not exist.
Message step_hint(const Tree& project, const std::string& key, const std::vector<std::string>& names) {
  if (names.empty()) return say("the file has no steps");
  for (const Tree::Entry& step : project.entries) {
    if (step.value.type == Tree::Type::table && step.value.find(key) != nullptr)
      return say("write the step before the field: {1}.{2}", step.key, key);
  }
  return did_you_mean(key, names, there_is(names));
}

/// Whether the table of a setting exists: one of the steps, or of the other tables.
bool has_table(const Tree& project, const Part& part, std::vector<Issue>& issues) {
  if (part.key == "project" || project.find(part.key) != nullptr) return true;
  std::vector<std::string> names;
  for (const Tree::Entry& entry : project.entries) {
    if (entry.key != "expect") names.push_back(entry.key);
  }
  add(issues, part.place, say("unknown step '{1}'", part.key), step_hint(project, part.key, names));
  return false;
}

void put_setting(Tree& project, const Setting& setting, std::vector<Issue>& issues) {
  if (!has_table(project, setting.path.front(), issues)) return;
  Tree value = value_of(setting, is_word(project, setting), issues);
  Tree* const holder = holder_of(project, setting, issues);
  if (holder == nullptr) return;
  const Part& last = setting.path.back();
  if (holder->type == Tree::Type::array) {
    if (Tree* const element = element_of(*holder, last, issues)) *element = std::move(value);
  } else if (Tree* const known = entry_of(*holder, last.key)) {
    *known = std::move(value);
  } else {
    holder->entries.push_back({last.key, last.place, std::move(value)});
  }
}

/// Shifts places after "value = " to those of the setting.
void move_to(const Place& start, int by, Tree& tree) {
  const auto move = [&](Place& place) {
    place = {start.file, start.line, std::max(1, place.column + by), place.length};
  };
  move(tree.place);
  for (Tree& item : tree.items) move_to(start, by, item);
  for (Tree::Entry& entry : tree.entries) {
    move(entry.place);
    move_to(start, by, entry.value);
  }
}

}  // namespace

Setting read_setting(const std::string& text, int line, std::vector<Issue>& issues) {
  const std::size_t equals = std::min(text.find('='), text.size());
  Setting setting;
  std::string path = text.substr(0, equals);
  while (path.ends_with(' ')) path.pop_back();
  setting.path = parts_of(path, line);
  std::size_t from = std::min(equals + 1, text.size());
  while (from < text.size() && text[from] == ' ') ++from;
  setting.text = text.substr(from);
  setting.place = {source, line, static_cast<int>(from) + 1, std::max(1, static_cast<int>(setting.text.size()))};
  if (equals == text.size() || setting.path.size() < 2) {
    add(issues, {source, line, 1, std::max(1, static_cast<int>(path.size()))},
        say("'{1}' sets no field of a step", text),
        say("write --set STEP.FIELD=VALUE, as in --set shaft.d=\"45 mm\", or --set 'shaft.pieces[1].d=45 mm' for an "
            "element of a list"));
    setting.path.clear();
  }
  return setting;
}

Tree value_of(const Setting& setting, bool is_word, std::vector<Issue>& issues) {
  Tree value;
  value.type = Tree::Type::text;
  value.text = setting.text;
  value.place = setting.place;
  const std::string_view text = setting.text;
  const bool written = !text.empty() && std::string_view("\"'[{").find(text[0]) != std::string_view::npos;
  const bool digits =
      !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) != 0 || text[0] == '-' || text[0] == '+');
  if (!written && (is_word || !digits)) return value;
  constexpr std::string_view key = "value = ";
  std::vector<Issue> wrong;
  Tree tree = toml::read_toml(std::string(key) + setting.text, source, wrong);
  if (has_errors(wrong) || tree.entries.size() != 1) {
    if (!written) return value;
    const int shift = setting.place.column - 1 - static_cast<int>(key.size());
    for (Issue& issue : wrong) {
      issue.place.line = setting.place.line;
      issue.place.column = std::max(1, issue.place.column + shift);
      issues.push_back(std::move(issue));
    }
    if (wrong.empty()) add(issues, setting.place, say("'{1}' is not a single value", setting.text));
    return value;
  }
  if (!written && tree.entries[0].value.type != Tree::Type::number) return value;
  move_to(setting.place, setting.place.column - 1 - static_cast<int>(key.size()), tree.entries[0].value);
  return std::move(tree.entries[0].value);
}

const Tree* find_set(Tree& project, const Setting& setting, std::vector<Issue>& issues) {
  if (!has_table(project, setting.path.front(), issues)) return nullptr;
  Tree* const holder = holder_of(project, setting, issues);
  if (holder == nullptr) return nullptr;
  const Part& last = setting.path.back();
  if (holder->type == Tree::Type::array) return element_of(*holder, last, issues);
  if (const Tree* const known = entry_of(*holder, last.key)) return known;
  std::vector<std::string> keys;
  for (const Tree::Entry& entry : holder->entries) keys.push_back(entry.key);
  add(issues, last.place, say("'{1}' is not a valid key here", last.key), did_you_mean(last.key, keys, there_is(keys)));
  return nullptr;
}

void put_settings(Tree& project, const Settings& settings, std::vector<Issue>& issues) {
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Setting setting = read_setting(settings[i], static_cast<int>(i) + 1, issues);
    if (!setting.path.empty()) put_setting(project, setting, issues);
  }
}

project::Project read_set(std::string_view text, const std::string& file, const Settings& settings,
                          std::vector<Issue>& issues, project::Ranges ranges) {
  Tree tree = toml::read_toml(text, file, issues);
  if (has_errors(issues)) return {};
  put_settings(tree, settings, issues);
  if (has_errors(issues)) return {};
  project::Project project = project::read_project(tree, file, catalogue(), issues, ranges);
  if (!settings.empty()) project.meta.emplace_back("set", text_of(settings));
  return project;
}

terminal::SourceText source_of(const Settings& settings) {
  std::string text;
  for (std::string line : settings) {
    std::replace(line.begin(), line.end(), '\n', ' ');
    text += line + "\n";
  }
  return {source, std::move(text)};
}

std::string text_of(const Settings& settings) {
  std::string all;
  for (const std::string& setting : settings) {
    std::vector<Issue> none;
    std::string path = setting.substr(0, setting.find('='));
    while (path.ends_with(' ')) path.pop_back();
    all += (all.empty() ? "" : ", ") + path + " = " + read_setting(setting, 1, none).text;
  }
  return all;
}

}  // namespace loadpath::cli
