// Tables of a project's own: those in its file, and those of the files that it names.
#pragma once

#include "lib/project/catalogue.hpp"
#include "lib/toml/tree.hpp"

#include <memory>
#include <string>
#include <vector>

namespace loadpath::project {

/// A further file that a project is read from.
struct NamedFile {
  std::string name;
  std::string text;  // empty if no issue points into it
};

/// Whether an entry is `[tables]`, and no step that was called so.
bool is_own_tables(const toml::Tree::Entry& entry);

/// The tables for the rows of a project: `[tables]` and the files of `[project] tables`, relative to the file of the
/// project, before the built-in tables. Nothing else is read. `files` receives the files read.
std::shared_ptr<const table::Tables> read_own_tables(const toml::Tree& project, const std::string& file,
                                                     Catalogue catalogue, std::vector<NamedFile>& files,
                                                     std::vector<Issue>& issues);

/// The calculator looks up the name of a row within a list of a step in the built-in tables only: a row of the
/// project's own is refused there.
void refuse_own_rows(const Step& step, std::vector<Issue>& issues);

}  // namespace loadpath::project
