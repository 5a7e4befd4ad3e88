#include "lib/draw/canvas/svg_writer.hpp"

#include "lib/draw/canvas/svg_style.hpp"
#include "lib/text/markup.hpp"

#include <charconv>
#include <cstdlib>
#include <numbers>

namespace loadpath::draw {
namespace {

void append_number(std::string& out, double value) {
  constexpr double limit = 1e6;
  const double kept = std::isfinite(value) ? std::clamp(value, -limit, limit) : 0.0;
  const long hundredths = std::lround(100.0 * kept);
  if (hundredths < 0) out += '-';
  const long whole = std::labs(hundredths) / 100, part = std::labs(hundredths) % 100;
  char digits[24];
  if (whole > 0 || part == 0) out.append(digits, std::to_chars(digits, digits + sizeof digits, whole).ptr);
  if (part == 0) return;
  out += '.';
  out += static_cast<char>('0' + part / 10);
  if (part % 10 != 0) out += static_cast<char>('0' + part % 10);
}

/// Numbers of a path need a separator only before a digit or a point.
void append_coordinate(std::string& out, double value) {
  std::string number;
  append_number(number, value);
  const bool after_command = (out.back() >= 'a' && out.back() <= 'z') || (out.back() >= 'A' && out.back() <= 'Z');
  if (number.front() != '-' && !after_command) out += ' ';
  out += number;
}

double rounded(double value) { return std::round(100.0 * value) / 100.0; }

}  // namespace

void SvgWriter::open(std::string_view element, std::string_view style) {
  body_.append("<").append(element).append(" class=\"").append(style).append("\"");
}

void SvgWriter::begin_group(const std::vector<std::pair<std::string_view, std::string>>& attributes) {
  body_ += "<g";
  for (const auto& [name, value] : attributes) body_.append(" ").append(name).append("=\"") += escaped(value) + "\"";
  body_ += ">\n";
}

void SvgWriter::attribute(std::string_view name, double value) {
  body_.append(" ").append(name).append("=\"");
  append_number(body_, value);
  body_ += '"';
}

void SvgWriter::path(std::string_view style, const std::vector<Point>& points, bool closed) {
  if (points.size() < 2) return;
  open("path", style);
  body_ += " d=\"M";
  Point last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p{rounded(points[i].x), rounded(points[i].y)};
    if (i == 1) body_ += 'l';
    append_coordinate(body_, p.x - last.x);
    append_coordinate(body_, p.y - last.y);
    last = p;
  }
  body_ += closed ? "z\"/>\n" : "\"/>\n";
}

void SvgWriter::line(std::string_view style, Point from, Point to) { path(style, {from, to}, false); }
void SvgWriter::polyline(std::string_view style, const std::vector<Point>& points) { path(style, points, false); }
void SvgWriter::polygon(std::string_view style, const std::vector<Point>& points) { path(style, points, true); }

void SvgWriter::strokes(std::string_view style, const std::vector<std::pair<Point, Point>>& strokes) {
  if (strokes.empty()) return;
  open("path", style);
  body_ += " d=\"";
  for (const auto& [from, to] : strokes) {
    body_ += 'M';
    append_coordinate(body_, from.x);
    append_coordinate(body_, from.y);
    body_ += 'L';
    append_coordinate(body_, to.x);
    append_coordinate(body_, to.y);
  }
  body_ += "\"/>\n";
}

void SvgWriter::dots(std::string_view style, const std::vector<Point>& places) {
  if (places.empty()) return;
  open("path", style);
  body_ += " d=\"";
  for (const Point& place : places) {
    body_ += 'M';
    append_coordinate(body_, place.x);
    append_coordinate(body_, place.y);
    body_ += "h0";
  }
  body_ += "\"/>\n";
}

void SvgWriter::circle(std::string_view style, Point centre, double radius) {
  open("circle", style);
  attribute("cx", centre.x);
  attribute("cy", centre.y);
  attribute("r", radius);
  body_ += "/>\n";
}

void SvgWriter::arc(std::string_view style, Point centre, double radius, double start, double sweep) {
  const auto at = [&](double angle) { return centre + radius * Point{std::cos(angle), -std::sin(angle)}; };
  const Point from = at(start), to = at(start + sweep);
  open("path", style);
  body_ += " d=\"M";
  append_coordinate(body_, from.x);
  append_coordinate(body_, from.y);
  body_ += 'A';
  append_coordinate(body_, radius);
  append_coordinate(body_, radius);
  body_ += std::fabs(sweep) > std::numbers::pi ? " 0 1" : " 0 0";
  body_ += sweep > 0.0 ? " 0" : " 1";
  append_coordinate(body_, to.x);
  append_coordinate(body_, to.y);
  body_ += "\"/>\n";
}

void SvgWriter::rectangle(std::string_view style, const Box& box) {
  open("rect", style);
  attribute("x", box.left);
  attribute("y", box.top);
  attribute("width", box.width());
  attribute("height", box.height());
  body_ += "/>\n";
}

void SvgWriter::text(std::string_view style, Point at, const Text& text, Anchor anchor, bool turned) {
  if (text.empty()) return;
  constexpr double drop = 3.0;
  open("text", style);
  attribute("x", at.x);
  attribute("y", at.y);
  if (anchor != Anchor::start) body_ += anchor == Anchor::middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
  if (turned) {
    body_ += " transform=\"rotate(-90";
    append_coordinate(body_, at.x);
    append_coordinate(body_, at.y);
    body_ += ")\"";
  }
  body_ += '>';
  bool dropped = false;
  for (const Run& run : text) {
    const bool sub = run.face == Run::Face::subscript;
    const bool marked = run.face != Run::Face::words || dropped;
    if (marked) body_ += "<tspan";
    if (run.face != Run::Face::words) body_ += sub ? " class=\"u\"" : " class=\"s\"";
    if (sub != dropped) attribute("dy", sub ? drop : -drop);
    if (marked) body_ += '>';
    body_ += escaped(run.text);
    if (marked) body_ += "</tspan>";
    dropped = sub;
  }
  body_ += "</text>\n";
}

void SvgWriter::centred_text(std::string_view style, const Box& box, const Text& words) {
  constexpr double cap_half = 4.6;  // half the height of a capital
  text(style, box.centre() + Point{0.0, cap_half}, words, Anchor::middle);
}

std::string SvgWriter::document(double height, std::string_view title, std::string_view description,
                                double width) const {
  const double natural = std::round(560.0 / view_width * width);  // pixels on a wide page
  std::string out = "<svg class=\"lp\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0";
  append_coordinate(out, width);
  append_coordinate(out, std::round(height));
  out += "\" width=\"";
  append_number(out, natural);
  out += "\" height=\"";
  append_number(out, std::round(height / width * natural));
  out += "\" style=\"max-width:100%;height:auto\" fill=\"none\">\n<title>";
  out += escaped(title);
  out += "</title>\n<desc>";
  out += escaped(description);
  out += "</desc>\n<style>" + style_sheet() + "</style>\n<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n";
  return out + body_ + "</svg>\n";
}

}  // namespace loadpath::draw
