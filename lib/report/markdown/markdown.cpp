#include "lib/account/conclusion.hpp"
#include "lib/draw/svg.hpp"
#include "lib/formula/formula.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/report/markdown/text.hpp"
#include "lib/report/numbers/numbers.hpp"
#include "lib/report/worked.hpp"

#include <algorithm>

namespace loadpath::report {
namespace {

using md::Grid;
using md::inline_math;
using md::text;

std::string symbol(std::string_view path) {
  const NamedSymbol named = named_symbol(path);
  const std::string where = named.where.empty() ? "" : text(named.where) + " ";
  return where + (is_word(named.symbol) ? text(named.symbol) : inline_math(formula::symbol_tex(named.symbol)));
}

std::string marked(State s, const std::string& words) {
  const std::string name = text(words);
  return mark(s) + (s == State::fail ? " **" + name + "**" : " " + name);
}

std::string state(State s) { return marked(s, account::shown(s).text()); }

struct CellText {
  std::string operator()(const std::string& words) const { return text(words); }
  std::string operator()(const Message& message) const { return text(message.text()); }
  std::string operator()(const Quantity& q) const { return text(formula::quantity_plain(written(q))); }
  std::string operator()(const Symbol& s) const { return symbol(s.name); }
  std::string operator()(State s) const { return state(s); }
  std::string operator()(const Utilisation& u) const { return text(utilisation_text(u.value)); }
  std::string operator()(const Sized& s) const { return "**" + text(s.text) + "**\\*" + text(s.behind()); }
};
std::string cell(const Cell& cell) { return std::visit(CellText{}, cell); }

std::string verdicts(const Verdicts& verdicts) {
  if (verdicts.rows.empty()) return {};
  Grid grid{{text(say("check").text()), text(say("value").text()), text(say("condition").text()),
             text(say("verdict").text())},
            {},
            {false, true, false, false}};
  for (const Verdict& row : verdicts.rows) {
    std::string subject = text(row.step) + (row.step.empty() ? "" : " ") + symbol(row.symbol);
    for (const Message& more : {row.meaning, row.note}) {
      if (!more.empty()) subject += "; " + text(more.text());
    }
    const bool repeats = std::holds_alternative<State>(row.value);
    grid.rows.push_back({subject, repeats ? "–" : cell(row.value), text(row.bound.text()), state(row.state)});
  }
  return md::table(grid);
}

std::string conclusion(const Modes& all) {
  if (all.empty()) return {};
  std::string out = marked(account::overall(all), account::word(account::conclude(all).headline)) + ": " +
                    text(conclusion_of(all).text());
  if (const Mode* mode = most_utilised(all)) out += " " + text(utilisation(*mode).text());
  return out + "\n\n";
}

std::string table_of(const Modes& rows) {
  if (rows.empty()) return {};
  Grid grid{{text(say("failure mode").text()), text(say("utilisation").text()), text(say("verdict").text())},
            {},
            {false, true, false}};
  for (const Mode& mode : rows) {
    const std::string subject = mode.step + ": " + mode.title.text() + "; " + account::reason(mode).text();
    const std::string value = mode.utilisation ? format_number(*mode.utilisation, 3) : "–";
    grid.rows.push_back({text(subject), text(value), marked(mode.state, account::shown(mode).text())});
  }
  return md::table(grid);
}

/// Each that does not pass in a row, those excluded by proof and those that are open and remote in a line each.
std::string doubts(const Modes& all) {
  std::string out = table_of(doubtful(all));
  for (const Message& words : {proved(all), remote(all)}) out += words.empty() ? "" : text(words.text()) + "\n\n";
  return out;
}

/// The formula on one line; its numbers, if they differ, on the next.
std::string equation(const Step& step) {
  const std::string left = formula::symbol_tex(named_symbol(step.symbol).symbol);
  const std::string value = formula::quantity_tex(written(step.value));
  const Worked w = worked(step);
  if (!w.tree) return left + " = " + value;
  const std::string symbolic = formula::tex(*w.tree, {}, w.known);
  const std::string numeric = formula::tex(*w.tree, w.substituted, w.known);
  if (symbolic == value) return left + " = " + value;
  if (numeric == symbolic || numeric == value) return left + " = " + symbolic + " = " + value;
  return "\\begin{aligned}\n" + left + " &= " + symbolic + " \\cr\n&= " + numeric + " = " + value + "\n\\end{aligned}";
}

std::string step_text(const Step& step) {
  std::string out = step.why.empty() ? "" : text(step.why.text()) + ":\n\n";
  if (!step.formula.empty() && !formula::parse(step.formula)) out += md::code(step.formula) + "\n\n";
  return out + "$$\n" + equation(step) + "\n$$\n\n";
}

/// Writes block after block and collects the figures.
class Writer {
 public:
  Writer(std::string_view stem, Markdown& out) : stem_(stem), out_(out) {}

  void operator()(const Heading& heading) {
    out_.text += (heading.level <= 2 ? "## " : "### ") + numbering_.heading(heading.level) + " " + text(heading.text);
    out_.text += "\n\n";
  }
  void operator()(const Paragraph& paragraph) {
    const bool warns = paragraph.tone == Paragraph::Tone::warning;
    out_.text += (warns ? "> **" + text(say("Warning:").text()) + "** " : "") + text(paragraph.text.text()) + "\n\n";
  }
  void operator()(const Table& table) {
    if (!table.caption.empty()) out_.text += caption("Table", numbering_.table(), table.caption) + "\n\n";
    Grid grid{{}, {}, numeric_columns(table)};
    for (const Message& head : table.head) {
      grid.head.push_back(is_symbol(head) ? symbol(head.args[0].text()) : text(head.text()));
    }
    for (const auto& row : table.rows) {
      grid.rows.emplace_back();
      for (const Cell& c : row) grid.rows.back().push_back(cell(c));
    }
    out_.text += md::table(grid);
  }
  void operator()(const Derivation& derivation) {
    for (const Step& step : derivation.steps) out_.text += step_text(step);
  }
  void operator()(const Verdicts& rows) { out_.text += verdicts(rows); }
  void operator()(const draw::Flow& flow) {
    const std::string caption = say("Load path: loads between the steps").text();
    add_figure("path", caption, draw::flow_file(flow, caption));
  }
  void operator()(const figure::Figure& figure) {
    add_figure(figure.id, say(figure.caption).text(), draw::svg(figure));
  }

  void operator()(const Page& page) {
    for (const Band& band : page.bands) {
      for (const Stack& stack : band) {
        for (const Panel& panel : stack.panels) add(panel, page.is_numbered);
      }
    }
  }
  void begin_appendix() {
    numbering_.begin_appendix();
    out_.text += "# " + text(say("Appendix").text()) + "\n\n";
  }

 private:
  void add(const Panel& panel, bool is_numbered) {
    if (!panel.title.empty()) {
      out_.text += "## " + (is_numbered ? numbering_.heading(2) + " " : std::string()) + text(panel.title.text());
      out_.text += (panel.remark.empty() ? "" : " (" + text(panel.remark.text()) + ")") + "\n\n";
    }
    for (const Block& block : panel.blocks) std::visit(*this, block);
  }
  void add_figure(const std::string& id, const std::string& words_of_it, std::string svg) {
    const int number = numbering_.figure();
    const std::string words = caption("Figure", number, say("{1}", words_of_it));
    std::string name = stem_ + "-" + std::to_string(number) + "-" + id + ".svg";
    out_.text += "![" + text(words_of_it) + "](" + md::address(name) + ")\n\n" + words + "\n\n";
    out_.figures.emplace_back(std::move(name), std::move(svg));
  }

  static std::string caption(std::string_view kind, int number, const Message& words) {
    return "**" + text(say("{1} {2}", kind, std::to_string(number)).text()) + ".** " + text(words.text());
  }

  std::string stem_;
  Markdown& out_;
  Numbering numbering_;
};

std::string meta(const Document& document) {
  std::string out;
  for (const auto& [name, value] : document.meta) out += "- " + text(name.text()) + ": " + text(value) + "\n";
  return out.empty() ? out : out + "\n";
}

std::string title_block(const TitleBlock& block) {
  std::string out;
  const auto add = [&](const std::string& name, const std::string& value) {
    out += "- " + text(name) + ": " + text(value.empty() ? say("not given").text() : value) + "\n";
  };
  for (const TitleBlock::Field& field : block.subject) add(field.name.text(), field.text);
  for (const TitleBlock::Field& field : block.number) add(field.name.text(), field.text);
  constexpr const char* line_to_sign = "____________________";
  for (const TitleBlock::Signature& one : block.signatures)
    out += "- " + text(one.role.text()) + ": " + (one.name.empty() ? line_to_sign : text(one.name)) + "\n";
  return out + "\n";
}

std::string finding(const Finding& finding) {
  return marked(finding.state, account::word(finding.headline)) + ": " + text(finding.text.text()) + "\n\n";
}

/// Sizes, all failure modes and the load path.
void add_overview(const Document& document, Markdown& out, Writer& writer) {
  if (!document.chosen.rows.empty()) writer(document.chosen);
  out.text += doubts(document.summary);
  if (!document.path.parts.empty()) writer(document.path);
  out.text += table_of(passing(document.summary));
}

void add_input(const Document& document, Markdown& out, Writer& writer) {
  if (document.input.empty()) return;
  writer(Heading{2, say("Input").text(), "input"});
  for (std::size_t at = 0; at < document.input.size();) {  // indented: nothing in it can end the block
    const std::size_t end = std::min(document.input.find('\n', at), document.input.size());
    out.text += "    " + document.input.substr(at, end - at) + "\n";
    at = end + 1;
  }
}

void add_pages(const Document& document, Markdown& out, Writer& writer) {
  out.text += title_block(document.heading) + finding(document.finding);
  for (const Page& page : document.pages) writer(page);
  if (!document.has_appendix) return;
  writer.begin_appendix();
  out.text += meta(document);
  writer(Heading{2, say("Failure modes").text(), "failure-modes"});
  out.text += text(tally(document.summary).text()) + "\n\n";
}

}  // namespace

Markdown markdown(const Document& document, std::string_view stem) {
  Markdown out;
  out.text = "# " + text(document.title) + "\n\n";
  Writer writer(stem, out);
  if (document.pages.empty())
    out.text += meta(document) + conclusion(document.summary);
  else
    add_pages(document, out, writer);
  if (!document.has_appendix) return out;
  add_overview(document, out, writer);
  for (const Block& block : document.blocks) std::visit(writer, block);
  add_input(document, out, writer);
  return out;
}

}  // namespace loadpath::report
