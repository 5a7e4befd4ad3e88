// Whether everybody can read the reports, by the rules of axe-core: scripts/axe.sh fetches it and names it.
#include "lib/toml/tree.hpp"
#include "tests/browser/examples.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace loadpath;
using namespace loadpath::test;

namespace {

/// Serious findings, a line each; rules by WCAG 2 A and AA, and best practice.
const std::string findings = R"(axe.run(document, RULES).then((all) => all.violations
  .filter((v) => v.impact === "serious" || v.impact === "critical")
  .map((v) => `${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 120)).join(" ; ")}`)
  .join("\n")))";

/// Only colours change with the light, and places with the width.
struct Look {
  int width;
  bool dark;
  std::string rules;
};
const Look looks[] = {
    {1280, false, "{}"},
    {1280, true, R"({ runOnly: ["color-contrast"] })"},
    {390, false, R"({ runOnly: ["scrollable-region-focusable", "target-size"] })"},
};

std::string findings_by(const std::string& rules) {
  std::string expression = findings;
  return expression.replace(expression.find("RULES"), 5, rules);
}

}  // namespace

TEST_SUITE("accessibility") {
  TEST_CASE("no serious finding in reports of every kind, light, dark or narrow") {
    const char* const axe = std::getenv("LOADPATH_AXE");
    if (axe == nullptr || browser_there().empty()) {
      MESSAGE("skipped: LOADPATH_AXE names no axe-core, or no Chromium");
      return;
    }
    std::string script;
    REQUIRE(toml::read_file(axe, script));
    const Desk desk;
    Browser browser;
    for (const char* const example :
         {"slotted-lever", "air-receiver", "fan-belt", "shouldered-shaft", "load-history"}) {
      const std::string name = example;
      CAPTURE(name);
      REQUIRE(write_report(desk, name, "r.html"));
      for (const Look& look : looks) {
        CAPTURE(look.width);
        CAPTURE(look.dark);
        browser.look(look.width, 900, look.dark);
        browser.open(address_of(desk, "r.html"));
        browser.value(script + "; 0");
        CHECK(text_of(browser, findings_by(look.rules)) == "");
      }
    }
  }
}
