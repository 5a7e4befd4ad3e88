#include "lib/text/latex.hpp"

#include "lib/draw/tikz.hpp"
#include "lib/draw/tikz/style.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/report/document.hpp"
#include "lib/report/latex/letters.hpp"
#include "lib/report/latex/tex.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/embedded.hpp"

#include <map>

namespace loadpath::report {
namespace {

/// Writes block after block. LaTeX numbers headings, tables and figures itself.
class Writer {
 public:
  explicit Writer(const Document& document) {
    for (const Block& block : document.blocks) {
      const auto* heading = std::get_if<Heading>(&block);
      if (heading != nullptr && !heading->anchor.empty()) anchors_.emplace(heading->anchor, anchors_.size());
    }
  }

  std::string operator()(const Page& page) {
    std::string out;
    for (const Band& band : page.bands) {
      for (const Stack& stack : band) {
        for (const Panel& panel : stack.panels) out += panel_of(panel, page.is_numbered);
      }
    }
    return out;
  }
  std::string operator()(const Heading& heading) {
    const auto anchor = anchors_.find(heading.anchor);
    const std::string target =
        anchor == anchors_.end() ? "" : "\\hypertarget{lp" + std::to_string(anchor->second) + "}{}";
    return "\n\\" + std::string(heading.level <= 2 ? "section" : "subsection") + "{" + latex_text(heading.text) + "}" +
           target + "\n\n";
  }
  std::string operator()(const Paragraph& paragraph) {
    const std::string text = latex_text(paragraph.text.text());
    switch (paragraph.tone) {
      case Paragraph::Tone::plain:
        return text + "\n\n";
      case Paragraph::Tone::note:
        return "\\lpnote{" + text + "}\n\n";
      case Paragraph::Tone::warning:
        return "\\lpwarning{" + latex_text(say("Warning:").text()) + "}{" + text + "}\n\n";
    }
    return {};
  }
  std::string operator()(const Table& table) { return tex::table(table); }
  std::string operator()(const Derivation& derivation) { return tex::derivation(derivation); }
  std::string operator()(const Verdicts& verdicts) { return tex::verdicts(verdicts, latex_text); }
  std::string operator()(const figure::Figure& figure) { return pictured(draw::tikz(figure), say(figure.caption)); }
  std::string operator()(const draw::Flow& flow) {
    if (flow.parts.empty()) return {};
    return pictured(draw::flow_tikz(flow), say("Load path: loads between the steps"));
  }

  std::string front(const Document& document) {
    std::string out = title(document) + meta(document) + "\n" + tex::conclusion(document.summary);
    return out + overview(document) + contents(document);
  }

  std::string pages(const Document& document) {
    std::string out = title(document) + title_block(document.heading) + "\n" + tex::finding(document.finding);
    for (const Page& page : document.pages) out += (*this)(page);
    if (!document.has_appendix) return out;
    out += "\\lpappendix{" + latex_text(say("Appendix").text()) + "}\n" + meta(document) + contents(document);
    out += (*this)(Heading{2, say("Failure modes").text(), ""});
    return out + "\\lpnote{" + latex_text(tally(document.summary).text()) + "}\n\n" + overview(document);
  }

 private:
  static std::string title(const Document& document) { return "\\lptitle{" + latex_text(document.title) + "}\n"; }
  static std::string meta_line(const std::string& name, const std::string& text) {
    return "\\lpmeta{" + latex_text(name) + "}{" + latex_text(text) + "}\n";
  }
  static std::string meta(const Document& document) {
    std::string out;
    for (const auto& [name, text] : document.meta) out += meta_line(name.text(), text);
    return out;
  }
  static std::string contents(const Document& document) {
    return listed_headings(document).empty() ? "" : "\\tableofcontents\n\n";
  }
  std::string overview(const Document& document) {
    const auto linked = [this](const std::string& step) { return link(step); };
    return tex::table(document.chosen) + tex::doubts(document.summary, linked) + (*this)(document.path) +
           tex::passes(document.summary, linked);
  }
  static std::string title_block(const TitleBlock& block) {
    std::string out;
    for (const auto* const fields : {&block.subject, &block.number}) {
      for (const TitleBlock::Field& field : *fields)
        out += meta_line(field.name.text(), field.text.empty() ? say("not given").text() : field.text);
    }
    Table signatures{{}, {Message{}, say("name"), say("date"), say("signature")}, {}};
    for (const TitleBlock::Signature& one : block.signatures)
      signatures.rows.push_back({one.role, one.name, one.date, std::string()});
    return out + "\n" + tex::table(signatures);
  }
  std::string panel_of(const Panel& panel, bool is_numbered) {
    std::string out;
    if (!panel.title.empty())
      out = "\n\\" + std::string(is_numbered ? "section{" : "section*{") + latex_text(panel.title.text()) + "}\n\n";
    if (!panel.remark.empty()) out += "\\lpnote{" + latex_text(panel.remark.text()) + "}\n\n";
    for (const Block& block : panel.blocks) out += std::visit(*this, block);
    return out;
  }

  [[nodiscard]] std::string link(const std::string& step) const {
    const auto anchor = anchors_.find(step);
    const std::string words = latex_text(step);
    return anchor == anchors_.end() ? words : "\\hyperlink{lp" + std::to_string(anchor->second) + "}{" + words + "}";
  }
  static std::string pictured(const std::string& picture, const Message& caption) {
    return "\\begin{lpfigure}{" + latex_text(caption.text()) + "}\n" + picture + "\n\\end{lpfigure}\n\n";
  }

  std::map<std::string, std::size_t, std::less<>> anchors_;
};

/// Title and program at the head and foot of every page.
std::string running(const Document& document) {
  const std::string foot = latex_text(document.program);
  return "\\hypersetup{pdftitle={" + latex_text(document.title) + "}}\n\\pagestyle{fancy}\n\\fancyhf{}\n" +
         "\\renewcommand{\\headrulewidth}{0pt}\n\\fancyhead[L]{\\parbox[b]{\\textwidth}{\\raggedright\\footnotesize" +
         "\\color{lpmuted}" + latex_text(document.title) + "}}\n\\fancyfoot[L]{\\footnotesize\\color{lpmuted}" + foot +
         "}\n\\fancyfoot[R]{\\footnotesize\\color{lpmuted}\\thepage}\n" + "\\fancypagestyle{first}{\\fancyhead{}}\n";
}

}  // namespace

std::string latex(const Document& document) {
  Writer writer(document);
  std::string body = "\\begin{document}\n\\thispagestyle{first}\n" +
                     (document.pages.empty() ? writer.front(document) : writer.pages(document));
  for (const Block& block : document.blocks) body += std::visit(writer, block);
  if (!document.input.empty()) body += writer(Heading{2, say("Input").text(), ""}) + tex::listing(document.input);
  body += "\\end{document}\n";
  const std::string head = running(document);
  return std::string("% To be set by pdflatex, twice: the second time it knows the widths of all tables.\n") +
         "\\documentclass[10pt," + (document.paper == "letter" ? "letterpaper" : "a4paper") + "]{article}\n" +
         std::string(embedded::asset("report.tex")) + "\n" + draw::tikz_styles() + tex::declared_letters(head + body) +
         "\n" + head + body;
}

}  // namespace loadpath::report
