// A project open in an editor: its text, its outline, and the program's results.
#pragma once

#include "cli/lsp/text/document.hpp"
#include "cli/lsp/text/outline.hpp"
#include "lib/project/project.hpp"

#include <memory>
#include <string>
#include <vector>

namespace loadpath::cli::lsp {

struct OpenFile {
  std::string uri;
  std::string name;  // name of the file, for tables and histories that it names
  Document document;
  Outline outline;
  std::vector<Issue> issues;
  std::shared_ptr<project::Project> project;  // project of this text
  std::shared_ptr<project::Project> solved;   // solution of this text, or of the last one that could be solved
  bool is_solved = false;                     // whether of this one
  bool is_dirty = true;

  OpenFile(std::string uri, std::string text);
};

/// "file:///a%20b.toml": "/a b.toml"; another address as it is.
std::string name_of_uri(const std::string& uri);

/// Reads and solves the text again. For a sweep the first point is used.
void refresh(OpenFile& file);

/// The value of a path in a project that is solved; NaN if there is none.
const Value& value_in(const project::Project& project, const std::string& path);

}  // namespace loadpath::cli::lsp
