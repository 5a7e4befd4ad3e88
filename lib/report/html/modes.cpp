// The first page: how the machine's failure modes came out.
#include "lib/quantity/format.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/report/html/html.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report::page {
namespace {

std::string subject(const Mode& mode, const std::set<std::string>& anchors) {
  const std::string step = escaped(mode.step);
  const std::string linked = anchors.contains(mode.step) ? "<a href=\"#" + step + "\">" + step + "</a>" : step;
  return linked + ": " + escaped(mode.title.text()) + "<br><small>" + escaped(account::reason(mode).text()) +
         "</small>";
}

std::string value(const Mode& mode) {
  return mode.utilisation ? escaped(format_number(*mode.utilisation, 3)) + bar(*mode.utilisation) : "–";
}

std::string table_of(const Modes& rows, const std::set<std::string>& anchors) {
  if (rows.empty()) return {};
  std::string out = "<div class=\"scroll\"><table class=\"verdicts\">\n<thead><tr>";
  for (const Message& head : {say("failure mode"), say("utilisation"), say("verdict")}) {
    out += "<th>" + escaped(head.text()) + "</th>";
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const Mode& mode : rows) {
    out += "<tr><td>" + subject(mode, anchors) + "</td><td>" + value(mode) + "</td>" +
           state_cell(mode.state, account::shown(mode).text()) + "</tr>\n";
  }
  out += "</tbody></table></div>\n";
  return out;
}

}  // namespace

std::string conclusion(const Modes& modes) {
  if (modes.empty()) return {};
  std::string out = "<p class=\"conclusion\">" + headline(modes) + "<span>" + escaped(conclusion_of(modes).text());
  if (const Mode* mode = most_utilised(modes)) out += " " + escaped(utilisation(*mode).text());
  return out + "</span></p>\n";
}

std::string doubts(const Modes& modes, const std::set<std::string>& anchors) {
  std::string out = table_of(doubtful(modes), anchors);
  for (const Message& rest : {proved(modes), remote(modes)}) {
    if (!rest.empty()) out += "<p class=\"note\">" + escaped(rest.text()) + "</p>\n";
  }
  return out;
}

std::string passes(const Modes& modes, const std::set<std::string>& anchors) {
  return table_of(passing(modes), anchors);
}

}  // namespace loadpath::report::page
