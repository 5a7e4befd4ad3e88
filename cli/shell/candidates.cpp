#include "cli/shell/candidates.hpp"

#include "calculators/catalogue.hpp"
#include "cli/files/starters.hpp"
#include "lib/calculator/choice_words.hpp"
#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <array>

namespace loadpath::cli {

namespace {

using Words = std::vector<std::string>;

void add(Candidates& all, std::string word, std::string meaning = {}) {
  all.words.push_back({std::move(word), std::move(meaning)});
}

void add_calculators(Candidates& all) {
  for (const Calculator* c : calculators()) {
    add(all, c->id, c->title);
    for (const Template* t : c->templates) add(all, std::string(c->id) + "." + t->id, t->title);
  }
}

void add_elements(Candidates& all) {
  std::string last;
  for (const Calculator* c : calculators()) {
    if (c->element() != last) add(all, last = c->element());
  }
}

/// Names that `describe` takes after a calculator: inputs, results, failure modes.
void add_fields(const std::string& id, Candidates& all) {
  const Calculator* const calculator = find_calculator(calculators(), id);
  if (calculator == nullptr) return;
  for (const FieldInfo& field : calculator->input->fields) add(all, field.key, field.doc);
  for (const ModeInfo& mode : calculator->modes) add(all, mode.id, mode.title);
  if (calculator->result == nullptr) return;
  for (const FieldInfo& field : calculator->result->fields) add(all, field.key, field.doc);
}

/// Adds the rows of a group: materials, sections.
void add_rows(const std::string& group, Candidates& all) {
  for (const table::Table& table : table::built_in().tables) {
    if (table.group != group) continue;
    for (const table::Row& row : table.rows) add(all, row.name, row.standard);
  }
}

void add_tables(const Words& given, Candidates& all) {
  std::string last;
  for (const table::Table& table : table::built_in().tables) {
    const std::string folder = table.name.substr(0, table.name.find('/'));
    if (given.empty()) {
      if (folder != last) add(all, last = folder);
      add(all, table.name, table.title);
    } else if (given[0] == folder || given[0] == table.name) {
      for (const table::Row& row : table.rows) add(all, row.name, row.standard);
    }
  }
}

/// Steps of a project, and behind a step's name with a point its results and failure modes.
void add_steps(const std::string& file, const std::string& begun, Candidates& all) {
  std::string text;
  if (!toml::read_file(file, text)) return;
  std::vector<Issue> issues;
  const project::Project project = project::read_project(text, file, catalogue(), issues, project::Ranges::taken);
  const std::string name = begun.substr(0, begun.find('.'));
  for (const auto& step : project.steps) {
    const Calculator& c = *step->input().calculator;
    add(all, step->name(), c.title);
    if (begun.find('.') == std::string::npos || step->name() != name) continue;
    for (const ModeInfo& mode : c.modes) add(all, name + "." + mode.id, mode.title);
    if (c.result == nullptr) continue;
    for (const FieldInfo& field : c.result->fields) add(all, name + "." + field.key, field.doc);
  }
}

/// Adds values for the placeholder of a calculator's flag: "yes | no"; rows of a table.
bool add_values(const std::string& id, const std::string& flag, Candidates& all) {
  const Calculator* const calculator = find_calculator(calculators(), id);
  if (calculator == nullptr) return false;
  const auto groups = table_groups(*calculator);
  if (std::find(groups.begin(), groups.end(), flag) != groups.end()) add_rows(flag, all);
  if (flag == "template") {
    for (const Template* t : calculator->templates) add(all, t->id, t->title);
  }
  if (flag == "accept") {
    for (const ModeInfo& mode : calculator->modes) add(all, std::string(mode.id) + "=", mode.title);
  }
  if (flag == "because") {
    for (const FieldInfo& field : calculator->input->fields) add(all, std::string(field.key) + "=", field.doc);
  }
  for (const FieldInfo& field : calculator->input->fields) {
    if (field.key != flag) continue;
    for (const std::string& word : words_to_type(field)) add(all, word);
  }
  return true;
}

constexpr std::array takes_file{"--report", "--csv", "--svg", "--dxf", "--file", "--out", "--hdf5", "--merge"};
constexpr std::array reads_project{"run", "sweep", "why", "verify", "watch", "diff", "fmt"};

template <class List>
bool holds(const List& list, const std::string& word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

/// A command line up to the word that is begun.
class Line {
 public:
  Line(CommandLine& line, Words words) : line_(line), begun_(std::move(words.back())) {
    words.pop_back();
    for (const std::string& word : words) read(word);
  }

  [[nodiscard]] Candidates candidates() {
    Candidates all;
    if (const CLI::Option* option = waiting())
      add_values_of(*option, all);
    else if (begun_.starts_with('-'))
      add_options(all);
    else
      add_words(all);
    std::erase_if(all.words, [&](const Candidate& c) { return !c.word.starts_with(begun_); });
    return all;
  }

 private:
  void read(const std::string& word) {
    if (word == "=") return;  // bash takes --report=r.html for three words
    if (waiting() != nullptr) return last_.clear();
    if (word.starts_with("--")) {
      last_ = word.find('=') == std::string::npos ? word : "";
      return;
    }
    CLI::App* const sub = given_.empty() ? subcommand(word) : nullptr;
    if (sub == nullptr) return given_.push_back(word);
    path_.push_back(sub);
    line_.set_up(*sub);
  }

  [[nodiscard]] CLI::App* subcommand(const std::string& word) const {
    const auto found = command()->get_subcommands([&](CLI::App* sub) { return sub->get_name() == word; });
    return found.empty() ? nullptr : found.front();
  }
  [[nodiscard]] CLI::App* command() const { return path_.empty() ? &line_.app : path_.back(); }

  /// The option whose value comes next; null if none does.
  [[nodiscard]] const CLI::Option* waiting() const {
    const CLI::Option* const option = last_.empty() ? nullptr : command()->get_option_no_throw(last_);
    return option != nullptr && option->get_expected_max() > 0 ? option : nullptr;
  }

  [[nodiscard]] std::string id() const {
    return path_.size() < 2 ? "" : path_[0]->get_name() + "." + path_[1]->get_name();
  }

  void add_values_of(const CLI::Option& option, Candidates& all) const {
    const std::string flag = option.get_lnames().empty() ? "" : option.get_lnames()[0];
    all.files = holds(takes_file, "--" + flag);
    if (flag == "detail") {
      for (const char* word : {"brief", "normal", "full"}) add(all, word);
    }
    add_values(id(), flag, all);
  }

  void add_options(Candidates& all) const {
    for (const CLI::Option* option : command()->get_options()) {
      for (const std::string& name : option->get_lnames()) add(all, "--" + name, option->get_description());
    }
  }

  void add_words(Candidates& all) const {
    const std::string name = command()->get_name();
    if (given_.empty()) {
      for (const CLI::App* sub : command()->get_subcommands([](const CLI::App*) { return true; }))
        add(all, sub->get_name(), sub->get_description());
    }
    if (path_.empty()) return;
    if (name == "describe" && given_.empty()) add_calculators(all);
    if (name == "describe" && given_.size() == 1) add_fields(given_[0], all);
    if (name == "list" && given_.empty()) add_elements(all);
    if (name == "tables" && given_.size() < 2) add_tables(given_, all);
    if (name == "completion" && given_.empty()) {
      for (const char* shell : {"bash", "zsh", "fish"}) add(all, shell);
    }
    if (name == "init" && given_.empty()) {
      for (const Starter& starter : starters()) add(all, starter.name);
    }
    if (name == "why" && given_.size() == 1) return add_steps(given_[0], begun_, all);
    all.files = holds(reads_project, name);
  }

  CommandLine& line_;
  std::string begun_;
  std::vector<CLI::App*> path_;  // the commands that are named
  Words given_;                  // words that are neither commands nor options
  std::string last_;             // an option that may wait for a value
};

}  // namespace

Candidates candidates(CommandLine& line, std::vector<std::string> words) {
  if (words.empty()) words.emplace_back();
  return Line(line, std::move(words)).candidates();
}

}  // namespace loadpath::cli
