#include "cli/output.hpp"

#include "cli/browser.hpp"
#include "cli/staged.hpp"
#include "cli/version.hpp"
#include "lib/draw/dxf.hpp"
#include "lib/draw/svg.hpp"
#include "lib/export/csv.hpp"
#include "lib/export/json.hpp"
#include "lib/report/brief/figures.hpp"
#include "lib/report/build/build.hpp"
#include "lib/report/html/compact.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
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

constexpr const char* html_out = "html:-";  // a report on standard output

bool is_standard_output(const std::string& path) { return path == "-" || path == html_out; }
std::string ending(const std::string& path) { return path == html_out ? ".html" : fs::path(path).extension().string(); }
/// Whether a path names one file of this kind, and no folder.
bool is_file(const std::string& path, const char* kind) { return path == "-" || ending(path) == kind; }

/// The options that write to standard output.
std::vector<std::string> on_standard_output(const OutputOptions& options) {
  std::vector<std::string> all;
  for (const std::string& report : options.reports) {
    if (is_standard_output(report)) all.push_back("--report " + report);
  }
  for (const auto& [flag, path] :
       {std::pair{"--csv", &options.csv}, {"--svg", &options.svg}, {"--dxf", &options.dxf}}) {
    if (is_standard_output(*path)) all.push_back(std::string(flag) + " " + *path);
  }
  return all;
}

/// False, with a message, if outputs cannot share standard output, or cannot be written there at all.
bool can_stream(const OutputOptions& options) {
  auto all = on_standard_output(options);
  for (const std::string& report : options.reports) {
    if (report == "-" || (report.ends_with(":-") && report != html_out)) {
      std::cerr << "loadpath: '--report " << report
                << "' cannot be written to standard output: a report there is HTML\n  = help: write --report html:-, "
                   "or name a file\n";
      return false;
    }
  }
  if (options.json) all.push_back("--json");
  if (all.size() < 2 || (options.json && all.size() == 1)) return true;
  std::cerr << "loadpath: '" << all[0] << "' and '" << all[1]
            << "' both write to standard output\n  = help: name a file for one of them\n";
  return false;
}

std::vector<File> report_files(const report::Document& document, const std::string& path) {
  if (ending(path) == ".html") return {{path, report::compact(report::html(document))}};
  if (ending(path) == ".tex") return {{path, report::latex(document)}};
  const fs::path base(path);
  const report::Markdown markdown = report::markdown(document, base.stem().string());
  std::vector<File> files{{path, markdown.text}};
  for (const auto& [name, svg] : markdown.figures) files.push_back({base.parent_path() / name, svg});
  return files;
}

/// FILE.csv for the one step that has series, or a file for each in a folder. False if one file cannot hold them.
bool add_series(const project::Project& project, const OutputOptions& options, std::vector<File>& files) {
  const std::string& path = options.csv;
  auto tables = exports::csv_of(project, project::SeriesChoice(options.series));
  if (tables.empty()) std::cerr << "no series, so nothing to write as CSV\n";
  const bool one_file = is_file(path, ".csv");
  if (one_file && tables.size() > 1) {
    std::cerr << "loadpath: '" << path << "' is one file, and " << tables.size()
              << " steps have series\n  = help: name a folder\n";
    return false;
  }
  for (auto& [name, text] : tables)
    files.push_back({one_file ? fs::path(path) : fs::path(path) / name, std::move(text)});
  return true;
}

using Drawing = report::StepFigure;

/// The first drawing to scale of every step: of a mechanism at its first position, of a section, of a drive.
std::vector<Drawing> drawings_of(const project::Project& project) {
  std::vector<Drawing> drawings;
  for (const auto& step : project.steps) {
    const auto& figures = step->account().figures;
    const auto drawing = std::find_if(figures.begin(), figures.end(), draw::is_to_scale);
    if (drawing != figures.end()) drawings.push_back({step.get(), &*drawing});
  }
  return drawings;
}

/// The content of a single file: the drawing of the mechanism, or, if there is none, the first figure of the step
/// that has any.
std::vector<Drawing> leading_figures(const project::Project& project) {
  std::vector<Drawing> figures = drawings_of(project);
  if (!figures.empty()) return figures;
  for (const auto& step : project.steps) {
    if (!step->account().figures.empty()) figures.push_back({step.get(), &step->account().figures.front()});
  }
  return figures;
}

/// Whether one file is named for the drawings of several steps, with a message.
bool is_one_for_several(const std::string& path, const char* kind, const std::vector<Drawing>& drawings) {
  if (!is_file(path, kind) || drawings.size() < 2) return false;
  std::cerr << "loadpath: '" << path << "' is one file, and " << drawings.size()
            << " steps are drawn\n  = help: name a folder\n";
  return true;
}

/// FILE.svg with the leading figure, or every figure in a folder. False if one file cannot hold them.
bool add_figures(const project::Project& project, const std::string& path, std::vector<File>& files) {
  if (path.empty()) return true;
  const std::vector<Drawing> figures = leading_figures(project);
  if (figures.empty()) std::cerr << "no step has a figure, so there is nothing to draw\n";
  if (is_one_for_several(path, ".svg", figures)) return false;
  if (figures.empty()) return true;
  if (is_file(path, ".svg")) {
    files.push_back({path, draw::svg(report::in_file(project, figures[0]))});
    return true;
  }
  for (const auto& step : project.steps) {
    for (const figure::Figure& figure : step->account().figures)
      files.push_back({fs::path(path) / (step->name() + "-" + figure.id + ".svg"),
                       draw::svg(report::in_file(project, {step.get(), &figure}))});
  }
  return true;
}

/// FILE.dxf with the figures drawn to scale, or, for several, a folder with a file for each. False if one file cannot
/// hold them.
bool add_drawings(const project::Project& project, const std::string& path, std::vector<File>& files) {
  if (path.empty()) return true;
  const std::vector<Drawing> drawings = drawings_of(project);
  if (drawings.empty()) std::cerr << "nothing is drawn to scale, so there is nothing to write as DXF\n";
  if (is_one_for_several(path, ".dxf", drawings)) return false;
  for (const auto& [step, figure] : drawings) {
    const fs::path file = drawings.size() == 1 ? fs::path(path) : fs::path(path) / (step->name() + ".dxf");
    files.push_back({file, draw::dxf_of(*figure)});
  }
  return true;
}

/// Whether it is a file of that kind, or a folder: what looks like a file of another kind would become a folder.
bool is_file_or_folder(const std::string& path, const char* kind, const char* what) {
  constexpr std::array files{".csv", ".svg",  ".dxf",  ".png",  ".jpg", ".gif", ".pdf", ".eps", ".txt",
                             ".tsv", ".html", ".json", ".toml", ".md",  ".tex", ".dwg", ".xls", ".xlsx"};
  std::string end = ending(path);
  std::ranges::transform(end, end.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::error_code error;
  if (end == kind || std::ranges::find(files, end) == files.end() || fs::is_directory(path, error)) return true;
  std::cerr << "loadpath: " << what << " as FILE" << kind << " or into a folder, not as '" << path
            << "'\n  = help: name a file that ends in " << kind << ", or a folder\n";
  return false;
}

bool refuse_output(const fs::path& path, const char* why) {
  std::cerr << "loadpath: '" << path.string() << "' " << why << ": nothing is written\n  = help: name another file\n";
  return true;
}

}  // namespace

bool overwrites(const std::vector<fs::path>& outputs, const project::Project& project) {
  std::set<fs::path> seen;
  for (const fs::path& path : outputs) {
    std::error_code error;
    const auto is_path = [&](const project::NamedFile& read) { return same_file(path, read.name); };
    if (same_file(path, project.file)) return refuse_output(path, "is the project itself");
    if (std::any_of(project.files.begin(), project.files.end(), is_path))
      return refuse_output(path, "is read by the project");
    if (!fs::is_other(path, error) && !seen.insert(fs::weakly_canonical(path, error)).second)
      return refuse_output(path, "is named for two outputs");
  }
  return false;
}

bool takes_standard_output(const OutputOptions& options) { return !on_standard_output(options).empty(); }

bool can_place(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  if (!fs::is_directory(path, error) && (!fs::exists(folder, error) || fs::is_directory(folder, error))) return true;
  std::cerr << "loadpath: cannot write '" << path << "': it is a folder, or lies in a file\n";
  return false;
}

bool can_write(const OutputOptions& options) {
  if (!can_stream(options)) return false;
  if (!options.series.empty() && options.csv.empty() && !options.json) {
    std::cerr << "loadpath: '--series' selects the series for --csv and --json; neither is given\n  = help: add "
                 "--csv PATH or --json\n";
    return false;
  }
  if (!is_file_or_folder(options.svg, ".svg", "figures are written") ||
      !is_file_or_folder(options.dxf, ".dxf", "drawings are written") ||
      !is_file_or_folder(options.csv, ".csv", "series are written"))
    return false;
  for (const std::string& path : options.reports) {
    const std::string kind = ending(path);
    if (kind != ".html" && kind != ".md" && kind != ".tex" && kind != ".pdf") {
      std::cerr << "loadpath: a report is written as .html, .md, .tex or .pdf, not as '" << path << "'\n";
      return false;
    }
    if (kind == ".pdf" && find_browser().empty()) {
      std::cerr << "loadpath: a PDF needs Chromium, and there is none\n  = help: install it (apt-get install "
                   "chromium), or write "
                   "an .html report and print it\n";
      return false;
    }
    if (!is_standard_output(path) && !can_place(path)) return false;
  }
  return true;
}

namespace {

/// Writes files, and the browser's prints, all or none of them; lists the written reports.
bool put(const std::vector<File>& files, const std::vector<std::string>& prints, const report::Document& document,
         const project::Project& project) {
  if (files.empty() && prints.empty()) return true;
  std::vector<fs::path> outputs(prints.begin(), prints.end());
  for (const File& file : files) {
    if (!is_standard_output(file.path.string())) outputs.push_back(file.path);
  }
  if (overwrites(outputs, project)) return false;
  Scratch scratch;
  Staged staged(scratch);
  const auto is_staged = [&](const File& f) {
    return is_standard_output(f.path.string()) || staged.add(f.path, f.text);
  };
  if (!std::all_of(files.begin(), files.end(), is_staged)) return false;
  for (const std::string& path : prints) {
    std::error_code error;
    if (fs::is_other(path, error)) {
      std::cerr << "loadpath: '" << path << "' is a device or a pipe, and a PDF needs a file\n";
      return false;
    }
    if (!print_to_pdf(report::html(document, report::Folding::open), staged.aside(path), scratch)) {
      std::cerr << "loadpath: the browser did not write '" << path << "'\n";
      return false;
    }
  }
  if (!staged.finish()) return false;
  for (const File& file : files) {
    if (is_standard_output(file.path.string())) std::cout << file.text;
  }
  return true;
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

/// "figures: out": what was written there.
void announce(const char* what, const std::string& path, bool quiet) {
  if (!quiet && !path.empty() && !is_standard_output(path)) std::cerr << what << ": " << path << "\n";
}

void announce_reports(const std::vector<std::string>& paths, bool quiet) {
  for (const std::string& path : paths) announce("report", path, quiet);
}

}  // namespace

bool write_reports(const report::Document& document, const std::vector<std::string>& paths,
                   const project::Project& project, bool quiet) {
  std::vector<File> files;
  std::vector<std::string> prints;
  sort_reports(document, paths, files, prints);
  if (!put(files, prints, document, project)) return false;
  announce_reports(paths, quiet);
  return true;
}

namespace {

/// The date of the run, "2026-11-28".
std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  std::array<char, 16> text{};
  localtime_r(&now, &local);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &local)};
}

report::Document document_of(const project::Project& project, const OutputOptions& options, const std::string& input) {
  const report::Detail detail = options.brief ? report::Detail::brief : detail_of(options, report::Detail::normal);
  report::Document document = report::build(project, program(), detail, input);
  document.heading.printed = today();
  return document;
}

}  // namespace

report::Detail detail_of(const OutputOptions& options, report::Detail usual) {
  if (options.detail.empty()) return usual;
  return options.detail == "brief"  ? report::Detail::brief
         : options.detail == "full" ? report::Detail::full
                                    : report::Detail::normal;
}

bool write(const project::Project& project, const OutputOptions& options, const std::string& input) {
  std::vector<File> files;
  std::vector<std::string> prints;
  report::Document document;
  if (!options.reports.empty()) document = document_of(project, options, input);
  sort_reports(document, options.reports, files, prints);
  const std::size_t reports = files.size();
  if (!options.csv.empty() && !add_series(project, options, files)) return false;
  const std::size_t series = files.size();
  if (!add_figures(project, options.svg, files)) return false;
  const std::size_t figures = files.size();
  if (!add_drawings(project, options.dxf, files)) return false;
  const std::size_t drawings = files.size();
  if (!put(files, prints, document, project)) return false;
  announce_reports(options.reports, options.quiet);
  if (series > reports) announce("series", options.csv, options.quiet);
  if (figures > series) announce("figures", options.svg, options.quiet);
  if (drawings > figures) announce("drawings", options.dxf, options.quiet);
  return true;
}

}  // namespace loadpath::cli
