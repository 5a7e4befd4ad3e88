#include "lib/draw/canvas/svg_writer.hpp"

#include "lib/draw/canvas/number.hpp"
#include "lib/draw/canvas/style.hpp"
#include "lib/text/markup.hpp"

#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

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

/// The data of a polyline, without its end.
std::string course_of(const Canvas::Path& path) {
  std::string data = "M";
  Point last;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Point p{rounded(path.points[i].x), rounded(path.points[i].y)};
    if (i == 1) data += 'l';
    append_coordinate(data, (p - last).x);
    append_coordinate(data, (p - last).y);
    last = p;
  }
  return data;
}

struct Course {
  int count = 0;
  bool is_closed = true;  // in all places
};
using Courses = std::map<std::string, Course>;

/// Long courses that a picture has more than once: the teeth of a gear, filled and as an outline.
Courses repeated_courses(const Canvas& canvas) {
  constexpr std::size_t least_points = 60;
  Courses courses;
  for (const Canvas::Element& part : canvas.elements()) {
    const auto* const path = std::get_if<Canvas::Path>(&part);
    if (path == nullptr || path->points.size() < least_points) continue;
    Course& course = courses[course_of(*path)];
    ++course.count;
    course.is_closed = course.is_closed && path->closed;
  }
  std::erase_if(courses, [](const auto& one) { return one.second.count < 2; });
  return courses;
}

/// Whether a path may be open where its outline is: a filled area has none.
bool may_be_open(const Canvas::Path& path) { return !path.closed || path.style == "body"; }

/// A name that follows from the course, as all pictures of a page share their names.
std::string name_of(std::string_view course) {
  constexpr std::uint64_t offset = 14695981039346656037U, prime = 1099511628211U;  // FNV-1a
  constexpr std::string_view digits = "0123456789abcdef";
  std::uint64_t hash = offset;
  for (const char c : course) hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  std::string name = "p";
  for (int i = 0; i < 8; ++i, hash >>= 4U) name += digits[hash & 15U];
  return name;
}

/// Writes element after element.
class Svg {
 public:
  Svg(std::string& body, Courses repeated) : body_(body), repeated_(std::move(repeated)) {
    if (repeated_.empty()) return;
    body_ += "<defs>\n";
    for (const auto& [data, course] : repeated_)
      body_ += "<path id=\"" + name_of(data) + "\" d=\"" + data + (course.is_closed ? "z\"/>\n" : "\"/>\n");
    body_ += "</defs>\n";
  }

  void operator()(const Canvas::Path& path) {
    const std::string course = course_of(path);
    const auto known = repeated_.find(course);
    if (known != repeated_.end() && (known->second.is_closed || may_be_open(path))) {
      open("use", path.style);
      body_ += " href=\"#" + name_of(course) + "\"/>\n";
      return;
    }
    open("path", path.style);
    body_ += " d=\"" + course + (path.closed ? "z\"/>\n" : "\"/>\n");
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
  Courses repeated_;
};

/// `repeated`: courses that are written once, in a page; programs that read files may not know references.
std::string element(const Picture& picture, std::string_view title, const std::string& style, Courses repeated) {
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
  Svg writer(out, std::move(repeated));
  for (const Canvas::Element& part : picture.canvas.elements()) std::visit(writer, part);
  return out + "</svg>\n";
}

}  // namespace

std::string svg_file(const Picture& picture, std::string_view title) {
  return element(picture, title, "<style>" + style_sheet() + "</style>\n", {});
}

std::string svg_part(const Picture& picture, std::string_view title) {
  return element(picture, title, "", repeated_courses(picture.canvas));
}

}  // namespace loadpath::draw
