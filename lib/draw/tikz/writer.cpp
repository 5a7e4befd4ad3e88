#include "lib/draw/tikz/writer.hpp"

#include "lib/draw/canvas/number.hpp"
#include "lib/draw/tikz/style.hpp"
#include "lib/text/latex.hpp"

#include <numbers>

namespace loadpath::draw {
namespace {

constexpr std::size_t line_length = 110;      // length of a line of the source
constexpr std::size_t strokes_of_path = 200;  // TeX keeps an entire path in its memory
constexpr double farthest = 5000.0;           // it has no lengths beyond 5.7 m

bool is_hidden(const Canvas::GroupBegin& group) {
  for (const auto& [name, value] : group.attributes) {
    if (name == "visibility" && value == "hidden") return true;
  }
  return false;
}

/// Writes element after element, except hidden groups, which are for scripts of a page.
class Tikz {
 public:
  explicit Tikz(std::string& out) : out_(out) {}

  void operator()(const Canvas::Path& path) {
    begin(path.style);
    for (std::size_t i = 0; i < path.points.size(); ++i) step(i == 0 ? " " : " -- ", path.points[i]);
    end(path.closed ? " -- cycle;\n" : ";\n");
  }
  void operator()(const Canvas::Strokes& many) {
    for (std::size_t i = 0; i < many.strokes.size(); ++i) {
      if (i % strokes_of_path == 0) begin(many.style);
      step(" ", many.strokes[i].first);
      step(" -- ", many.strokes[i].second);
      if (i % strokes_of_path == strokes_of_path - 1 || i + 1 == many.strokes.size()) end(";\n");
    }
  }
  void operator()(const Canvas::Dots& dots) {
    Canvas::Strokes without_length{dots.style, {}};
    for (const Point& place : dots.places) without_length.strokes.emplace_back(place, place);
    (*this)(without_length);
  }
  void operator()(const Canvas::Circle& circle) {
    begin(circle.style);
    step(" ", circle.centre);
    end(" circle[radius=" + text_of(circle.radius) + "];\n");
  }
  void operator()(const Canvas::Arc& arc) {
    const Point from = arc.centre + arc.radius * Point{std::cos(arc.start), -std::sin(arc.start)};
    begin(arc.style);
    step(" ", from);  // angles are counted from x to y, which points downwards
    end(" arc[start angle=" + degrees(-arc.start) + ",delta angle=" + degrees(-arc.sweep) +
        ",radius=" + text_of(arc.radius) + "];\n");
  }
  void operator()(const Canvas::Rectangle& rectangle) {
    begin(rectangle.style);
    step(" ", {rectangle.box.left, rectangle.box.top});
    step(" rectangle ", {rectangle.box.right, rectangle.box.bottom});
    end(";\n");
  }
  void operator()(const Canvas::Words& words) {
    if (hidden_ > 0) return;
    out_ += "\\node[" + tikz_words(words.style) + ",anchor=base";
    if (words.anchor != Anchor::middle) out_ += words.anchor == Anchor::start ? " west" : " east";
    if (words.turned) out_ += ",rotate=90";
    out_ += "] at ";
    coordinates(words.at);
    out_ += has_halo(words.style) ? " {\\lphalo{" : " {";
    for (const Run& run : words.text) add(run);
    out_ += has_halo(words.style) ? "}};\n" : "};\n";
  }
  void operator()(const Canvas::GroupBegin& group) {
    if (hidden_ > 0 || is_hidden(group)) ++hidden_;
  }
  void operator()(const Canvas::GroupEnd&) {
    if (hidden_ > 0) --hidden_;
  }

 private:
  static std::string text_of(double value) {
    std::string out;
    append_number(out, value, farthest);
    return out;
  }
  static std::string degrees(double radians) { return text_of(180.0 / std::numbers::pi * radians); }

  void begin(std::string_view style) {
    line_ = out_.size();
    if (hidden_ == 0) out_ += "\\path[" + tikz_style(style) + "]";
  }
  void end(std::string_view words) {
    if (hidden_ == 0) out_ += words;
  }
  void step(std::string_view before, Point to) {
    if (hidden_ > 0) return;
    if (out_.size() - line_ > line_length) {
      out_ += "\n ";
      line_ = out_.size();
    }
    out_ += before;
    coordinates(to);
  }
  void coordinates(Point at) {
    out_ += '(';
    append_number(out_, at.x, farthest);
    out_ += ',';
    append_number(out_, at.y, farthest);
    out_ += ')';
  }
  void add(const Run& run) {
    const std::string text = latex_text(run.text);
    switch (run.face) {
      case Run::Face::words:
        out_ += text;
        break;
      case Run::Face::symbol:
        out_ += "$" + text + "$";
        break;
      case Run::Face::subscript:
        out_ += "\\textsubscript{" + text + "}";
        break;
    }
  }

  std::string& out_;
  std::size_t line_ = 0;
  int hidden_ = 0;
};

}  // namespace

std::string tikz(const Picture& picture) {
  std::string out = "\\begin{tikzpicture}[lp picture]\n\\path[use as bounding box,clip] (0,0) rectangle (";
  append_number(out, picture.width, farthest);
  out += ',';
  append_number(out, std::round(picture.height), farthest);
  out += ");\n";
  Tikz writer(out);
  for (const Canvas::Element& element : picture.canvas.elements()) std::visit(writer, element);
  return out + "\\end{tikzpicture}";
}

}  // namespace loadpath::draw
