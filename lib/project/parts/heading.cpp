#include "lib/project/parts/heading.hpp"

#include "lib/project/read/errors.hpp"
#include "lib/project/read/read_record.hpp"

#include <algorithm>
#include <array>

namespace loadpath::project {

namespace {

using toml::Tree;

constexpr std::array<HeadingKey, 15> keys_of_heading{{
    {"title", "title of the report", true},
    {"company", "company", true},
    {"project", "project or order that the calculation belongs to", true},
    {"load_case", "load case", true},
    {"number", "number of the calculation", true},
    {"revision", "revision of the calculation", true},
    {"prepared", "name of the person who prepared the calculation", true},
    {"checked", "name of the person who checked it", true},
    {"approved", "name of the person who approved it", true},
    {"date", "date of the calculation; without it that of the run", true},
    {"note", "note in the title block"},
    {"paper", "paper size of reports: \"A4\" or \"letter\""},
    {"report", "report that `loadpath run` writes, relative to this file; --report takes its place"},
    {"tables", "files with rows of the project's own, relative to this one"},
    {"sweep", "results and points of `loadpath sweep`: docs/sweeps.md"},
}};
constexpr std::array papers{"A4", "letter"};

/// The people who sign had these names in earlier files.
std::string present_name(const std::string& key) {
  constexpr std::array<std::pair<std::string_view, const char*>, 3> earlier{
      {{"author", "prepared"}, {"checker", "checked"}, {"approver", "approved"}}};
  const auto found = std::ranges::find(earlier, key, [](const auto& names) { return names.first; });
  return found == earlier.end() ? key : found->second;
}

const HeadingKey* find_key(std::string_view key) {
  const auto found = std::ranges::find_if(keys_of_heading, [&](const HeadingKey& known) { return known.key == key; });
  return found == keys_of_heading.end() ? nullptr : &*found;
}

void read_paper(const Tree::Entry& entry, const std::string& text, Project& project, std::vector<Issue>& issues) {
  if (std::find(papers.begin(), papers.end(), text) != papers.end()) {
    project.paper = text;
  } else if (!text.empty()) {
    const std::vector<std::string> names(papers.begin(), papers.end());
    add_error(issues, entry.value.place, "project.paper", say("unknown paper size '{1}'", text),
              did_you_mean(text, names, there_is(names)));
  }
}

void read_text(const Tree::Entry& entry, const std::string& key, Project& project, std::vector<Issue>& issues) {
  const std::string text = text_of(entry, "project." + entry.key, issues);
  if (key == "title")
    project.title = text;
  else if (key == "paper")
    read_paper(entry, text, project, issues);
  else if (key == "report")
    project.report = text;
  else if (std::ranges::any_of(project.meta, [&](const auto& known) { return known.first == key; }))
    add_error(issues, entry.place, "project." + entry.key, say("'{1}' is given twice, once by its earlier name", key),
              say("keep '{1}'", key));
  else
    project.meta.emplace_back(key, text);
}

}  // namespace

std::span<const HeadingKey> heading_keys() { return keys_of_heading; }

std::vector<std::string> heading_names() {
  std::vector<std::string> names;
  names.reserve(std::size(keys_of_heading));
  for (const HeadingKey& known : keys_of_heading) names.emplace_back(known.key);
  return names;
}

bool is_in_title_block(std::string_view key) {
  const HeadingKey* const known = find_key(key);
  return known != nullptr && known->in_title_block;
}

void read_heading(const Tree::Entry& entry, Project& project, std::vector<Issue>& issues) {
  if (entry.value.type != Tree::Type::table) {
    return add_error(issues, entry.place, "project",
                     say("'{1}' is a table of fields, not {2}", "project", toml::word_for(entry.value.type)));
  }
  for (const Tree::Entry& e : entry.value.entries) {
    const std::string key = present_name(e.key);
    if (find_key(key) == nullptr) {
      add_error(issues, e.place, "project." + e.key, say("'{1}' is not a valid key here", e.key),
                did_you_mean(e.key, heading_names()));
    } else if (key == "sweep") {
      read_sweep_settings(e.value, project.sweep, issues);
    } else if (key != "tables") {  // they are read before the steps
      read_text(e, key, project, issues);
    }
  }
}

}  // namespace loadpath::project
