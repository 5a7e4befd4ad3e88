#include "lib/report/html/html.hpp"

#include "lib/draw/page.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/embedded.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report {
namespace {

std::string numbered(std::string_view kind, int number, const Message& caption) {
  const std::string label = say("{1} {2}", kind, std::to_string(number)).text();
  return "<b>" + escaped(label) + ".</b> " + escaped(caption.text());
}

/// Writes block after block; numbers run through the page.
class Writer {
 public:
  explicit Writer(const Document& document) {
    for (const Block& block : document.blocks) {
      if (const auto* heading = std::get_if<Heading>(&block)) anchors_.insert(heading->anchor);
    }
  }

  std::string front(const Document& document) {
    std::string out = "<header>\n<h1>" + escaped(document.title) + "</h1>\n<dl class=\"meta\">\n";
    for (const auto& [name, text] : document.meta) {
      out += "<div><dt>" + escaped(name.text()) + "</dt><dd>" + escaped(text) + "</dd></div>\n";
    }
    out += "</dl>\n</header>\n" + page::conclusion(document.summary);
    if (!document.chosen.rows.empty()) out += (*this)(document.chosen);
    return out + page::doubts(document.summary, anchors_) + path(document.path) +
           page::passes(document.summary, anchors_) + contents(document);
  }

  std::string operator()(const Heading& heading) {
    const std::string tag = heading.level <= 2 ? "h2" : "h3";
    const std::string anchor = heading.anchor.empty() ? "" : " id=\"" + escaped(heading.anchor) + "\"";
    return "<" + tag + anchor + "><span class=\"no\">" + numbering_.heading(heading.level) + "</span> " +
           escaped(heading.text) + "</" + tag + ">\n";
  }
  std::string operator()(const Paragraph& paragraph) {
    const std::string text = escaped(paragraph.text.text());
    switch (paragraph.tone) {
      case Paragraph::Tone::plain:
        return "<p>" + text + "</p>\n";
      case Paragraph::Tone::note:
        return "<p class=\"note\">" + text + "</p>\n";
      case Paragraph::Tone::warning:
        return "<p class=\"warning\"><b>" + escaped(say("Warning:").text()) + "</b> " + text + "</p>\n";
    }
    return {};
  }
  std::string operator()(const Table& table) {
    if (table.caption.empty()) return page::table(table, "");
    return page::table(table, "<p class=\"caption\">" + numbered("Table", numbering_.table(), table.caption) + "</p>");
  }
  std::string operator()(const Derivation& derivation) { return page::derivation(derivation); }
  std::string operator()(const Verdicts& verdicts) { return page::verdicts(verdicts, {}); }
  std::string operator()(const draw::Figure& figure) {
    const bool moves = std::holds_alternative<draw::Motion>(figure.content);
    const bool tells = std::holds_alternative<draw::Charted>(figure.content);
    has_motion_ = has_motion_ || moves;
    has_chart_ = has_chart_ || tells;
    return (moves   ? "<figure class=\"moving\">" + page::motion(figure)
            : tells ? "<figure>" + page::chart(figure)
                    : "<figure>" + draw::svg_in_page(figure)) +
           "<figcaption>" + numbered("Figure", numbering_.figure(), say(figure.caption)) + "</figcaption></figure>\n";
  }
  std::string appendix(const std::string& input) {
    if (input.empty()) return {};
    return (*this)(Heading{2, say("Input").text(), "input"}) + "<pre class=\"input\" tabindex=\"0\">" + escaped(input) +
           "</pre>\n";
  }
  /// The pictures in the page are those of the printed frame. To show another frame the script moves every part from
  /// there.
  [[nodiscard]] std::string script() const {
    const auto script_of = [](bool wanted, std::string_view name) {
      return wanted ? "<script>\n" + std::string(embedded::asset(name)) + "</script>\n" : "";
    };
    return script_of(true, "scroll.js") + script_of(has_motion_, "motion.js") + script_of(has_chart_, "chart.js");
  }

 private:
  std::string path(const draw::Flow& flow) {
    if (flow.parts.empty()) return {};
    const Message caption = say("Load path: loads between the steps");
    return "<figure class=\"path\">" + draw::flow_in_page(flow, caption.text()) + "<figcaption>" +
           numbered("Figure", numbering_.figure(), caption) + "</figcaption></figure>\n";
  }
  static std::string contents(const Document& document) {
    const std::vector<const Heading*> headings = listed_headings(document);
    if (headings.empty()) return {};
    Numbering numbering;
    std::string out = "<nav aria-label=\"" + escaped(say("Contents").text()) + "\"><ol>\n";
    for (const Heading* heading : headings) {
      out += "<li><span class=\"no\">" + numbering.heading(2) + "</span> <a href=\"#" + escaped(heading->anchor) +
             "\">" + escaped(heading->text) + "</a></li>\n";
    }
    if (!document.input.empty())
      out += "<li><span class=\"no\">" + numbering.heading(2) + "</span> <a href=\"#input\">" +
             escaped(say("Input").text()) + "</a></li>\n";
    return out + "</ol></nav>\n";
  }

  std::set<std::string> anchors_;
  Numbering numbering_;
  bool has_motion_ = false, has_chart_ = false;
};

}  // namespace

std::string html(const Document& document) {
  const std::string footer = document.meta.empty() ? "" : document.meta.back().second;
  Writer writer(document);
  std::string out =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
      escaped(document.title) + "</title>\n<style>\n" + page::style(document.title, footer, document.paper) +
      "</style>\n</head>\n<body>\n" + std::string(page::shapes()) + "<main>\n" + writer.front(document);
  for (const Block& block : document.blocks) out += std::visit([&](const auto& b) { return writer(b); }, block);
  out += writer.appendix(document.input);
  return out + "</main>\n" + writer.script() + "</body>\n</html>\n";
}

}  // namespace loadpath::report
