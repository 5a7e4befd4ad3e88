#include "lib/text/latex.hpp"

#include "lib/draw/tikz.hpp"
#include "lib/draw/tikz/style.hpp"
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
  std::string operator()(const draw::Figure& figure) { return pictured(draw::tikz(figure), say(figure.caption)); }
  std::string operator()(const draw::Flow& flow) {
    if (flow.parts.empty()) return {};
    return pictured(draw::flow_tikz(flow), say("Load path: loads between the steps"));
  }

  std::string front(const Document& document) {
    const auto linked = [this](const std::string& step) { return link(step); };
    std::string out = "\\lptitle{" + latex_text(document.title) + "}\n";
    for (const auto& [name, text] : document.meta)
      out += "\\lpmeta{" + latex_text(name.text()) + "}{" + latex_text(text) + "}\n";
    return out + "\n" + tex::conclusion(document.summary) + tex::table(document.chosen) +
           tex::doubts(document.summary, linked) + (*this)(document.path) + tex::passes(document.summary, linked) +
           (listed_headings(document).empty() ? "" : "\\tableofcontents\n\n");
  }

 private:
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
  const std::string foot = document.meta.empty() ? "" : latex_text(document.meta.back().second);
  return "\\hypersetup{pdftitle={" + latex_text(document.title) + "}}\n\\pagestyle{fancy}\n\\fancyhf{}\n" +
         "\\renewcommand{\\headrulewidth}{0pt}\n\\fancyhead[L]{\\parbox[b]{\\textwidth}{\\raggedright\\footnotesize" +
         "\\color{lpmuted}" + latex_text(document.title) + "}}\n\\fancyfoot[L]{\\footnotesize\\color{lpmuted}" + foot +
         "}\n\\fancyfoot[R]{\\footnotesize\\color{lpmuted}\\thepage}\n" + "\\fancypagestyle{first}{\\fancyhead{}}\n";
}

}  // namespace

std::string latex(const Document& document) {
  Writer writer(document);
  std::string body = "\\begin{document}\n\\thispagestyle{first}\n" + writer.front(document);
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
