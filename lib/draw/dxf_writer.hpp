// Writes the entities of a DXF file, R12, lengths in mm.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace loadpath::draw {

class DxfWriter {
 public:
  void begin(const std::vector<std::string>& layers);
  void line(const std::string& layer, Point from, Point to);
  void polyline(const std::string& layer, const std::vector<Point>& points);
  void polygon(const std::string& layer, const std::vector<Point>& corners);
  void circle(const std::string& layer, Point centre, double radius);
  /// Counter-clockwise from `start` to `end`, rad.
  void arc(const std::string& layer, Point centre, double radius, double start, double end);
  /// Centred at a point; letters that R12 does not have are left out.
  void text(const std::string& layer, Point at, double height, std::string_view words, double turned = 0.0);
  std::string end();

 private:
  void pair(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
  void section(const char* name) { pair(0, "SECTION"), pair(2, name); }
  void place(int code, Point p);

  std::string text_;
};

}  // namespace loadpath::draw
