#include "lib/draw/canvas/svg_writer.hpp"

#include "lib/draw/canvas/number.hpp"
#include "lib/draw/canvas/style.hpp"
#include "lib/text/markup.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

/// Numbers of a path need a separator only before a digit or a point.
void append_coordinate(std::string& out, double value) {
  const bool after_command = (out.back() >= 'a' && out.back() <= 'z') || (out.back() >= 'A' && out.back() <= 'Z');
  const std::size_t at = out.size();
  append_number(out, value);
  if (out[at] != '-' && !after_command) out.insert(at, 1, ' ');
}

double rounded(double value) { return std::round(100.0 * value) / 100.0; }

/// Writes element after element.
class Svg {
 public:
  explicit Svg(std::string& body) : body_(body) {}

  void operator()(const Canvas::Path& path) {
    open("path", path.style);
    body_ += " d=\"M";
    Point last;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const Point p{rounded(path.points[i].x), rounded(path.points[i].y)};
      if (i == 1) body_ += 'l';
      coordinates(p - last);
      last = p;
    }
    body_ += path.closed ? "z\"/>\n" : "\"/>\n";
  }
  void operator()(const Canvas::Strokes& many) {
    open("path", many.style);
    body_ += " d=\"";
    for (const auto& [from, to] : many.strokes) {
      body_ += 'M';
      coordinates(from);
      body_ += 'L';
      coordinates(to);
    }
    body_ += "\"/>\n";
  }
  void operator()(const Canvas::Dots& dots) {
    open("path", dots.style);
    body_ += " d=\"";
    for (const Point& place : dots.places) {
      body_ += 'M';
      coordinates(place);
      body_ += "h0";
    }
    body_ += "\"/>\n";
  }
  void operator()(const Canvas::Circle& circle) {
    open("circle", circle.style);
    attribute("cx", circle.centre.x);
    attribute("cy", circle.centre.y);
    attribute("r", circle.radius);
    body_ += "/>\n";
  }
  void operator()(const Canvas::Arc& arc) {
    const auto at = [&](double angle) { return arc.centre + arc.radius * Point{std::cos(angle), -std::sin(angle)}; };
    open("path", arc.style);
    body_ += " d=\"M";
    coordinates(at(arc.start));
    body_ += 'A';
    coordinates({arc.radius, arc.radius});
    body_ += std::fabs(arc.sweep) > std::numbers::pi ? " 0 1" : " 0 0";
    body_ += arc.sweep > 0.0 ? " 0" : " 1";
    coordinates(at(arc.start + arc.sweep));
    body_ += "\"/>\n";
  }
  void operator()(const Canvas::Rectangle& rectangle) {
    open("rect", rectangle.style);
    attribute("x", rectangle.box.left);
    attribute("y", rectangle.box.top);
    attribute("width", rectangle.box.width());
    attribute("height", rectangle.box.height());
    body_ += "/>\n";
  }
  void operator()(const Canvas::Words& words) {
    open("text", words.style);
    attribute("x", words.at.x);
    attribute("y", words.at.y);
    if (words.anchor != Anchor::start)
      body_ += words.anchor == Anchor::middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
    if (words.turned) {
      body_ += " transform=\"rotate(-90";
      coordinates(words.at);
      body_ += ")\"";
    }
    body_ += '>';
    bool dropped = false;
    for (const Run& run : words.text) dropped = add(run, dropped);
    body_ += "</text>\n";
  }
  void operator()(const Canvas::GroupBegin& group) {
    body_ += "<g";
    for (const auto& [name, value] : group.attributes)
      body_.append(" ").append(name).append("=\"") += escaped(value) + "\"";
    body_ += ">\n";
  }
  void operator()(const Canvas::GroupEnd&) { body_ += "</g>\n"; }

 private:
  void open(std::string_view element, std::string_view style) {
    body_.append("<").append(element).append(" class=\"").append(style).append("\"");
  }
  void attribute(std::string_view name, double value) {
    body_.append(" ").append(name).append("=\"");
    append_number(body_, value);
    body_ += '"';
  }
  void coordinates(Point at) {
    append_coordinate(body_, at.x);
    append_coordinate(body_, at.y);
  }
  /// `dropped`: the run before is a subscript; whether this one is.
  bool add(const Run& run, bool dropped) {
    constexpr double drop = 3.0;
    const bool sub = run.face == Run::Face::subscript;
    const bool marked = run.face != Run::Face::words || dropped;
    if (marked) body_ += "<tspan";
    if (run.face != Run::Face::words) body_ += sub ? " class=\"u\"" : " class=\"s\"";
    if (sub != dropped) attribute("dy", sub ? drop : -drop);
    if (marked) body_ += '>';
    body_ += escaped(run.text);
    if (marked) body_ += "</tspan>";
    return sub;
  }

  std::string& body_;
};

std::string element(const Picture& picture, std::string_view title, const std::string& style) {
  const double natural = std::round(560.0 / view_width * picture.width);  // pixels on a wide page
  std::string out = "<svg class=\"lp\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"0 0";
  append_coordinate(out, picture.width);
  append_coordinate(out, std::round(picture.height));
  out += "\" width=\"";
  append_number(out, natural);
  out += "\" height=\"";
  append_number(out, std::round(picture.height / picture.width * natural));
  out += "\" style=\"max-width:100%;height:auto\" fill=\"none\">\n<title>";
  out += escaped(title);
  out += "</title>\n<desc>";
  out += escaped(picture.description);
  out += "</desc>\n" + style + "<rect class=\"page\" width=\"100%\" height=\"100%\"/>\n";
  Svg writer(out);
  for (const Canvas::Element& part : picture.canvas.elements()) std::visit(writer, part);
  return out + "</svg>\n";
}

}  // namespace

std::string svg_file(const Picture& picture, std::string_view title) {
  return element(picture, title, "<style>" + style_sheet() + "</style>\n");
}

std::string svg_part(const Picture& picture, std::string_view title) { return element(picture, title, ""); }

}  // namespace loadpath::draw
