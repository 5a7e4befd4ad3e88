// Small documents for the writers' tests.
#pragma once

#include "lib/report/document.hpp"

#include <string>

namespace loadpath::report {

inline Step torsion_step() {
  return {"tau",
          "T / (2.0 * W)",
          {{"T", 600.0, "N*m"}, {"W", 24.5e-6, "mm^3"}},
          {12.245e6, "MPa", 4},
          say("at the surface")};
}

inline Verdict check(double u, State state) {
  Verdict row;
  row.step = "shaft";
  row.symbol = "u_tau";
  row.meaning = say("torsion alone");
  row.utilisation = u;
  row.value = Quantity{u, "-", 4};
  row.bound = say("passes at 1 or less");
  row.state = state;
  return row;
}

inline Mode mode(double u, State state) {
  Mode row;
  row.step = "shaft";
  row.id = "yield";
  row.title = say("yield in torsion");
  row.governs = "u_tau";
  row.utilisation = u;
  row.state = state;
  return row;
}

inline Document shaft_document() {
  Document document;
  document.title = "Shaft";
  document.meta = {{say("Project file"), "shaft.toml"}, {say("Program"), "loadpath 1.0"}};
  document.summary = {mode(0.83, State::pass)};
  document.blocks = {Heading{2, "Shaft", "shaft"}, Heading{3, "Calculation", "shaft-calculation"},
                     Derivation{{torsion_step()}}};
  return document;
}

/// Two pages and an appendix.
inline Document paged_document() {
  Document document = shaft_document();
  document.heading.subject = {{say("Company"), "Seiler & Co"}};
  document.heading.number = {{say("Revision"), ""}, {say("Date"), ""}, {say("Input"), "da4e7fac"}};
  document.heading.signatures = {{say("Checked"), "Ada", ""}};
  document.finding = {account::Headline::pass, State::pass, say("1 failure mode assessed.")};
  const Table sizes{{}, {say("Component"), say("Size")}, {{std::string("shaft"), Sized{"45 mm"}}}};
  const Table modes{{}, {say("Failure mode"), say("Utilisation")}, {{std::string("yield"), Utilisation{0.83}}}};
  Page decide;
  decide.bands = {
      {{66.0, {{say("Chosen sizes"), {}, {sizes}}}}, {105.0, {{say("Governing failure modes"), {}, {modes}}}}}};
  decide.is_numbered = false;
  Page check;
  check.bands = {{{1.0, {{say("Input data"), say("given values"), {Paragraph{say("none")}}}}}}};
  document.pages = {decide, check};
  return document;
}

/// Text with special characters of every format; none of it may reach the page as markup.
inline constexpr const char* hostile = "</title></style><script>alert(\"1\")</script> & 'q' \\ { } $x$ a|b `c` *d*";

inline Document hostile_document() {
  Document document;
  document.title = hostile;
  document.meta = {{say("{1}", hostile), hostile}};
  Verdict row = check(2.0, State::fail);
  row.step = row.symbol = hostile;
  row.meaning = row.bound = row.note = say("{1}", hostile);
  row.value = std::string(hostile);
  Mode mode;
  mode.step = mode.id = mode.governs = hostile;
  mode.title = mode.note = say("{1}", hostile);
  mode.utilisation = 2.0;
  mode.state = State::fail;
  document.summary = {mode};
  Step step = torsion_step();
  step.symbol = step.formula = hostile;
  step.why = say("{1}", hostile);
  const figure::Figure figure{"x", hostile, figure::Plot{}};
  document.blocks = {Heading{2, hostile, hostile},
                     Paragraph{say("{1}", hostile)},
                     Paragraph{say("{1}", hostile), Paragraph::Tone::warning},
                     Table{say("{1}", hostile), {say("{1}", hostile)}, {{std::string(hostile)}, {Symbol{hostile}}}},
                     Derivation{{step}},
                     Verdicts{{row}},
                     figure};
  document.heading.subject = {{say("{1}", hostile), hostile}};
  document.heading.number = {{say("{1}", hostile), hostile}};
  document.heading.signatures = {{say("{1}", hostile), hostile, hostile}};
  document.finding = {account::Headline::fail, State::fail, say("{1}", hostile)};
  return document;
}

/// The same with pages.
inline Document hostile_pages() {
  Document document = hostile_document();
  const Table table{{}, {say("{1}", hostile)}, {{Sized{hostile}}, {Utilisation{1.2}}}};
  Page page;
  page.bands = {{{1.0, {{say("{1}", hostile), say("{1}", hostile), {table}}}}}};
  document.pages = {page};
  return document;
}

inline bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// From `from` up to and with `to`.
inline std::string between(const std::string& text, std::string_view from, std::string_view to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(to, begin);
  return end == std::string::npos ? std::string() : text.substr(begin, end + to.size() - begin);
}

}  // namespace loadpath::report
