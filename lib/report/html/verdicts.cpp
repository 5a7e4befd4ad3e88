#include "lib/quantity/format.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/markup.hpp"

#include <algorithm>

namespace loadpath::report::page {
namespace {

constexpr double limit_at = 100.0 / 1.2;  // percentage of the bar for a utilisation of 1

std::string subject(const Verdict& row, const std::set<std::string>& anchors) {
  std::string out = escaped(row.step);
  if (anchors.contains(row.step)) out = "<a href=\"#" + out + "\">" + out + "</a>";
  out += (out.empty() ? "" : " ") + symbol(row.symbol);
  for (const Message& text : {row.meaning, row.note}) {
    if (!text.empty()) out += "<br><small>" + escaped(text.text()) + "</small>";
  }
  return out;
}

/// A state in place of a value repeats the verdict.
std::string value(const Verdict& row) {
  if (std::holds_alternative<State>(row.value)) return "–";
  return cell(row.value) + (row.utilisation ? bar(*row.utilisation) : "");
}

}  // namespace

std::string bar(double utilisation) {
  const double percent = std::clamp(limit_at * utilisation, 0.0, 100.0);
  const std::string_view more = utilisation <= 1.0 ? "" : " over";
  return "<span class=\"bar" + std::string(more) + "\" style=\"--u:" + format_number(percent, 3) + "%\"></span>";
}

std::string verdicts(const Verdicts& verdicts, const std::set<std::string>& anchors) {
  if (verdicts.rows.empty()) return {};
  std::string out = "<div class=\"scroll\"><table class=\"verdicts\">\n<thead><tr>";
  for (const Message& head : {say("check"), say("value"), say("condition"), say("verdict")}) {
    out += "<th>" + escaped(head.text()) + "</th>";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const Verdict& row : verdicts.rows) {
    out += "<tr><td>" + subject(row, anchors) + "</td><td>" + value(row) + "</td><td>" + escaped(row.bound.text()) +
           "</td>" + state_cell(row.state, account::shown(row.state).text()) + "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace loadpath::report::page
