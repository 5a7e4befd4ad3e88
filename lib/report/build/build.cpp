#include "lib/report/build/build.hpp"

#include "lib/report/answer.hpp"
#include "lib/report/brief/brief.hpp"
#include "lib/report/fingerprint.hpp"

namespace loadpath::report {

namespace {

using project::Project;

/// The lines at the head of the appendix; the texts of the heading are in the title block.
void add_meta(const Project& project, const std::string& input, Document& document) {
  document.meta.emplace_back(say("Project file"), project.file);
  if (project.strict)
    document.meta.emplace_back(say("Strict"),
                               say("failure modes not considered count as not assessed (--strict)").text());
  if (!input.empty()) document.meta.emplace_back(say("Input"), input);
  document.meta.emplace_back(say("Program"), document.program);
}

void add_appendix(const Project& project, Detail detail, std::string_view input, const ShownFigures& shown,
                  Document& document) {
  document.chosen = chosen_table(project);
  document.path = load_path(project);
  document.blocks = appendix_blocks(project, detail, shown);
  if (detail == Detail::full) document.input = input;
}

}  // namespace

Document build(const Project& project, std::string_view program, Detail detail, std::string_view input) {
  const std::string name = input.empty() ? std::string() : fingerprint(input, project);
  const Summary summary = summarise(project);
  Document document;
  document.title = project.title.empty() ? project.file : project.title;
  document.paper = project.paper;
  document.program = program;
  document.summary = summary.modes;
  document.heading = title_block(project, summary, name);
  document.finding = finding_of(summary);
  add_meta(project, name, document);
  Brief brief = brief_of(project, summary);
  document.pages = std::move(brief.pages);
  document.has_appendix = detail != Detail::brief;
  if (document.has_appendix) add_appendix(project, detail, input, brief.shown, document);
  return document;
}

}  // namespace loadpath::report
