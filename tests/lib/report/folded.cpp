// Checks passed by many elements of a list are one row, and nothing else is left out.
#include "lib/report/appendix.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace {

using namespace loadpath;
using account::Quantity;
using account::State;
using account::Verdict;

Verdict row(const char* symbol, double value, State state, bool is_check = true) {
  Verdict v;
  v.step = "shaft", v.symbol = symbol, v.meaning = say("yield");
  if (is_check) v.utilisation = value;
  v.value = Quantity{value, "-", 4};
  v.state = state;
  return v;
}

}  // namespace

TEST_SUITE("report") {
  TEST_CASE("of a check that many elements pass the largest is reported, in place of the first") {
    const auto rows =
        report::folded({row("u_y", 0.9, State::pass), row("sections[1].u_v", 0.1, State::pass),
                        row("sections[1].u_h", 0.5, State::pass), row("sections.seat.u_v", 0.4, State::pass),
                        row("sections[3].u_v", 0.2, State::pass)});
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].symbol == "u_y");
    CHECK(rows[1].symbol == "sections.seat.u_v");
    CHECK(rows[1].note.text() == "largest of 3");
    CHECK(rows[2].symbol == "sections[1].u_h");
  }

  TEST_CASE("a failing check keeps its row, and two are not many") {
    const auto rows = report::folded({row("s[1].u", 0.1, State::pass), row("s[2].u", 1.4, State::fail),
                                      row("s[3].u", 0.2, State::pass), row("s[4].u", 0.3, State::pass),
                                      row("t[1].u", 0.3, State::pass), row("t[2].u", 0.4, State::pass)});
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].symbol == "s[4].u");
    CHECK(rows[1].state == State::fail);
    CHECK(rows[2].symbol == "t[1].u");
  }

  TEST_CASE("of a limit that many elements satisfy the range of the values is reported") {
    const auto rows =
        report::folded({row("s[1].x", 0.3, State::pass, false), row("s[2].x", 0.1, State::pass, false),
                        row("s[3].x", 0.2, State::pass, false), row("s[4].x", 1.2, State::not_covered, false)});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].symbol == "s.x");
    CHECK(std::get<Message>(rows[0].value).text() == "0.1 to 0.3");
    CHECK(rows[1].state == State::not_covered);
  }
}
