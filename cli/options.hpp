// Options that several commands share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace loadpath::cli {

/// What every solving command can write.
struct OutputOptions {
  std::vector<std::string> reports;  // .html, .md, .tex, .pdf
  bool json = false;
  std::string csv;                  // folder, or a .csv file for the one step that has series
  std::string svg;                  // folder for every figure, or an .svg file for the leading one
  std::string dxf;                  // file for the drawing to scale, or folder for several
  std::vector<std::string> series;  // patterns of those that JSON and CSV hold; none: all
  std::string detail;               // brief, normal, full; empty: as the command has it
  bool quiet = false;
  bool full = false;    // with every table that the terminal has
  bool modes = false;   // every failure mode
  bool strict = false;  // what is open counts as not judged
};

/// The points of a sweep, where the project does not say them.
struct PointOptions {
  std::optional<std::uint64_t> samples, seed;
  bool latin = false;
  std::vector<std::string> zip;  // "shaft.T,shaft.n"
};

}  // namespace loadpath::cli
