#include "lib/draw/chart/chart.hpp"

#include "lib/draw/canvas/svg_writer.hpp"
#include "lib/draw/chart/picture.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

namespace loadpath::draw {
namespace {

/// A JSON text that may be embedded in a page: '<' cannot end its script.
std::string json_text(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (code < 0x20 || c == '<') {
      out += "\\u00";
      out += digits[code >> 4];
      out += digits[code & 15];
    } else {
      out += c;
    }
  }
  return out + "\"";
}

template <class Write>
std::string list(std::size_t count, const Write& write) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + write(i);
  return text + "]";
}

/// Tenths of a view unit, as integers.
std::string tenths(double at) { return std::to_string(std::lround(10.0 * at)); }

/// Numbers as one text, words as a list and numbers of them.
std::string column(const figure::Chart::Column& readout, const std::vector<std::size_t>& dots) {
  std::string texts;
  for (const std::size_t dot : dots)
    texts += (texts.empty() ? "" : " ") +
             (readout.words.empty() ? value_text(readout, dot) : std::to_string(std::lround(readout.si[dot])));
  return "[" + list(readout.words.size(), [&](std::size_t i) { return json_text(readout.words[i]); }) + "," +
         json_text(texts) + "]";
}

}  // namespace

std::string value_text(const figure::Chart::Column& readout, std::size_t dot) {
  const double si = readout.si[dot];
  if (!std::isfinite(si)) return "–";
  if (!readout.words.empty()) return readout.words[static_cast<std::size_t>(si)];
  return format_number(in_unit(si, readout.unit), 5);
}

InteractiveChart interactive_chart(const figure::Figure& figure) {
  const figure::Chart& chart = *std::get<figure::Charted>(figure.content);
  ChartPicture drawn = chart_picture(chart);
  std::vector<std::size_t> dots;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < drawn.places.size(); ++i) {
    if (i == chart.shown) shown = dots.size();
    if (drawn.places[i]) dots.push_back(i);
  }
  drawn.picture.canvas.begin_group({{"data-here", ""}, {"visibility", "hidden"}});
  drawn.picture.canvas.circle("here", {0.0, 0.0}, 7.0);
  drawn.picture.canvas.end_group();
  const auto place = [&](std::size_t i) { return *drawn.places[dots[i]]; };
  InteractiveChart out;
  out.svg = svg_part(drawn.picture, say(figure.caption).text());
  out.data =
      "{\"shown\":" + std::to_string(dots.empty() ? 0 : std::min(shown, dots.size() - 1)) +
      ",\n\"x\":" + list(dots.size(), [&](std::size_t i) { return tenths(place(i).x); }) +
      ",\n\"y\":" + list(dots.size(), [&](std::size_t i) { return tenths(place(i).y); }) +
      ",\n\"points\":" + list(dots.size(), [&](std::size_t i) { return std::to_string(chart.points[dots[i]]); }) +
      ",\n\"readout\":" + list(chart.readout.size(), [&](std::size_t k) { return column(chart.readout[k], dots); }) +
      "}";
  return out;
}

}  // namespace loadpath::draw
