// Tables of a project's own: those that stand in its file, and those of the files that it names.
#pragma once

#include "lib/project/catalogue.hpp"
#include "lib/toml/tree.hpp"

#include <memory>
#include <string>
#include <vector>

namespace loadpath::project {

/// A file that a project is read from, beside its own.
struct NamedFile {
  std::string name;
  std::string text;  // empty where no issue points into it
};

/// Whether an entry is `[tables]`, and no step that was called so.
bool is_own_tables(const toml::Tree::Entry& entry);

/// What the steps of a project look rows up in: `[tables]` and the files of `[project] tables`, relative to the file of
/// the project, before the built-in tables. Nothing else is read. `files` are those that were.
std::shared_ptr<const table::Tables> read_own_tables(const toml::Tree& project, const std::string& file,
                                                     Catalogue catalogue, std::vector<NamedFile>& files,
                                                     std::vector<Issue>& issues);

/// A name of a row within a list of a step is looked up by the calculator, in the built-in tables alone: one of the
/// project's own is refused there.
void refuse_own_rows(const Step& step, std::vector<Issue>& issues);

}  // namespace loadpath::project
