// Verdicts, and how the machine's failure modes came out.
#include "lib/quantity/format.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/report/latex/tex.hpp"
#include "lib/text/latex.hpp"

#include <initializer_list>

namespace loadpath::report::tex {
namespace {

std::string row_of(std::initializer_list<std::string> cells) {
  std::string out;
  for (const std::string& cell : cells) out += (out.empty() ? "" : " & ") + cell;
  return out + " \\\\[1pt]\n";
}

std::string framed(const std::string& columns, const std::string& head, const std::string& rows) {
  return "{\\small\n\\begin{longtable}{@{}" + columns + "@{}}\n\\toprule\n" + head + "\\midrule\n\\endhead\n" +
         "\\bottomrule\n\\endfoot\n" + rows + "\\end{longtable}}\\lpuncounted\n\n";
}

std::string below(const Message& text) {
  return text.empty() ? "" : "\\newline\\lpsmall{" + latex_text(text.text()) + "}";
}

std::string table_of(const Modes& modes, const Linked& linked) {
  if (modes.empty()) return {};
  std::string rows;
  for (const Mode& mode : modes) {
    rows += row_of({linked(mode.step) + ": " + latex_text(mode.title.text()) + below(account::reason(mode)),
                    mode.utilisation ? latex_text(format_number(*mode.utilisation, 3)) : "–", state_of(mode)});
  }
  return framed("L{0.68\\linewidth}rl",
                row_of({latex_text(say("failure mode").text()), latex_text(say("utilisation").text()),
                        latex_text(say("verdict").text())}),
                rows);
}

/// A state in place of a value repeats the verdict.
std::string value(const Verdict& row) { return std::holds_alternative<State>(row.value) ? "–" : cell(row.value); }

std::string subject(const Verdict& row, const Linked& linked) {
  return (row.step.empty() ? "" : linked(row.step) + " ") + symbol(row.symbol) + below(row.meaning) + below(row.note);
}

}  // namespace

std::string verdicts(const Verdicts& verdicts, const Linked& linked) {
  if (verdicts.rows.empty()) return {};
  std::string rows;
  for (const Verdict& row : verdicts.rows) {
    rows += row_of({subject(row, linked), value(row), latex_text(row.bound.text()), state(row.state)});
  }
  return framed("L{0.42\\linewidth}R{0.16\\linewidth}L{0.19\\linewidth}l",
                row_of({latex_text(say("check").text()), latex_text(say("value").text()),
                        latex_text(say("condition").text()), latex_text(say("verdict").text())}),
                rows);
}

std::string conclusion(const Modes& modes) {
  if (modes.empty()) return {};
  std::string out = "\\lpconclusion{" + headline(modes) + ": " + latex_text(conclusion_of(modes).text());
  if (const Mode* mode = most_utilised(modes)) out += " " + latex_text(utilisation(*mode).text());
  return out + "}\n\n";
}

std::string doubts(const Modes& modes, const Linked& linked) {
  std::string out = table_of(doubtful(modes), linked);
  for (const Message& rest : {proved(modes), remote(modes)}) {
    if (!rest.empty()) out += "\\lpnote{" + latex_text(rest.text()) + "}\n\n";
  }
  return out;
}

std::string passes(const Modes& modes, const Linked& linked) { return table_of(passing(modes), linked); }

}  // namespace loadpath::report::tex
