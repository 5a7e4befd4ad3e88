// Failure modes in lists: their order, their worst state, and the reason that is shown.
#include "lib/account/mode.hpp"

#include "lib/account/account.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace loadpath;
using account::Modes;
using account::State;

account::Mode mode_of(State state, double utilisation = std::nan(""), bool is_assessable = true) {
  account::Mode mode;
  mode.state = state;
  mode.is_assessable = is_assessable;
  if (!std::isnan(utilisation)) mode.utilisation = utilisation;
  return mode;
}

}  // namespace

TEST_SUITE("modes") {
  TEST_CASE("failures come first, then what needs action, passes by their utilisation, and what is not considered") {
    Modes wanted{
        mode_of(State::fail, 1.5),   mode_of(State::fail, 1.2),  mode_of(State::not_available),
        mode_of(State::not_covered), mode_of(State::not_judged), mode_of(State::not_judged, std::nan(""), false),
        mode_of(State::pass, 0.9),   mode_of(State::pass, 0.5),  mode_of(State::pass),
        mode_of(State::accepted),    mode_of(State::open)};
    Modes mixed;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      wanted[i].id = std::to_string(i);
      mixed.insert(i % 2 == 0 ? mixed.begin() : mixed.end(), wanted[i]);
    }
    for (const Modes& modes : {mixed, Modes(wanted.rbegin(), wanted.rend())}) {
      const Modes sorted = account::in_order(modes);
      REQUIRE(sorted.size() == wanted.size());
      for (std::size_t i = 0; i < wanted.size(); ++i) CHECK(sorted[i].id == wanted[i].id);
    }
  }

  TEST_CASE("the worst of no modes is a pass; one that is not considered does not prevent one") {
    CHECK(account::worst(Modes{}) == State::pass);
    CHECK(account::worst(Modes{mode_of(State::accepted)}) == State::accepted);
    CHECK(account::worst(Modes{mode_of(State::pass), mode_of(State::fail), mode_of(State::open)}) == State::fail);
    CHECK(account::passes(Modes{mode_of(State::pass), mode_of(State::open)}));
    CHECK(!account::passes(account::strictly(Modes{mode_of(State::pass), mode_of(State::open)})));
    CHECK(!account::passes(Modes{mode_of(State::not_judged)}));
  }

  TEST_CASE("a mode that no calculator assesses is outside of the scope") {
    CHECK(account::shown(mode_of(State::not_judged, std::nan(""), false)).text() == "outside the scope");
    CHECK(account::shown(mode_of(State::not_judged)).text() == "not assessed");
    CHECK(account::shown(mode_of(State::fail, 2.0, false)).text() == "fail");
  }

  TEST_CASE("the scope names the modes of each state, of remote ones only the number") {
    const auto named = [](State state, const std::string& id, bool is_assessable = true) {
      account::Mode mode = mode_of(state, std::nan(""), is_assessable);
      mode.step = "s";
      mode.id = id;
      return mode;
    };
    account::Mode open = named(State::open, "o");
    open.wants = "w";
    const Modes modes{named(State::pass, "a"), named(State::pass, "b"),     named(State::not_judged, "n"),
                      named(State::open, "r"), named(State::fail, "f"),     named(State::not_judged, "x", false),
                      named(State::open, "t"), named(State::accepted, "c"), open};
    CHECK(account::scope(modes).text() ==
          "fail: s.f; not assessed: s.n; outside the scope: s.x; pass: s.a, s.b; accepted by user: s.c; "
          "not considered: s.o, 2 more");
    CHECK(account::scope({named(State::open, "r")}).text() == "not considered: 1 more");
    CHECK(account::scope({}).text() == "no failure mode is assessed here");
  }

  TEST_CASE("below a list of all modes, many that pass or are open are only counted") {
    const auto scope_of = [](State state, std::size_t count, std::size_t remote = 0) {
      Modes modes;
      for (std::size_t i = 0; i < count + remote; ++i) {
        modes.push_back(mode_of(state));
        modes.back().step = "s";
        modes.back().id = "m";
        if (i < count) modes.back().wants = "w";
      }
      return account::brief_scope(modes).text();
    };
    const auto named = [](const std::string& state, int count) {
      std::string text = state + ": s.m";
      for (int i = 1; i < count; ++i) text += ", s.m";
      return text;
    };
    CHECK(scope_of(State::pass, 8) == named("pass", 8));
    CHECK(scope_of(State::pass, 9) == "pass: 9 failure modes listed above");
    CHECK(scope_of(State::open, 4) == named("not considered", 4));
    CHECK(scope_of(State::open, 4, 3) == named("not considered", 4) + ", 3 more");
    CHECK(scope_of(State::open, 5) == "not considered: 5 failure modes listed above");
    CHECK(scope_of(State::accepted, 9) == named("accepted by user", 9));
    CHECK(scope_of(State::fail, 12) == named("fail", 12));
    CHECK(scope_of(State::not_judged, 12) == named("not assessed", 12));
  }

  TEST_CASE("the reason is what governs, a note, or what to add, in this order") {
    const auto reason = [](const auto& change) {
      account::Mode mode = mode_of(State::not_judged);
      change(mode);
      return account::reason(mode).text();
    };
    CHECK(reason([](account::Mode&) {}) == "no calculator assesses it");
    CHECK(reason([](account::Mode& m) { m.add = "b"; }) == "add a step of b");
    CHECK(reason([](account::Mode& m) { m.use = "u", m.add = "b"; }) == "replace with a step of u");
    CHECK(reason([](account::Mode& m) { m.judge = "j", m.use = "u", m.add = "b"; }) == "add a step of j");
    CHECK(reason([](account::Mode& m) { m.wants = "w", m.judge = "j"; }) == "give w");
    CHECK(reason([](account::Mode& m) { m.wants = "w", m.add = "b"; }) == "give w (by a step of b)");
    CHECK(reason([](account::Mode& m) { m.note = say("n"), m.wants = "w"; }) == "n");
    CHECK(reason([](account::Mode& m) { m.governs = "g"; }) == "g");
    CHECK(reason([](account::Mode& m) { m.governs = "g", m.note = say("n"); }) == "g n");
  }

  TEST_CASE("a mode without any sign that it concerns the part is remote") {
    const auto is_remote = [](State state, const auto& change) {
      account::Mode mode = mode_of(state);
      change(mode);
      return account::is_remote(mode);
    };
    CHECK(is_remote(State::open, [](account::Mode&) {}));
    CHECK(!is_remote(State::not_judged, [](account::Mode&) {}));
    CHECK(!is_remote(State::pass, [](account::Mode&) {}));
    CHECK(!is_remote(State::open, [](account::Mode& m) { m.wants = "w"; }));
    CHECK(!is_remote(State::open, [](account::Mode& m) { m.judge = "j"; }));
    CHECK(!is_remote(State::open, [](account::Mode& m) { m.note = say("n"); }));
  }

  TEST_CASE("an entry is open if it has numbers, and none of them is known") {
    const auto entry = [](std::vector<double> si, const std::string& word = "") {
      account::Entry one;
      one.value.si = {si.begin(), si.end()};
      one.word = word;
      return account::is_open(one);
    };
    CHECK(entry({std::nan("")}));
    CHECK(entry({std::nan(""), std::nan("")}));
    CHECK(!entry({std::nan(""), 1.0}));
    CHECK(!entry({1.0}));
    CHECK(!entry({}));
    CHECK(!entry({std::nan("")}, "smooth"));
  }
}
