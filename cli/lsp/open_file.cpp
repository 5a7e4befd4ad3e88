#include "cli/lsp/open_file.hpp"

#include "calculators/catalogue.hpp"
#include "cli/points.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace loadpath::cli::lsp {

namespace {

/// Whether the project is a sweep: something in it has more than one value.
bool has_several(const project::Project& project) {
  return !project.values.several().empty() ||
         std::any_of(project.steps.begin(), project.steps.end(),
                     [](const auto& step) { return !step->input().reading.varied.empty(); });
}

}  // namespace

std::string name_of_uri(const std::string& uri) {
  constexpr std::string_view scheme = "file://";
  if (!uri.starts_with(scheme)) return uri;
  std::string name;
  for (std::size_t i = scheme.size(); i < uri.size(); ++i) {
    unsigned byte = 0;
    const char* const digits = uri.data() + i + 1;
    const bool coded =
        uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    name += coded ? static_cast<char>(byte) : uri[i];
    if (coded) i += 2;
  }
  return name;
}

OpenFile::OpenFile(std::string address, std::string text)
    : uri(std::move(address)),
      name(name_of_uri(uri)),
      document(std::move(text)),
      outline(outline_of(document.text())) {}

void refresh(OpenFile& file) {
  file.is_dirty = file.is_solved = false;
  file.issues.clear();
  file.outline = outline_of(file.document.text());
  file.project = std::make_shared<project::Project>(
      project::read_project(file.document.text(), file.name, catalogue(), file.issues, project::Ranges::taken));
  if (!has_errors(file.issues) && has_several(*file.project)) take_point(*file.project, 0, file.issues);
  if (has_errors(file.issues)) return;
  project::solve(*file.project, file.issues, {.pictures = false, .formulas = false, .unused = true, .words = true});
  if (has_errors(file.issues)) return;
  file.is_solved = true;
  file.solved = file.project;
}

const Value& value_in(const project::Project& project, const std::string& path) {
  static const Value none{{}, {std::numeric_limits<double>::quiet_NaN()}};
  const Value* const known = project.value(path);
  return known == nullptr ? none : *known;
}

}  // namespace loadpath::cli::lsp
