#include "cli/describe/short.hpp"

#include "cli/describe/example.hpp"
#include "cli/describe/lines.hpp"
#include "cli/fields/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace loadpath::cli {

namespace {

using Type = FieldInfo::Type;
using Words = std::vector<std::string>;

/// How many lines each block may take.
struct LineBudget {
  std::size_t scope = 6, required = 9, usual = 9, assessed = 4, elsewhere = 3, results = 2;
  std::size_t named = 4;  // required inputs without a line of their own
};

/// A block gives cut down to `least` lines before the next one does.
struct Cut {
  std::size_t LineBudget::*part;
  std::size_t least;
};
constexpr std::array cuts{Cut{&LineBudget::usual, 6},     Cut{&LineBudget::assessed, 3}, Cut{&LineBudget::scope, 4},
                          Cut{&LineBudget::elsewhere, 2}, Cut{&LineBudget::results, 1},  Cut{&LineBudget::usual, 4},
                          Cut{&LineBudget::required, 6},  Cut{&LineBudget::assessed, 2}, Cut{&LineBudget::scope, 3},
                          Cut{&LineBudget::usual, 2},     Cut{&LineBudget::required, 2}, Cut{&LineBudget::named, 2},
                          Cut{&LineBudget::usual, 1}};

/// False where nothing can give cut.
bool narrow(LineBudget& room) {
  const auto cut = std::find_if(cuts.begin(), cuts.end(), [&](const Cut& w) { return room.*(w.part) > w.least; });
  if (cut == cuts.end()) return false;
  --(room.*(cut->part));
  return true;
}

/// An input that is shown in a line of its own: what is typed, and what it means.
struct Shown {
  std::string key, meaning;
};

std::string shown_key(const FieldInfo& field) { return field.key + std::string(field.type == Type::list ? "[]" : ""); }

std::string shown_meaning(const FieldInfo& field) {
  const std::string also = field.also_called;
  if (field.type != Type::choice) return field.doc + (also.empty() ? "" : "; or typed: " + also);
  const std::string words = words_of(field), doc = field.doc;
  return words.empty() ? doc : doc.substr(0, doc.find(": ")) + ": " + words;  // the choices once
}

/// What the inputs of a calculator are to the user.
struct Inputs {
  std::vector<Shown> required, sized, usual;
  Words rules;  // that require one of several inputs
  Words more;   // keys of the others
};

/// Whether the user has to give it: nothing else does.
bool is_required(const FieldInfo& field, void* owner) {
  const bool is_filled = *field.searched_in != '\0' || field.provider.kind != Provider::Kind::none;
  return !field.optional && !is_filled && is_missing(field, owner);
}

void add_sized(std::span<const FieldInfo> fields, const std::string& prefix, std::vector<Shown>& sized) {
  for (const FieldInfo& field : fields) {
    if (field.has_fields()) add_sized(field.fields, prefix + shown_key(field) + ".", sized);
    if (*field.searched_in == '\0') continue;
    const std::string cut = std::string("\"?\"") + (field.sought_unasked ? " or omitted: from " : ": from ");
    sized.push_back({prefix + field.key, cut + field.searched_in + "; " + field.doc});
  }
}

/// The rows of tables that fill inputs: "material".
void add_groups(const Calculator& calculator, std::vector<Shown>& usual) {
  for (const std::string& group : table_groups(calculator)) {
    Words filled;
    for (const FieldInfo& field : calculator.input->fields) {
      if (field.provider.kind == Provider::Kind::table && field.provider.table == group) filled.emplace_back(field.key);
    }
    std::string keys;
    for (const std::string& key : filled) keys += (keys.empty() ? "" : ", ") + key;
    usual.push_back({group, "fills " + keys + " (`loadpath tables`)"});
  }
}

/// Rules that a blank input breaks, and that say what to give.
Words asking_rules(const Calculator& calculator, const void* blank) {
  Words texts;
  for (std::size_t i = 0; i < calculator.rules.size(); ++i) {
    const std::string_view text = calculator.rules[i].text;
    if (!calculator.holds(i, blank) && text.find("give") != std::string_view::npos) texts.emplace_back(text);
  }
  return texts;
}

Inputs inputs_of(const Calculator& calculator) {
  Inputs inputs;
  const Record blank(*calculator.input);
  const toml::Tree example = example_step(calculator);
  inputs.rules = asking_rules(calculator, blank.data.get());
  add_sized(calculator.input->fields, "", inputs.sized);
  std::vector<Shown> others;
  for (const FieldInfo& field : calculator.input->fields) {
    const bool is_sized = *field.searched_in != '\0';
    if (is_sized) continue;
    const Shown shown{shown_key(field), shown_meaning(field)};
    if (is_required(field, blank.data.get()))
      inputs.required.push_back(shown);
    else if (example.find(field.key) != nullptr)
      inputs.usual.push_back(shown);
    else
      inputs.more.emplace_back(field.key);
  }
  add_groups(calculator, inputs.usual);
  return inputs;
}

void append(Lines& lines, const Lines& more) { lines.insert(lines.end(), more.begin(), more.end()); }

std::size_t key_width(const std::vector<Shown>& rows, std::size_t count) {
  std::size_t width = 0;
  for (std::size_t i = 0; i < count; ++i) width = std::max(width, length_of(rows[i].key));
  return width;
}

/// Rows with their meanings, in lines of their own; those behind the first `most` are left to `rest`.
Lines rows_of(const char* label, const std::vector<Shown>& rows, std::size_t most, Words& rest) {
  const bool all = rows.size() <= most;
  const std::size_t count = std::min(rows.size(), most), width = std::min<std::size_t>(key_width(rows, count), 24);
  Lines lines;
  for (std::size_t i = 0; i < count; ++i) {
    std::string line = i == 0 ? label : "";
    line.resize(label_width, ' ');
    line += rows[i].key + std::string(std::max(width, length_of(rows[i].key)) - length_of(rows[i].key) + 2, ' ');
    lines.push_back(line + shortened(rows[i].meaning, screen_width - length_of(line)));
  }
  for (std::size_t i = count; i < rows.size() && !all; ++i) rest.push_back(rows[i].key);
  return lines;
}

/// Required inputs without a line of their own, with their meanings if these fit.
Lines named_lines(const std::string& label, const Inputs& inputs, const Words& rest, std::size_t most) {
  constexpr std::size_t enough = 40;
  if (rest.empty()) return {};
  std::string all;
  for (const Shown& row : inputs.required) {
    if (std::find(rest.begin(), rest.end(), row.key) == rest.end()) continue;
    all += (all.empty() ? "" : "; ") + row.key + " " + shortened(row.meaning, enough);
  }
  Lines lines = labelled(label, all);
  return lines.size() <= most ? lines : listed(label, rest, ", ", 2, "");
}

/// Required inputs, and the rules that require one of several, while there is room.
Lines required_lines(const Inputs& inputs, const LineBudget& room) {
  const std::size_t most = room.required;
  Words rest;
  Lines lines = rows_of("Required", inputs.required, most, rest);
  append(lines, named_lines(lines.empty() ? "Required" : "", inputs, rest, room.named));
  std::size_t left = most > inputs.required.size() + 2 ? most - inputs.required.size() : 2;
  for (const std::string& rule : inputs.rules) {
    const Lines text = labelled(lines.empty() ? "Required" : "", rule);
    if (text.size() > left) continue;  // --full shows all
    left -= text.size();
    append(lines, text);
  }
  return lines;
}

Lines input_lines(const Calculator& calculator, const LineBudget& room) {
  const Inputs inputs = inputs_of(calculator);
  Lines lines = required_lines(inputs, room);
  Words more = inputs.more;
  constexpr std::size_t most_sized = 3;
  append(lines, rows_of("Sized", inputs.sized, most_sized, more));
  append(lines, rows_of("Usual", inputs.usual, room.usual, more));
  if (!calculator.templates.empty()) {
    Words names;
    for (const Template* t : calculator.templates) names.emplace_back(t->id);
    append(lines, listed("Templates", names, ", ", 2, ""));
  }
  const std::string id = calculator.id;
  if (!more.empty())
    append(lines, labelled("Also", std::to_string(more.size()) + (more.size() == 1 ? " more input" : " more inputs") +
                                       ": --full, or: loadpath describe " + id + " FIELD"));
  return lines;
}

Lines result_lines(const Calculator& calculator, std::size_t most) {
  Words keys;
  if (calculator.result != nullptr) {
    for (const FieldInfo& field : calculator.result->fields) {
      if (field.role == Role::result) keys.push_back(shown_key(field));
    }
  }
  const auto add_patterns = [&](bool loads) {  // the loads on other parts first
    for (const ResultPattern& pattern : calculator.patterns()) {
      const bool is_new = std::find(keys.begin(), keys.end(), pattern.path) == keys.end();
      if (pattern.is_load == loads && is_new) keys.emplace_back(pattern.path);
    }
  };
  add_patterns(true);
  add_patterns(false);
  return listed("Results", keys, ", ", most, "");
}

/// A title without its explanations.
std::string short_title(const ModeInfo& mode) {
  const std::string title = mode.title;
  return title.substr(0, title.find(" ("));
}

/// A title among others that commas divide: "pitting, gear 1" as "pitting (gear 1)".
std::string listed_title(const ModeInfo& mode) {
  const std::string title = short_title(mode);
  const std::size_t comma = title.find(", ");
  return comma == std::string::npos ? title : title.substr(0, comma) + " (" + title.substr(comma + 2) + ")";
}

/// The inputs without which the checks of a mode do not exist: "tau_adm".
std::string asked_by(const Calculator& calculator, const ModeInfo& mode) {
  std::string inputs;
  for (const std::string& check : listed_keys(mode.checks)) {
    const FieldInfo* const field =
        calculator.result == nullptr ? nullptr : find_field(calculator.result->fields, check);
    if (field == nullptr || *field->asked_by == '\0' || inputs.find(field->asked_by) != std::string::npos) continue;
    inputs += (inputs.empty() ? "" : ", ") + std::string(field->asked_by);
  }
  return inputs.empty() ? mode.wants : inputs;
}

/// The calculator that assesses a mode which this one does not; empty where it is assessed here, or nowhere.
std::string elsewhere(const ModeInfo& mode) {
  if (*mode.checks != '\0' || *mode.wants != '\0') return "";
  return *mode.judge != '\0' ? mode.judge : *mode.use != '\0' ? mode.use : mode.add;
}

Lines assessed_lines(const Calculator& calculator, std::size_t most) {
  Words titles;
  for (const ModeInfo& mode : calculator.modes) {
    if (*mode.checks == '\0' && *mode.wants == '\0') continue;
    const std::string inputs = asked_by(calculator, mode);
    titles.push_back(short_title(mode) + (inputs.empty() ? "" : " (" + inputs + ")"));
  }
  return listed("Assesses", titles, "; ", most, ": modes");
}

/// "fatigue, deflection, 2 more -> shaft.design"
std::string group_of(const Words& titles, const std::string& where, std::size_t most) {
  std::string all;
  for (std::size_t i = 0; i < std::min(titles.size(), most); ++i) all += (i == 0 ? "" : ", ") + titles[i];
  if (titles.size() > most) all += ", " + std::to_string(titles.size() - most) + " more";
  return all + " -> " + where;
}

using Groups = std::vector<std::pair<std::string, Words>>;

/// Modes by the calculator that assesses them, then those that none does.
Groups groups_elsewhere(const Calculator& calculator) {
  Groups groups;
  Words outside;
  for (const ModeInfo& mode : calculator.modes) {
    const std::string where = elsewhere(mode);
    if (!is_assessable(mode)) outside.push_back(listed_title(mode));
    if (where.empty()) continue;
    const auto is_same = [&](const auto& group) { return group.first == where; };
    auto group = std::find_if(groups.begin(), groups.end(), is_same);
    if (group == groups.end()) group = groups.insert(group, {where, {}});
    group->second.push_back(listed_title(mode));
  }
  if (!outside.empty()) groups.emplace_back("by hand", outside);
  return groups;
}

/// As many titles of each calculator as let all calculators be named.
Lines elsewhere_lines(const Calculator& calculator, std::size_t most) {
  const Groups groups = groups_elsewhere(calculator);
  Lines lines;
  for (std::size_t titles = 3; titles > 0; --titles) {
    Words texts;
    for (const auto& group : groups) texts.push_back(group_of(group.second, group.first, titles));
    lines = listed("Not here", texts, "; ", titles == 1 ? most : screen_lines, ": modes");
    if (lines.size() <= most) break;
  }
  return lines;
}

Lines example_lines(const Calculator& calculator) {
  constexpr std::ptrdiff_t most = 4;
  const std::string command = shell_example(calculator, screen_width);
  const auto count = std::count(command.begin(), command.end(), '\n');
  Lines lines{""};
  if (count > 0 && count <= most) {
    lines.emplace_back("Example");
    for (std::size_t from = 0; from < command.size();) {
      const std::size_t end = command.find('\n', from);
      lines.push_back(command.substr(from, end - from));
      from = end + 1;
    }
  }
  const std::string id = calculator.id, file = "describe " + id + " --toml prints a project that runs";
  lines.push_back("In a file: " + std::string(length_of(file) + 20 <= screen_width ? "loadpath " : "") + file);
  return lines;
}

Lines short_lines(const Calculator& calculator, const LineBudget& room) {
  const std::string id = calculator.id;
  Lines lines{id + "  " + calculator.title};
  append(lines, sentences(calculator.scope, room.scope));
  append(lines, sentences("Source " + std::string(calculator.source), 2));
  lines.emplace_back();
  append(lines, input_lines(calculator, room));
  append(lines, result_lines(calculator, room.results));
  append(lines, assessed_lines(calculator, room.assessed));
  append(lines, elsewhere_lines(calculator, room.elsewhere));
  append(lines, example_lines(calculator));
  return lines;
}

}  // namespace

std::string short_form(const Calculator& calculator) {
  LineBudget room;
  Lines lines = short_lines(calculator, room);
  while (lines.size() > screen_lines && narrow(room)) lines = short_lines(calculator, room);
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

}  // namespace loadpath::cli
