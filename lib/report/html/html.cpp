#include "lib/report/html/html.hpp"

#include "lib/draw/page.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/conclusion.hpp"
#include "lib/report/worked.hpp"
#include "lib/text/embedded.hpp"
#include "lib/text/markup.hpp"

#include <utility>

namespace loadpath::report {
namespace {

std::string numbered(std::string_view kind, int number, const Message& caption) {
  const std::string label = say("{1} {2}", kind, std::to_string(number)).text();
  return "<b>" + escaped(label) + ".</b> " + escaped(caption.text());
}

/// Whether a page has to leave much height for it: a shaft above its diagrams.
bool is_tall(const figure::Figure& figure) {
  const auto* const shaft = std::get_if<figure::Shaft>(&figure.content);
  return shaft != nullptr && !shaft->diagrams.empty();
}

/// Adds a block; lines of a calculation that follow others continue their list.
void append_block(std::string& page, std::string_view block) {
  constexpr std::string_view begin = "<ul class=\"derivation\">\n", end = "</ul>\n";
  if (page.ends_with(end) && block.starts_with(begin)) {
    page.resize(page.size() - end.size());
    block.remove_prefix(begin.size());
  }
  page += block;
}

/// Writes block after block; numbers run through the page.
class Writer {
 public:
  explicit Writer(const Document& document) {
    for (const Block& block : document.blocks) {
      if (const auto* heading = std::get_if<Heading>(&block)) anchors_.insert(heading->anchor);
    }
  }

  /// The head of a document without pages.
  std::string front(const Document& document) {
    return "<header>\n<h1>" + escaped(document.title) + "</h1>\n" + meta(document) + "</header>\n" +
           page::conclusion(document.summary) + overview(document) + contents(document);
  }

  std::string pages(const Document& document) {
    std::string out;
    for (const Page& one : document.pages) {
      out += "<section class=\"sheet\">\n";
      if (&one == &document.pages.front()) out += page::title_block(document) + page::finding(document.finding);
      for (const Band& band : one.bands) out += written(band, one.is_numbered);
      out += "</section>\n";
    }
    return out;
  }

  /// Section by section, each folded or open.
  std::string appendix(const Document& document, Folding folding) {
    numbering_.begin_appendix();
    folding_ = folding;
    std::string out = "<section class=\"appendix\">\n<h2 class=\"part\" id=\"appendix\">" +
                      escaped(say("Appendix").text()) + "</h2>\n" + meta(document) + contents(document);
    out += section(modes_heading()) + "<p class=\"note\">" + escaped(tally(document.summary).text()) + "</p>\n" +
           overview(document);
    for (const Block& block : document.blocks) {
      const auto* const heading = std::get_if<Heading>(&block);
      const bool begins = heading != nullptr && heading->level <= 2;
      append_block(out, begins ? section(*heading) : std::visit([&](const auto& b) { return (*this)(b); }, block));
    }
    if (!document.input.empty()) out += section(input_heading()) + as_typed(document.input);
    return out + end_of_section() + "</section>\n";
  }

  std::string operator()(const Heading& heading) {
    const std::string tag = heading.level <= 2 ? "h2" : "h3";
    const std::string anchor = heading.anchor.empty() ? "" : " id=\"" + escaped(heading.anchor) + "\"";
    return "<" + tag + anchor + "><span class=\"no\">" + numbering_.heading(heading.level) + "</span> " +
           escaped(heading.text) + "</" + tag + ">\n";
  }
  std::string operator()(const Paragraph& paragraph) {
    const std::string text = page::prose(paragraph.text.text());
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
    if (const auto lines = page::as_lines(table)) return page::derivation(*lines);
    if (table.caption.empty()) return page::table(table, "");
    return page::table(table, "<p class=\"caption\">" + numbered("Table", numbering_.table(), table.caption) + "</p>");
  }
  std::string operator()(const Derivation& derivation) { return page::derivation(derivation); }
  std::string operator()(const Verdicts& verdicts) { return page::verdicts(verdicts, {}); }
  std::string operator()(const figure::Figure& figure) {
    const bool moves = std::holds_alternative<figure::Motion>(figure.content);
    const bool tells = std::holds_alternative<figure::Charted>(figure.content);
    has_motion_ = has_motion_ || moves;
    has_chart_ = has_chart_ || tells;
    return (moves   ? "<figure class=\"moving\">" + page::motion(figure)
            : tells ? "<figure>" + page::chart(figure)
                    : (is_tall(figure) ? "<figure class=\"tall\">" : "<figure>") + draw::svg_in_page(figure)) +
           "<figcaption>" + numbered("Figure", numbering_.figure(), say(figure.caption)) + "</figcaption></figure>\n";
  }
  std::string input(const std::string& text) {
    return text.empty() ? std::string() : (*this)(input_heading()) + as_typed(text);
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
  static Heading modes_heading() { return {2, say("Failure modes").text(), "failure-modes"}; }
  static Heading input_heading() { return {2, say("Input").text(), "input"}; }
  static std::string as_typed(const std::string& text) {
    return "<pre class=\"input\" tabindex=\"0\">" + escaped(text) + "</pre>\n";
  }
  static std::string meta(const Document& document) {
    std::string out = "<dl class=\"meta\">\n";
    for (const auto& [name, text] : document.meta)
      out += "<div><dt>" + escaped(name.text()) + "</dt><dd>" + escaped(text) + "</dd></div>\n";
    return out + "</dl>\n";
  }
  std::string overview(const Document& document) {
    std::string out;
    if (!document.chosen.rows.empty()) out += (*this)(document.chosen);
    return out + page::doubts(document.summary, anchors_) + path(document.path) +
           page::passes(document.summary, anchors_);
  }
  std::string section(const Heading& heading) {
    const std::string begin = end_of_section();
    is_in_section_ = true;
    return begin + (folding_ == Folding::open ? "<details open>" : "<details>") + "<summary>" + (*this)(heading) +
           "</summary>\n";
  }
  std::string end_of_section() { return std::exchange(is_in_section_, false) ? "</details>\n" : ""; }

  std::string written(const Band& band, bool is_numbered) {
    std::string shares, columns;
    for (const Stack& stack : band) {
      shares += (shares.empty() ? "" : " ") + ("minmax(0," + format_number(stack.share, 4) + "fr)");
      columns += "<div>\n";
      for (const Panel& panel : stack.panels) columns += written(panel, is_numbered);
      columns += "</div>\n";
    }
    const std::string style = band.size() > 1 ? " style=\"grid-template-columns:" + shares + "\"" : "";
    return "<div class=\"band\"" + style + ">\n" + columns + "</div>\n";
  }
  std::string written(const Panel& panel, bool is_numbered) {
    std::string out = "<section class=\"panel\">" + heading_of(panel, is_numbered);
    for (const Block& block : panel.blocks)
      append_block(out, std::visit([&](const auto& b) { return (*this)(b); }, block));
    return out + "</section>\n";
  }
  std::string heading_of(const Panel& panel, bool is_numbered) {
    if (panel.title.empty()) return {};
    const std::string number = is_numbered ? "<span class=\"no\">" + numbering_.heading(2) + "</span> " : std::string();
    const std::string remark =
        panel.remark.empty() ? std::string() : " <small>" + escaped(panel.remark.text()) + "</small>";
    return "<h2>" + number + escaped(panel.title.text()) + remark + "</h2>\n";
  }

  std::string path(const draw::Flow& flow) {
    if (flow.parts.empty()) return {};
    const Message caption = say("Load path: loads between the steps");
    return "<figure class=\"path\">" + draw::flow_in_page(flow, caption.text()) + "<figcaption>" +
           numbered("Figure", numbering_.figure(), caption) + "</figcaption></figure>\n";
  }
  static std::string contents(const Document& document) {
    std::vector<const Heading*> headings = listed_headings(document);
    if (headings.empty()) return {};
    const Heading modes = modes_heading(), input = input_heading();
    Numbering numbering;
    if (!document.pages.empty()) {
      numbering.begin_appendix();
      headings.insert(headings.begin(), &modes);
    }
    if (!document.input.empty()) headings.push_back(&input);
    std::string out = "<nav aria-label=\"" + escaped(say("Contents").text()) + "\"><ol>\n";
    for (const Heading* heading : headings) {
      out += "<li><span class=\"no\">" + numbering.heading(2) + "</span> <a href=\"#" + escaped(heading->anchor) +
             "\">" + escaped(heading->text) + "</a></li>\n";
    }
    return out + "</ol></nav>\n";
  }

  std::set<std::string> anchors_;
  Numbering numbering_;
  Folding folding_ = Folding::folded;
  bool is_in_section_ = false, has_motion_ = false, has_chart_ = false;
};

}  // namespace

namespace {

/// A title that leaves room for the rest of the footer in its line.
std::string short_title(const std::string& title) {
  constexpr std::size_t most_letters = 52;
  if (title.size() <= most_letters) return title;
  const std::size_t space = title.rfind(' ', most_letters);
  return space == std::string::npos ? title : title.substr(0, space) + " \u2026";
}

page::Running running_of(const Document& document) {
  const std::string input = document.heading.number.empty() ? std::string() : document.heading.number.back().text;
  const std::string program = document.program;
  return {short_title(document.title), input.empty() ? program : say("{1}, input {2}", program, input).text()};
}

}  // namespace

std::string html(const Document& document, Folding folding) {
  Writer writer(document);
  std::string page;
  if (document.pages.empty()) {
    page += writer.front(document);
    for (const Block& block : document.blocks)
      append_block(page, std::visit([&](const auto& b) { return writer(b); }, block));
    page += writer.input(document.input);
  } else {
    page += writer.pages(document);
    if (document.has_appendix) page += writer.appendix(document, folding);
  }
  const std::string style = page::style(running_of(document), document.paper, page), script = writer.script();
  constexpr std::size_t of_head = 1024;
  std::string out;
  out.reserve(style.size() + page.size() + script.size() + of_head);
  out +=
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>";
  out.append(escaped(document.title)).append("</title>\n<style>").append(style);
  out.append("</style>\n</head>\n<body>\n<main>\n").append(page).append("</main>\n").append(script);
  return out.append("</body>\n</html>\n");
}

}  // namespace loadpath::report
