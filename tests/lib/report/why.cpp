#include "lib/report/why.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace loadpath;
using account::Account;
using account::Derived;

namespace {

account::Entry result(const std::string& path, Role role = Role::result) {
  account::Entry entry;
  entry.path = path;
  entry.role = role;
  return entry;
}

/// A line without a formula takes its value from another.
Derived line(const std::string& element, const std::string& symbol, double si, const std::string& formula = "",
             std::vector<account::Step::Given> given = {}) {
  return {element, {symbol, formula, std::move(given), {si, "-"}, {}}, element};
}

std::vector<std::string> symbols_of(const std::vector<Derived>& lines) {
  std::vector<std::string> symbols;
  for (const Derived& each : lines) symbols.push_back(each.element + "." + each.step.symbol);
  return symbols;
}

/// Two of three sections written out, with the safety of one by two methods.
Account shaft() {
  Account shaft;
  for (const char* name : {"a", "b", "c"}) {
    shaft.results.push_back(result(std::string("sections.") + name + ".u_v", Role::check));
    shaft.results.push_back(result(std::string("safeties.") + name + ".u_D", Role::check));
  }
  shaft.derivation = {line("", "n", 50.0),
                      line("sections.a", "tau", 3.0, "T / W"),
                      line("sections.a", "u_v", 0.6, "tau / 5", {{"tau", 3.0, "-"}}),
                      line("sections.b", "tau", 3.0, "T / W"),
                      line("sections.b", "u_v", 0.6, "tau / 5", {{"tau", 3.0, "-"}}),
                      line("safeties.b", "tau", 3.0),
                      line("safeties.b", "n_other", 4.0, "12 / tau", {{"tau", 3.0, "-"}}),
                      line("safeties.b", "u_D", 0.75, "tau / 4", {{"tau", 3.0, "-"}})};
  account::Mode yield, fatigue;
  yield.governs = "sections.a.u_v", yield.state = account::State::pass, yield.utilisation = 0.6;
  fatigue.governs = "safeties.b.u_D", fatigue.state = account::State::pass, fatigue.utilisation = 0.75;
  shaft.modes = {yield, fatigue};
  return shaft;
}

}  // namespace

TEST_SUITE("why") {
  TEST_CASE("an element takes its values from others of its name, not from a neighbour with the same number") {
    const auto lines = report::reasons_of(shaft(), "safeties.b.u_D").lines;
    CHECK(symbols_of(lines) == std::vector<std::string>{"sections.b.tau", "safeties.b.tau", "safeties.b.u_D"});
  }

  TEST_CASE("of elements that a calculator writes out selectively a report has the governing ones") {
    const std::vector<std::string> decides{".n", "sections.b.tau", "safeties.b.tau", "safeties.b.u_D"};
    CHECK(symbols_of(report::deciding_lines(shaft())) == decides);
    Account failing = shaft();
    failing.modes[0].state = account::State::fail;
    const std::vector<std::string> fails{".n", "sections.a.tau", "sections.a.u_v"};
    CHECK(symbols_of(report::deciding_lines(failing)) == fails);
  }

  TEST_CASE("where all elements are written out each keeps the inputs of its check") {
    Account all = shaft();
    std::erase_if(all.results, [](const account::Entry& e) { return e.path.find(".c.") != std::string::npos; });
    std::erase_if(all.results, [](const account::Entry& e) { return e.path.starts_with("safeties.a"); });
    CHECK(report::deciding_lines(all).size() == all.derivation.size() - 1);  // but for the other method
    for (account::Entry& e : all.results) e.role = Role::result;
    CHECK(report::deciding_lines(all).size() == all.derivation.size());
  }
}
