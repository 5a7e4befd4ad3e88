#include "lib/draw/canvas/svg_writer.hpp"

#include "lib/draw/canvas/number.hpp"
#include "lib/draw/canvas/style.hpp"
#include "lib/text/markup.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace loadpath::draw {
namespace {

/// Whether the text ends with a number that has a decimal point.
bool ends_with_decimals(std::string_view text) {
  const std::size_t last = text.find_last_not_of("0123456789");
  return last != std::string_view::npos && text[last] == '.';
}

/// Numbers of a path need a separator only before a digit, and before a point that might belong to the number in front.
/// `close`: without a separator before other points, which not every program expects.
void append_coordinate(std::string& out, double value, bool close = false) {
  const bool after_command = (out.back() >= 'a' && out.back() <= 'z') || (out.back() >= 'A' && out.back() <= 'Z');
  const std::size_t at = out.size();
  append_number(out, value);
  const bool begins_itself =
      out[at] == '-' || (close && out[at] == '.' && ends_with_decimals(std::string_view(out).substr(0, at)));
  if (!begins_itself && !after_command) out.insert(at, 1, ' ');
}

/// A file may be enlarged, and other programs read it: hundredths, every attribute by its name. In a page, where a unit
/// is about a pixel: tenths, and the shortest form.
enum class Form { file, page };

/// Lines and arrowheads in a colour of the text, of which it cannot be seen which is drawn first.
bool has_no_order(std::string_view style) {
  constexpr std::array<std::string_view, 5> plain{"thin", "light", "solid", "outline", "centre"};
  return std::find(plain.begin(), plain.end(), style) != plain.end();
}

/// Text without a halo covers no line.
bool covers(const Canvas::Element& element) {
  const auto* const words = std::get_if<Canvas::Words>(&element);
  return words == nullptr || words->style.find("halo") != std::string::npos;
}

/// Paths of one style that become one element.
struct Gathered {
  const Canvas::Element* first;
  std::vector<const Canvas::Path*> paths;
};

/// Dimensions alternate between a line and two arrowheads: those of a style are gathered as long as nothing that covers
/// them comes between.
std::vector<Gathered> gathered(const std::vector<Canvas::Element>& elements) {
  std::vector<Gathered> all;
  std::vector<std::pair<std::string_view, std::size_t>> open;  // style, place in `all`
  for (const Canvas::Element& element : elements) {
    const auto* const path = std::get_if<Canvas::Path>(&element);
    if (path == nullptr || !has_no_order(path->style)) {
      if (covers(element)) open.clear();
      all.push_back({&element, {}});
      continue;
    }
    const auto found = std::find_if(open.begin(), open.end(), [&](const auto& o) { return o.first == path->style; });
    if (found != open.end()) {
      all[found->second].paths.push_back(path);
    } else {
      open.emplace_back(path->style, all.size());
      all.push_back({&element, {path}});
    }
  }
  return all;
}

/// Writes element after element.
class Svg {
 public:
  explicit Svg(std::string& body, Form form) : body_(body), form_(form) {}

  void operator()(const Canvas::Path& path) { paths({&path}); }
  void paths(const std::vector<const Canvas::Path*>& all) {
    open("path", all.front()->style);
    body_ += " d=\"";
    for (const Canvas::Path* path : all) data(*path);
    body_ += "\"/>\n";
  }
  void operator()(const Canvas::Strokes& many) {
    open("path", many.style);
    body_ += " d=\"";
    for (const auto& [from, to] : many.strokes) stroke(from, to);
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
    const bool is_middle = words.anchor == Anchor::middle, is_placed = words.anchor != Anchor::start;
    open("text", words.style, !is_placed || form_ == Form::file ? "" : is_middle ? "mid" : "end");
    attribute("x", words.at.x);
    attribute("y", words.at.y);
    if (is_placed && form_ == Form::file) body_ += is_middle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
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
  void open(std::string_view element, std::string_view style, std::string_view more = {}) {
    body_.append("<").append(element).append(" class=\"").append(style);
    if (!style.empty() && !more.empty()) body_ += ' ';
    body_.append(more).append("\"");
  }
  void attribute(std::string_view name, double value) {
    body_.append(" ").append(name).append("=\"");
    append_number(body_, rounded(value));
    body_ += '"';
  }
  void coordinates(Point at) {
    append_coordinate(body_, rounded(at.x), form_ == Form::page);
    append_coordinate(body_, rounded(at.y), form_ == Form::page);
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

  void stroke(Point from, Point to) {
    body_ += 'M';
    coordinates(from);
    if (form_ == Form::page) return void(step(rounded(to) - rounded(from), ' '));
    body_ += 'L';
    coordinates(to);
  }
  /// Returns the command, which the next step need not repeat. A level or upright step is one number.
  char step(Point by, char before) {
    const bool is_level = std::fabs(by.y) < least, is_upright = std::fabs(by.x) < least;
    const char command = form_ == Form::file ? 'l' : is_level ? 'h' : is_upright ? 'v' : 'l';
    if (command != before) body_ += command;
    if (command != 'v') append_coordinate(body_, rounded(by.x), form_ == Form::page);
    if (command != 'h') append_coordinate(body_, rounded(by.y), form_ == Form::page);
    return command;
  }
  void data(const Canvas::Path& path) {
    body_ += 'M';
    Point last;
    char command = ' ';
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const Point p = rounded(path.points[i]);
      if (i == 0)
        coordinates(p);
      else
        command = step(p - last, command);
      last = p;
    }
    if (path.closed) body_ += 'z';
  }
  [[nodiscard]] Point rounded(Point p) const { return {rounded(p.x), rounded(p.y)}; }
  [[nodiscard]] double rounded(double value) const {
    const double parts = form_ == Form::page ? 10.0 : 100.0;
    return std::round(parts * value) / parts;
  }

  static constexpr double least = 1e-6;  // of a difference between rounded coordinates

  std::string& body_;
  Form form_;
};

/// Scripts move the parts of groups, each from its exact place.
bool is_still(const Picture& picture) {
  return std::ranges::none_of(picture.canvas.elements(), [](const Canvas::Element& element) {
    return std::holds_alternative<Canvas::GroupBegin>(element);
  });
}

void append_elements(std::string& out, const Picture& picture, bool in_page) {
  const bool is_short = in_page && is_still(picture);
  Svg writer(out, is_short ? Form::page : Form::file);
  if (!is_short) {
    for (const Canvas::Element& part : picture.canvas.elements()) std::visit(writer, part);
    return;
  }
  for (const Gathered& parts : gathered(picture.canvas.elements())) {
    if (parts.paths.empty())
      std::visit(writer, *parts.first);
    else
      writer.paths(parts.paths);
  }
}

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
  append_elements(out, picture, style.empty());
  return out + "</svg>\n";
}

}  // namespace

std::string svg_file(const Picture& picture, std::string_view title) {
  return element(picture, title, "<style>" + style_sheet() + "</style>\n");
}

std::string svg_part(const Picture& picture, std::string_view title) { return element(picture, title, ""); }

}  // namespace loadpath::draw
