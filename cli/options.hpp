// Options that several commands share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::cli {

/// The output options of every solving command.
struct OutputOptions {
  std::vector<std::string> reports;  // .html, .md, .tex, .pdf
  bool report_of_project = false;    // where none is named, the one that the project names
  bool json = false;
  std::string csv;                  // folder, or a .csv file for the one step that has series
  std::string svg;                  // folder for every figure, or an .svg file for the leading one
  std::string dxf;                  // file for the drawing to scale, or folder for several
  std::vector<std::string> series;  // patterns of those that JSON and CSV hold; none: all
  std::string detail;               // brief, normal, full; empty: as the command has it
  bool brief = false;               // reports without the appendix
  bool quiet = false;
  bool strict = false;  // modes not considered count as not assessed
  bool full = false;    // with every table that the terminal has
  bool modes = false;   // every failure mode
};

/// The points of a sweep, for projects that do not define them.
struct PointOptions {
  std::optional<std::uint64_t> samples, seed;
  bool latin = false;
  std::vector<std::string> zip;  // "shaft.T,shaft.n"
};

}  // namespace loadpath::cli
