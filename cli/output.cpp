#include "cli/output.hpp"

#include "cli/browser.hpp"
#include "cli/staged.hpp"
#include "lib/draw/dxf.hpp"
#include "lib/export/csv.hpp"
#include "lib/export/json.hpp"
#include "lib/report/build.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

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

/// FILE.csv for the one step that has series, or a file for each in a folder. False where one file cannot hold them.
bool add_series(const project::Project& project, const OutputOptions& options, std::vector<File>& files) {
  const std::string& path = options.csv;
  auto tables = exports::csv_of(project, project::SeriesChoice(options.series));
  if (tables.empty()) std::cerr << "no series, so nothing to write as CSV\n";
  const bool one_file = ending(path) == ".csv";
  if (one_file && tables.size() > 1) {
    std::cerr << "loadpath: '" << path << "' is one file, and " << tables.size()
              << " steps have series\n  = help: name a folder\n";
    return false;
  }
  for (auto& [name, text] : tables)
    files.push_back({one_file ? fs::path(path) : fs::path(path) / name, std::move(text)});
  return true;
}

struct Drawing {
  std::string step;
  const draw::Figure* figure;
};

/// The drawing of every mechanism at its first position, but for those that close nowhere.
std::vector<Drawing> drawings_of(const project::Project& project) {
  std::vector<Drawing> drawings;
  for (const auto& step : project.steps) {
    const auto& figures = step->account().figures;
    const auto scheme = std::find_if(figures.begin(), figures.end(), [](const draw::Figure& figure) {
      return std::holds_alternative<draw::Scheme>(figure.content);
    });
    if (scheme != figures.end()) drawings.push_back({step->name(), &*scheme});
  }
  return drawings;
}

/// Whether one file is named for the drawings of several mechanisms, which is told.
bool is_one_for_several(const std::string& path, const char* kind, const std::vector<Drawing>& drawings) {
  if (ending(path) != kind || drawings.size() < 2) return false;
  std::cerr << "loadpath: '" << path << "' is one file, and " << drawings.size()
            << " mechanisms are drawn\n  = help: name a folder\n";
  return true;
}

/// FILE.svg with the drawing of the mechanism, or every figure in a folder; FILE.dxf with that drawing, or, of
/// several mechanisms, a folder with a file for each. False where one file cannot hold them.
bool add_drawings(const project::Project& project, const OutputOptions& options, std::vector<File>& files) {
  if (options.svg.empty() && options.dxf.empty()) return true;
  const std::vector<Drawing> drawings = drawings_of(project);
  if (drawings.empty()) std::cerr << "the mechanism closes nowhere, so there is nothing to draw\n";
  if (is_one_for_several(options.svg, ".svg", drawings) || is_one_for_several(options.dxf, ".dxf", drawings))
    return false;
  for (const auto& [step, figure] : drawings) {
    const fs::path dxf = drawings.size() == 1 ? fs::path(options.dxf) : fs::path(options.dxf) / (step + ".dxf");
    if (!options.dxf.empty()) files.push_back({dxf, draw::dxf_of(std::get<draw::Scheme>(figure->content))});
    if (ending(options.svg) == ".svg") files.push_back({options.svg, draw::svg(*figure)});
  }
  if (drawings.empty() || options.svg.empty() || ending(options.svg) == ".svg") return true;
  for (const auto& step : project.steps) {
    for (const draw::Figure& figure : step->account().figures)
      files.push_back({fs::path(options.svg) / (step->name() + "-" + figure.id + ".svg"), draw::svg(figure)});
  }
  return true;
}

bool refuse(const fs::path& path, const char* why) {
  std::cerr << "loadpath: '" << path.string() << "' " << why << ": nothing is written\n  = help: name another file\n";
  return true;
}

}  // namespace

bool overwrites(const std::vector<fs::path>& outputs, const project::Project& project) {
  std::set<fs::path> seen;
  for (const fs::path& path : outputs) {
    std::error_code error;
    const auto is_path = [&](const project::NamedFile& read) { return same_file(path, read.name); };
    if (same_file(path, project.file)) return refuse(path, "is the project itself");
    if (std::any_of(project.files.begin(), project.files.end(), is_path)) return refuse(path, "is read by the project");
    if (!fs::is_other(path, error) && !seen.insert(fs::weakly_canonical(path, error)).second)
      return refuse(path, "is named for two outputs");
  }
  return false;
}

bool can_write(const OutputOptions& options) {
  if (!options.series.empty() && options.csv.empty() && !options.json) {
    std::cerr << "loadpath: '--series' says which series --csv and --json hold, and neither is given\n  = help: add "
                 "--csv PATH or --json\n";
    return false;
  }
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

namespace {

/// Files, and what the browser prints, all or none of them; which reports there are is told.
bool put(const std::vector<File>& files, const std::vector<std::string>& prints, const report::Document& document,
         const project::Project& project) {
  if (files.empty() && prints.empty()) return true;
  std::vector<fs::path> outputs(prints.begin(), prints.end());
  for (const File& file : files) outputs.push_back(file.path);
  if (overwrites(outputs, project)) return false;
  Scratch scratch;
  Staged staged(scratch);
  if (!std::all_of(files.begin(), files.end(), [&](const File& f) { return staged.add(f.path, f.text); })) return false;
  for (const std::string& path : prints) {
    if (!print_to_pdf(report::html(document), staged.aside(path), scratch)) {
      std::cerr << "loadpath: the browser did not write '" << path << "'\n";
      return false;
    }
  }
  return staged.finish();
}

void sort_reports(const report::Document& document, const std::vector<std::string>& paths, std::vector<File>& files,
                  std::vector<std::string>& prints) {
  for (const std::string& path : paths) {
    if (ending(path) == ".pdf") {
      prints.push_back(path);
    } else {
      for (File& file : report_files(document, path)) files.push_back(std::move(file));
    }
  }
}

void tell_reports(const std::vector<std::string>& paths, bool quiet) {
  for (const std::string& path : paths) {
    if (!quiet) std::cerr << "report: " << path << "\n";
  }
}

}  // namespace

bool write_reports(const report::Document& document, const std::vector<std::string>& paths,
                   const project::Project& project, bool quiet) {
  std::vector<File> files;
  std::vector<std::string> prints;
  sort_reports(document, paths, files, prints);
  if (!put(files, prints, document, project)) return false;
  tell_reports(paths, quiet);
  return true;
}

bool write(const project::Project& project, const OutputOptions& options) {
  std::vector<File> files;
  std::vector<std::string> prints;
  report::Document document;
  if (!options.reports.empty()) document = report::build(project, program());
  sort_reports(document, options.reports, files, prints);
  if (!options.csv.empty() && !add_series(project, options, files)) return false;
  if (!add_drawings(project, options, files)) return false;
  if (!put(files, prints, document, project)) return false;
  tell_reports(options.reports, options.quiet);
  return true;
}

}  // namespace loadpath::cli
