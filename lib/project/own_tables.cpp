#include "lib/project/own_tables.hpp"

#include "lib/table/own/own.hpp"
#include "lib/table/tables.hpp"
#include "lib/toml/gate.hpp"

#include <algorithm>
#include <filesystem>

namespace loadpath::project {

namespace {

namespace fs = std::filesystem;
using toml::Tree;

constexpr std::size_t most_files = 100;

/// The groups whose rows a step can name.
std::vector<std::string> named_groups(Catalogue catalogue) {
  std::vector<std::string> groups;
  for (const CatalogueEntry& entry : catalogue) {
    for (std::string& group : table_groups(*entry.calculator)) {
      if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(std::move(group));
    }
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

void add(std::vector<Issue>& issues, const Place& place, Message message, Message hint) {
  issues.push_back({place, "project.tables", std::move(message), std::move(hint), Severity::error});
}

/// Why a file cannot be read, before it is tried: a device has no end.
Message why_not(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return say("no file '{1}'", path.string());
  if (!fs::is_regular_file(path, error)) return say("'{1}' is not a text file", path.string());
  if (fs::file_size(path, error) > toml::largest_file)
    return say("'{1}' is larger than 4 MiB, which no table needs", path.string());
  return {};
}

/// The text of a file that the project names; nothing, and an issue, if it cannot be read.
bool read_named(const Tree& named, const std::string& project, NamedFile& file, std::vector<Issue>& issues) {
  if (named.type != Tree::Type::text || named.text.empty()) {
    add(issues, named.place, say("'{1}' must be an array of texts", "tables"), say("write tables = [\"own.toml\"]"));
    return false;
  }
  const fs::path path = fs::path(project).parent_path() / named.text;
  file.name = path.string();
  Message why = why_not(path);
  if (why.empty() && !toml::read_file(file.name, file.text)) why = say("cannot read '{1}'", file.name);
  if (why.empty()) return true;
  add(issues, place_in(named.place, named.text, 0, named.text.size()), std::move(why),
      say("a path is relative to the project file"));
  return false;
}

const Tree* named_files(const Tree& project, std::vector<Issue>& issues) {
  const auto* heading = project.find("project");
  const auto* tables = heading == nullptr ? nullptr : heading->value.find("tables");
  if (tables == nullptr) return nullptr;
  if (tables->value.type == Tree::Type::array && tables->value.items.size() <= most_files) return &tables->value;
  if (tables->value.type != Tree::Type::array) {
    add(issues, tables->value.place, say("'{1}' must be an array of texts", "tables"),
        say("write tables = [\"own.toml\"]"));
  } else {
    add(issues, tables->value.place, say("a project names at most {1} files", std::to_string(most_files)), {});
  }
  return nullptr;
}

}  // namespace

void refuse_own_rows(const Step& step, std::vector<Issue>& issues) {
  if (!step.input().tables->has_own_rows()) return;
  for_each_leaf(step.input().reading.record, [&](const std::string& path, const Leaf& leaf) {
    const FieldInfo& field = *leaf.field;
    if (field.type != FieldInfo::Type::name && field.type != FieldInfo::Type::formula) return;
    const std::string name(field.text(leaf.owner));
    if (name.empty() || !step.input().tables->is_own(field.key, name)) return;
    issues.push_back(issue_at(step.input(), path,
                              say("'{1}' is a {2} of the project, but '{3}' takes only those of the program", name,
                                  field.key, step.input().calculator->id),
                              say("give its sizes")));
  });
}

bool is_own_tables(const Tree::Entry& entry) {
  return entry.key == "tables" && entry.value.find("calculator") == nullptr;
}

std::shared_ptr<const table::Tables> read_own_tables(const Tree& project, const std::string& file, Catalogue catalogue,
                                                     std::vector<NamedFile>& files, std::vector<Issue>& issues) {
  table::Library own;
  const std::vector<std::string> groups = named_groups(catalogue);
  table::OwnReader reader(own, groups, issues);
  const auto* tables = project.find("tables");
  if (tables != nullptr && is_own_tables(*tables)) reader.read_tables(*tables);
  if (const Tree* named = named_files(project, issues)) {
    for (const Tree& item : named->items) {
      NamedFile& next = files.emplace_back();
      if (read_named(item, file, next, issues)) reader.read_file(next.text, next.name);
    }
  }
  return std::make_shared<const table::Tables>(std::move(own), groups);
}

}  // namespace loadpath::project
