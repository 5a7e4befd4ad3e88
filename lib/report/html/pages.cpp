// The title block and the verdict at the head of page 1.
#include "lib/report/html/html.hpp"
#include "lib/text/markup.hpp"

namespace loadpath::report::page {
namespace {

std::string text_or_not_given(const std::string& text) {
  return text.empty() ? "<span class=\"none\">" + escaped(say("not given").text()) + "</span>" : escaped(text);
}

std::string field(const TitleBlock::Field& field, const std::string& printed) {
  const bool is_date = field.name.id == "Date" && field.text.empty();
  return "<div><dt>" + escaped(field.name.text()) + "</dt><dd>" + text_or_not_given(is_date ? printed : field.text) +
         "</dd></div>\n";
}

std::string fields(const std::vector<TitleBlock::Field>& all, const std::string& printed) {
  std::string out = "<dl>\n";
  for (const TitleBlock::Field& one : all) out += field(one, printed);
  return out + "</dl>\n";
}

std::string signatures(const std::vector<TitleBlock::Signature>& all) {
  std::string out = "<table class=\"signatures\"><thead><tr><td></td><th scope=\"col\">" +
                    escaped(say("Name and signature").text()) + "</th><th scope=\"col\">" +
                    escaped(say("Date").text()) + "</th></tr></thead>\n<tbody>\n";
  for (const TitleBlock::Signature& one : all) {
    out += "<tr><th scope=\"row\">" + escaped(one.role.text()) + "</th><td>" + escaped(one.name) + "</td><td>" +
           escaped(one.date) + "</td></tr>\n";
  }
  return out + "</tbody></table>\n";
}

}  // namespace

std::string title_block(const Document& document) {
  const TitleBlock& block = document.heading;
  const Message kind = document.has_appendix ? say("Design calculation") : say("Design calculation, short report");
  return "<header class=\"title-block\">\n<div class=\"subject\"><p class=\"kind\">" + escaped(kind.text()) +
         "</p>\n<h1>" + escaped(document.title) + "</h1>\n" + fields(block.subject, {}) + "</div>\n<div>" +
         fields(block.number, block.printed) + "</div>\n<div>" + signatures(block.signatures) + "</div>\n</header>\n";
}

std::string finding(const Finding& finding) {
  return "<p class=\"finding " + slug(finding.state) + "\"><b>" + escaped(account::word(finding.headline)) + "</b> " +
         prose(finding.text.text()) + "</p>\n";
}

}  // namespace loadpath::report::page
