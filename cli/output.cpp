#include "cli/output.hpp"

#include "cli/browser.hpp"
#include "lib/io/csv.hpp"
#include "lib/io/json.hpp"
#include "lib/report/build.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace loadpath::cli {

namespace {

namespace fs = std::filesystem;

struct File {
  fs::path path;
  std::string text;
};

std::string ending(const std::string& path) { return fs::path(path).extension().string(); }

std::vector<File> report_files(const report::Document& document, const std::string& path) {
  if (ending(path) == ".html") return {{path, report::html(document)}};
  const fs::path base(path);
  const report::Markdown markdown = report::markdown(document, base.stem().string());
  std::vector<File> files{{path, markdown.text}};
  for (const auto& [name, svg] : markdown.figures) files.push_back({base.parent_path() / name, svg});
  return files;
}

bool write_file(const File& file) {
  std::error_code error;
  if (file.path.has_parent_path()) fs::create_directories(file.path.parent_path(), error);
  std::ofstream stream(file.path, std::ios::binary);
  stream << file.text;
  stream.close();
  if (stream) return true;
  std::cerr << "loadpath: cannot write '" << file.path.string() << "'\n";
  return false;
}

}  // namespace

bool can_write(const OutputOptions& options) {
  for (const std::string& path : options.reports) {
    const std::string kind = ending(path);
    if (kind != ".html" && kind != ".md" && kind != ".pdf") {
      std::cerr << "loadpath: a report is written as .html, .md or .pdf, not as '" << path << "'\n";
      return false;
    }
    if (kind == ".pdf" && find_browser().empty()) {
      std::cerr << "loadpath: a PDF needs Chromium, and there is none\n  = help: install it (apt-get install "
                   "chromium), or write "
                   "an .html report and print it\n";
      return false;
    }
    const fs::path folder = fs::path(path).parent_path();
    if (fs::is_directory(path) || (fs::exists(folder) && !fs::is_directory(folder))) {
      std::cerr << "loadpath: cannot write '" << path << "': it is a folder, or lies in a file\n";
      return false;
    }
  }
  return true;
}

bool write(const project::Project& project, const OutputOptions& options) {
  std::vector<File> files;
  std::vector<std::string> prints;
  const report::Document document = report::build(project, program());
  for (const std::string& path : options.reports) {
    if (ending(path) == ".pdf") {
      prints.push_back(path);
    } else {
      for (File& file : report_files(document, path)) files.push_back(std::move(file));
    }
  }
  if (!options.csv.empty()) {
    for (auto& [name, text] : io::csv_of(project)) files.push_back({fs::path(options.csv) / name, std::move(text)});
    if (io::csv_of(project).empty()) std::cerr << "no series, so nothing to write as CSV\n";
  }
  if (!std::all_of(files.begin(), files.end(), write_file)) return false;
  for (const std::string& path : prints) {
    if (!print_to_pdf(report::html(document), path)) {
      std::cerr << "loadpath: the browser did not write '" << path << "'\n";
      return false;
    }
  }
  for (const std::string& path : options.reports) {
    if (!options.quiet) std::cerr << "report: " << path << "\n";
  }
  return true;
}

}  // namespace loadpath::cli
