// Fields set on the command line: `--set shaft.d="45 mm"`, which replace those of the file.
#pragma once

#include "lib/project/project.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/toml/tree.hpp"

#include <string>
#include <vector>

namespace loadpath::cli {

using Settings = std::vector<std::string>;  // "shaft.d=45 mm", as typed

/// The content of a setting: the path to a field, and its value as in a file.
struct Setting {
  struct Part {
    std::string key;  // "links"; of an element that is counted "[2]"
    Place place;
  };
  std::vector<Part> path;
  std::string text;  // text of the value, as typed
  Place place;       // place of the value
};

/// A setting without its value's meaning; an issue if it is none. `line`: which one it is, from 1.
Setting read_setting(const std::string& text, int line, std::vector<Issue>& issues);

/// "45 mm" is a text, "1.4" a number unless the field is a word, and text that starts with a quote or a bracket is
/// TOML.
toml::Tree value_of(const Setting& setting, bool is_word, std::vector<Issue>& issues);

/// The value that a setting would replace; null if there is none, with an issue.
const toml::Tree* find_set(toml::Tree& project, const Setting& setting, std::vector<Issue>& issues);

/// Puts all of them into a project. An unknown step is an issue; the reader reports unknown fields.
void put_settings(toml::Tree& project, const Settings& settings, std::vector<Issue>& issues);

/// A project from its file and the command line; its heading lists the settings of the latter.
project::Project read_set(std::string_view text, const std::string& file, const Settings& settings,
                          std::vector<Issue>& issues, project::Ranges ranges = project::Ranges::refused);

/// The source text for the places of issues about settings.
terminal::SourceText source_of(const Settings& settings);

/// "shaft.d = 45 mm, shaft.K_A = 1.4", for the heading of a report.
std::string text_of(const Settings& settings);

}  // namespace loadpath::cli
