// What the headline says, in the room that it has.
#include "lib/account/conclusion.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::account;

account::Mode mode_with(State state, const std::string& title = "yield", bool is_assessable = true) {
  account::Mode mode;
  mode.step = "part";
  mode.id = "mode";
  mode.title = say("{1}", title);
  mode.state = state;
  mode.is_assessable = is_assessable;
  return mode;
}

/// Each of the wordings where it just has room, and the last one where none has.
void check_wordings(const Modes& modes, const std::vector<std::string>& wordings, const std::string& subject = "") {
  for (const std::string& wording : wordings) CHECK(explanation(modes, {wording.size(), subject}).text() == wording);
  CHECK(explanation(modes, {1, subject}).text() == wordings.back());
}

}  // namespace

TEST_SUITE("conclusions") {
  TEST_CASE("a failure is named with its utilisation and what is compared, as far as there is room") {
    account::Mode fails = mode_with(State::fail, "tooth root (gear 1)");
    check_wordings({fails}, {"part: tooth root (gear 1)", "part: tooth root"});
    check_wordings({fails}, {"tooth root (gear 1)", "tooth root"}, "gears");
    fails.utilisation = 1.0652;
    check_wordings({fails}, {"part: tooth root (gear 1), utilisation 1.065", "part: tooth root, utilisation 1.065",
                             "part: utilisation 1.065"});
    fails.compared = Compared{{277e6, "MPa"}, {260e6, "MPa"}};
    check_wordings(
        {fails}, {"part: tooth root (gear 1), utilisation 1.065 (277 / 260 MPa)",
                  "part: tooth root, utilisation 1.065 (277 / 260 MPa)", "part: tooth root (gear 1), utilisation 1.065",
                  "part: tooth root, utilisation 1.065", "part: utilisation 1.065"});
    CHECK(explanation({fails, mode_with(State::not_covered), fails}).text() ==
          "part: tooth root (gear 1), utilisation 1.065 (277 / 260 MPa); and 1 more");
  }

  TEST_CASE("a mode that another step has assessed counts there") {
    account::Mode there = mode_with(State::pass);
    there.judge = "shaft.key";
    CHECK(is_assessed_elsewhere(there));
    CHECK(conclude({there}).modes() == 0);
    CHECK(conclude({there, mode_with(State::pass)}).count(account::Group::passes) == 1);
    there.state = State::fail;
    CHECK(conclude({there}).modes() == 0);
    CHECK(explanation({there, mode_with(State::fail)}).text() == "part: yield");
    there.state = State::not_available;  // it did not come out there
    CHECK(is_assessed_elsewhere(there));
    CHECK(conclude({there}).modes() == 1);
    for (const State waits : {State::open, State::not_judged}) {
      there.state = waits;
      CHECK_FALSE(is_assessed_elsewhere(there));
      CHECK(conclude({there}).modes() == 1);
    }
    there.state = State::pass;
    there.governs = "u_F";
    CHECK_FALSE(is_assessed_elsewhere(there));
    CHECK(conclude({there}).modes() == 1);
  }

  TEST_CASE("gaps are counted among the modes that were considered") {
    const account::Mode needs = mode_with(State::not_judged), outside = mode_with(State::not_judged, "wear", false);
    const account::Mode passed = mode_with(State::pass), open = mode_with(State::open);
    check_wordings({outside, passed, open},
                   {"1 of 2 failure modes is outside the scope of loadpath", "1 of 2 failure modes outside the scope"});
    check_wordings({outside, outside, passed}, {"2 of 3 failure modes are outside the scope of loadpath",
                                                "2 of 3 failure modes outside the scope"});
    check_wordings({needs, passed},
                   {"1 of 2 failure modes needs input or another step", "1 of 2 failure modes needs input"});
    check_wordings({needs, needs},
                   {"2 of 2 failure modes need input or another step", "2 of 2 failure modes need input"});
    check_wordings({needs, needs, outside, passed}, {"2 of 4 failure modes need input or a step, 1 outside the scope",
                                                     "2 of 4 need input or a step, 1 outside"});
    account::Mode input = mode_with(State::not_available, "every input");
    input.subject = Subject::input;
    input.note = say("the load of the bolt is not known");
    check_wordings({input, passed}, {"part: the load of the bolt is not known", "part: every input"});
  }

  TEST_CASE("a search without a result says what was nearest where there is room") {
    account::Mode search = mode_with(State::not_available);
    search.subject = Subject::search;
    search.note = say("no size passes, nearest 95 mm: u = 1.055");
    check_wordings({search, mode_with(State::pass)},
                   {"part: no size passes, nearest 95 mm: u = 1.055", "part: no size passes"});
  }

  TEST_CASE("a pass says which strengths were not considered: fatigue first, and what a calculator assesses") {
    const account::Mode passed = mode_with(State::pass);
    const auto open = [](const char* title, bool is_assessable = true) {
      return mode_with(State::open, title, is_assessable);
    };
    account::Mode wear = open("wear");
    wear.kind = ModeKind::special;
    const Modes three{passed, open("bending (of the web)"), open("torsion"), open("fatigue, at shoulders"), wear};
    check_wordings(three, {"1 failure mode assessed; fatigue, bending and torsion not considered",
                           "1 failure mode assessed; fatigue and 2 more not considered",
                           "1 failure mode assessed; 3 not considered"});
    check_wordings(three,
                   {"torsion only; fatigue, bending and torsion not considered",
                    "torsion only; fatigue, bending and 1 more not considered",
                    "torsion only; fatigue and 2 more not considered", "torsion only; 3 not considered"},
                   "torsion");
    CHECK(explanation({passed, passed, open("fatigue"), open("fatigue"), open("creep", false)}).text() ==
          "2 failure modes assessed; fatigue not considered");
    CHECK(explanation({passed, open("creep", false), open("impact", false)}).text() ==
          "1 failure mode assessed; creep and impact not considered");
    CHECK(explanation({passed, wear}, {120, "torsion"}).text() == "1 failure mode assessed");
    CHECK(explanation({open("fatigue")}).text() == "no failure mode is assessed here");
  }

  TEST_CASE("the utilisation of a limit or of a shape is the highest one only where it fails") {
    account::Mode mode = mode_with(State::pass);
    CHECK(is_ranked(mode));
    mode.is_limit = true;
    CHECK_FALSE(is_ranked(mode));
    mode.state = State::fail;
    CHECK(is_ranked(mode));
    mode.is_limit = false;
    mode.kind = ModeKind::shape;
    CHECK(is_ranked(mode));
    mode.state = State::pass;
    CHECK_FALSE(is_ranked(mode));
  }

  TEST_CASE("a gap that another calculator closes names it") {
    account::Mode mode = mode_with(State::open);
    mode.use = "shaft.design";
    CHECK(account::reason(mode).text() == "replace with a step of shaft.design");
    mode.judge = "shaft.key";
    CHECK(account::reason(mode).text() == "add a step of shaft.key");
  }
}
