// A chart with data for its points: that under the pointer, or selected by the arrow keys, is shown in an adjacent
// table.
#include "lib/draw/chart/chart.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report::page {
namespace {

using figure::Chart;

std::string value_row(const Chart::Column& readout, std::size_t k) {
  const bool is_word = !readout.words.empty();
  const std::string unit = readout.unit == "-" ? "" : escaped(pretty_unit(readout.unit));
  return "<tr><th scope=\"row\">" + escaped(readout.name) + "</th><td class=\"number\" data-readout=\"" +
         std::to_string(k) + "\"></td><td>" + (is_word ? "" : unit) + "</td></tr>\n";
}

/// Without scripts it stays hidden; it is not printed.
std::string readout(const Chart& chart) {
  std::string out = "<div class=\"readout\" hidden><p class=\"said\" role=\"status\">" + escaped(say("Point").text()) +
                    " <b data-point></b> <span data-verdict></span></p>\n<table class=\"numbers-now\"><tbody>\n";
  for (std::size_t k = 0; k + 1 < chart.readout.size(); ++k) out += value_row(chart.readout[k], k);
  return out + "</tbody></table>\n<p><code>" + escaped(chart.command) + "<span data-point></span></code></p></div>\n";
}

}  // namespace

std::string chart(const figure::Figure& figure) {
  const Chart& content = *std::get<figure::Charted>(figure.content);
  const draw::InteractiveChart drawn = draw::interactive_chart(figure);
  return "<div class=\"chart\">\n<div class=\"picture\" role=\"group\" aria-label=\"" +
         escaped(say("Arrow keys go from point to point").text()) + "\">" + drawn.svg + "</div>\n" + readout(content) +
         "<script type=\"application/json\">" + drawn.data + "</script>\n</div>\n";
}

}  // namespace loadpath::report::page
