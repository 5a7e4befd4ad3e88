#include "lib/draw/dxf_writer.hpp"

#include "lib/quantity/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace loadpath::draw {

namespace {

constexpr int colours = 7;  // the palette's first seven, which are visible on dark and light

/// Rounding errors of a zero are written as zero.
std::string number(double mm) { return std::abs(mm) < 1e-9 ? "0" : format_number(mm, 10); }

/// The letters that R12 has, with its signs for degrees and diameters.
std::string in_ascii(std::string_view words) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> known{
      {{"°", "%%d"}, {"Ø", "%%c"}, {"⌀", "%%c"}, {"·", "*"}, {"\u2212", "-"}, {"\u00a0", " "}}};
  std::string out;
  while (!words.empty()) {
    const auto hit =
        std::find_if(known.begin(), known.end(), [&](const auto& k) { return words.starts_with(k.first); });
    if (hit != known.end()) out += hit->second;
    const bool plain = static_cast<unsigned char>(words.front()) < 0x80;
    if (hit == known.end() && plain) out += words.front();
    words.remove_prefix(hit != known.end() ? hit->first.size() : 1);
  }
  return out;
}

}  // namespace

void DxfWriter::begin(const std::vector<std::string>& layers) {
  pair(999, "lengths in mm");
  section("HEADER");
  pair(9, "$ACADVER"), pair(1, "AC1009");
  pair(0, "ENDSEC");
  section("TABLES");
  pair(0, "TABLE"), pair(2, "LAYER"), pair(70, std::to_string(layers.size()));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    pair(0, "LAYER"), pair(2, layers[i]), pair(70, "0");
    pair(62, std::to_string(colours - static_cast<int>(i) % colours)), pair(6, "CONTINUOUS");
  }
  pair(0, "ENDTAB"), pair(0, "ENDSEC");
  section("ENTITIES");
}

void DxfWriter::place(int code, Point p) {
  pair(code, number(p.x)), pair(code + 10, number(p.y)), pair(code + 20, "0");
}

void DxfWriter::line(const std::string& layer, Point from, Point to) {
  pair(0, "LINE"), pair(8, layer);
  place(10, from), place(11, to);
}

void DxfWriter::polyline(const std::string& layer, const std::vector<Point>& points) {
  for (std::size_t i = 1; i < points.size(); ++i) line(layer, points[i - 1], points[i]);
}

void DxfWriter::polygon(const std::string& layer, const std::vector<Point>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) line(layer, corners[i], corners[(i + 1) % corners.size()]);
}

void DxfWriter::circle(const std::string& layer, Point centre, double radius) {
  pair(0, "CIRCLE"), pair(8, layer);
  place(10, centre), pair(40, number(radius));
}

void DxfWriter::arc(const std::string& layer, Point centre, double radius, double start, double end) {
  constexpr double degree = std::numbers::pi / 180.0;
  pair(0, "ARC"), pair(8, layer);
  place(10, centre), pair(40, number(radius));
  pair(50, number(start / degree)), pair(51, number(end / degree));
}

void DxfWriter::text(const std::string& layer, Point at, double height, std::string_view words, double turned) {
  constexpr int centred = 1, in_middle = 2;
  pair(0, "TEXT"), pair(8, layer);
  place(10, at), pair(40, number(height)), pair(1, in_ascii(words));
  if (turned != 0.0) pair(50, number(turned));
  pair(72, std::to_string(centred)), place(11, at), pair(73, std::to_string(in_middle));
}

std::string DxfWriter::end() {
  pair(0, "ENDSEC"), pair(0, "EOF");
  return std::move(text_);
}

}  // namespace loadpath::draw
