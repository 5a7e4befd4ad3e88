// The rules of verdicts, against what they say in words, and columns against the rules.
#include "lib/account/fold.hpp"

#include "lib/account/conclusion.hpp"
#include "lib/account/rows.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::account;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array all_states{State::pass,        State::accepted,      State::open, State::not_judged,
                                State::not_covered, State::not_available, State::fail};

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

account::Mode mode_of(State state, bool is_assessable = true) {
  account::Mode mode;
  mode.step = "part";
  mode.id = "mode";
  mode.state = state;
  mode.is_assessable = is_assessable;
  return mode;
}

}  // namespace

TEST_SUITE("fold") {
  TEST_CASE("a state is as bad as its place among all, and its number in a column is that place") {
    for (std::size_t i = 0; i < all_states.size(); ++i) {
      CHECK(rank(all_states[i]) == static_cast<int>(i));
      CHECK(number(all_states[i]) == static_cast<double>(i));
      CHECK(state_of(static_cast<double>(i)) == all_states[i]);
      for (std::size_t j = 0; j < all_states.size(); ++j)
        CHECK(account::worse(all_states[i], all_states[j]) == all_states[std::max(i, j)]);
    }
    CHECK(pass_if(true) == State::pass);
    CHECK(pass_if(false) == State::fail);
  }

  TEST_CASE("a load acts if it is given and not zero; a search may round a size down") {
    CHECK(acts(-2.0));
    CHECK(acts(1e-300));
    CHECK_FALSE(acts(0.0));
    CHECK_FALSE(acts(none));
    CHECK(least_candidate(40.0) < 40.0);
    CHECK(least_candidate(40.0) > 39.9999);
  }

  TEST_CASE("the row of a check or limit without a value has no result, or does not exist where it is optional") {
    FieldInfo row{};
    row.role = Role::check;
    CHECK(state_of_row(row, none) == State::not_available);
    CHECK_FALSE(is_kept(row, none));
    CHECK(state_of_row(row, 0.5) == State::pass);
    CHECK(is_kept(row, 0.5));
    CHECK(state_of_row(row, 1.5) == State::fail);
    CHECK_FALSE(is_kept(row, 1.5));
    row.where_set = true;
    CHECK_FALSE(state_of_row(row, none).has_value());
    CHECK(is_kept(row, none));
    row.role = Role::limit;
    row.bounds = Range{2.0, 3.0, false, false};
    CHECK(state_of_row(row, 0.5) == State::not_covered);
    CHECK(state_of_row(row, 2.5) == State::pass);
    CHECK_FALSE(is_kept(row, 0.5));
    row.is_criterion = true;
    CHECK(state_of_row(row, 0.5) == State::fail);
  }

  TEST_CASE("a check passes from 0 to 1, and is beyond its method below 0") {
    CHECK(state_of_check(0.0) == State::pass);
    CHECK(state_of_check(1.0) == State::pass);
    CHECK(state_of_check(1.0 + 1e-10) == State::pass);
    CHECK(state_of_check(1.0 + 1e-8) == State::fail);
    CHECK(state_of_check(-1e-10) == State::pass);
    CHECK(state_of_check(-1e-8) == State::not_covered);
    CHECK(is_passed(0.5));
    CHECK(is_passed(-rounding_of_utilisation));
    CHECK(is_passed(1.0 + rounding_of_utilisation));
    CHECK_FALSE(is_passed(1.1));
  }

  TEST_CASE("a limit is the range of a method, a criterion one of the part") {
    const Range open_below{0.0, 2.0, true, false};
    CHECK(state_of_limit(open_below, false, 2.0) == State::pass);
    CHECK(state_of_limit(open_below, false, 0.0) == State::not_covered);
    CHECK(state_of_limit(open_below, true, 0.0) == State::fail);
    CHECK(state_of_limit(open_below, true, 2.1) == State::fail);
  }

  TEST_CASE("of several values of a limit the one farthest beyond a bound is reported, else the nearest to one") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto farthest = [](const Range& bounds, std::vector<double> si) { return farthest_from(bounds, si); };
    const Range between{1.0, 3.0, false, false}, from_zero{0.0, 10.0, false, false}, above{0.0, infinity, true, false};
    CHECK(farthest(between, {0.5, 2.0, 3.2}) == 0.5);  // 0.5 below, 0.2 above
    CHECK(farthest(between, {0.9, 2.0, 3.2}) == 3.2);
    CHECK(farthest(between, {2.0, 1.3, 2.9}) == 2.9);  // 0.1 from a bound
    CHECK(farthest(between, {2.0, 1.1, 2.8}) == 1.1);
    CHECK(farthest(from_zero, {0.0, 4.0, 1.0}) == 4.0);  // no quantity without a sign is near its zero
    CHECK(farthest(from_zero, {9.0, -0.1}) == -0.1);
    CHECK(farthest(above, {5.0, 2.0, 7.0}) == 2.0);
    CHECK(std::isnan(farthest(between, {4.0, none, 2.0})));
  }

  TEST_CASE("the worst row governs, of several worst the one with the highest utilisation") {
    Folded rows;
    CHECK(rows.worst == absent_state);
    rows = rows.with_row(number(State::pass), 0.4, true);
    rows = rows.with_row(number(State::pass), 0.9, true);
    rows = rows.with_row(number(State::pass), 0.6, true);
    CHECK(rows.worst == number(State::pass));
    CHECK(rows.utilisation == 0.9);
    CHECK(rows.counted == 1.0);
    rows = rows.with_row(number(State::not_covered), none, false);
    CHECK(rows.worst == number(State::not_covered));
    CHECK(std::isnan(rows.utilisation));
    rows = rows.with_row(number(State::fail), 1.2, true).with_row(number(State::fail), 1.1, true);
    CHECK(rows.worst == number(State::fail));
    CHECK(rows.utilisation == 1.2);
    const Folded limit = Folded{}.with_row(number(State::pass), none, false);
    CHECK(limit.counted == 0.0);
    CHECK(limit.with_row(number(State::pass), 0.4, true).utilisation == 0.4);
    CHECK(limit.with_row(number(State::pass), 0.4, true).with_row(number(State::pass), none, false).utilisation == 0.4);
    const Folded absent = Folded{}.with_row(absent_state, none, true);
    CHECK(absent.worst == absent_state);
    CHECK(absent.counted == 0.0);
  }

  TEST_CASE("modes without a deciding row get their state by whether they apply") {
    Unjudged by;
    by.state = {number(State::not_judged), number(State::open), number(State::not_judged)};
    const Folded nothing;
    CHECK(judged(nothing, 0.0, by).state == absent_state);
    CHECK(judged(nothing, 1.0, by).state == number(State::open));
    CHECK(judged(nothing, 2.0, by).state == number(State::not_judged));
    CHECK(std::isnan(judged(nothing, 2.0, by).utilisation));
    const Folded passes = Folded{}.with_row(number(State::pass), 0.7, true);
    CHECK(judged(passes, 2.0, by).state == number(State::pass));
    CHECK(judged(passes, 2.0, by).utilisation == 0.7);
    CHECK(judged(passes, 0.0, by).state == absent_state);
    by.never = true;  // a check is missing
    CHECK(judged(passes, 2.0, by).state == number(State::not_judged));
    CHECK(std::isnan(judged(passes, 2.0, by).utilisation));
    by.never = false;
    by.passed = number(State::not_judged);  // the factor of a load is missing
    CHECK(judged(passes, 2.0, by).state == number(State::not_judged));
    by.passed = number(State::pass);
    by.needs_checks = true;
    const Folded limit = Folded{}.with_row(number(State::pass), none, false);
    CHECK(judged(limit, 2.0, by).state == number(State::not_judged));
    CHECK(judged(passes, 2.0, by).state == number(State::pass));
    by.needs_checks = false;
    CHECK(judged(limit, 2.0, by).state == number(State::pass));
    const Folded fails = passes.with_row(number(State::fail), 1.3, true);
    for (const double applies : {0.0, 1.0, 2.0}) {  // what fails was seen wrongly where it does not apply
      CHECK(judged(fails, applies, by).state == number(State::fail));
      CHECK(judged(fails, applies, by).utilisation == 1.3);
    }
    by.state[2] = number(State::accepted);
    CHECK(judged(nothing, 2.0, by).state == number(State::accepted));
    by.never = true;  // what waits for an assessment, or for a reason, has no utilisation
    for (const State waits : {State::accepted, State::open, State::not_judged}) {
      by.state[2] = number(waits);
      CHECK(judged(passes, 2.0, by).state == number(waits));
      CHECK(std::isnan(judged(passes, 2.0, by).utilisation));
    }
    CHECK(judged(passes, 2.0, Unjudged{}).state == number(State::pass));
  }

  TEST_CASE("modes together have the worst state, apart from those not considered") {
    const auto whole = [](std::initializer_list<State> states) {
      Folded all;
      for (const State state : states) all = all.with_mode(number(state), none, number(State::open));
      return all.whole();
    };
    CHECK(whole({}) == number(State::open));
    CHECK(whole({State::open}) == number(State::open));
    CHECK(whole({State::open, State::pass}) == number(State::pass));
    CHECK(whole({State::accepted, State::open}) == number(State::pass));
    for (const State state : {State::not_judged, State::not_covered, State::not_available, State::fail}) {
      CHECK(whole({State::pass, state, State::open}) == number(state));
    }
    CHECK(whole({State::fail, State::not_available}) == number(State::fail));
    Folded used = Folded{}.with_mode(number(State::pass), 0.3, number(State::open));
    used = used.with_mode(number(State::fail), 1.4, number(State::open)).with_mode(number(State::pass), 0.5, 2.0);
    CHECK(used.utilisation == 1.4);
    const Folded strict = Folded{}.with_mode(number(State::open), none, number(State::not_judged));
    CHECK(strict.worst == number(State::not_judged));
  }

  TEST_CASE("columns give at every point what the rules give for one machine") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> value(-0.2, 1.6);
    std::uniform_int_distribution<int> three(0, 2), seven(0, 6), rare(0, 5);
    constexpr std::size_t n = 67;
    const Range bounds{0.1, 1.0, true, false};
    for (int trial = 0; trial < 40; ++trial) {
      std::vector<double> check(n), limit(n), other(n);
      std::vector<Applies> applies(n);
      for (std::size_t i = 0; i < n; ++i) {
        check[i] = rare(random) == 0 ? none : value(random);
        limit[i] = rare(random) == 0 ? none : value(random);
        other[i] = rare(random) == 0 ? 1.0 : value(random);
        applies[i] = static_cast<Applies>(three(random));
      }
      Unjudged by;
      for (double& state : by.state) state = number(all_states[static_cast<std::size_t>(seven(random))]);
      by.needs_checks = trial % 2 == 0;
      by.never = trial % 7 == 0;
      const bool is_criterion = trial % 3 == 0;
      RowColumns rows;
      rows.clear(n);
      rows.take_check(check);
      rows.take_limit(bounds, is_criterion, limit);
      rows.take_check(other);
      std::array<ModeColumns, 2> modes;
      rows.judge(applies, by, modes[0]);
      leave_mode(applies, by, modes[1]);
      VerdictColumns together;
      const std::array<const ModeColumns*, 2> both{&modes[0], &modes[1]};
      together.fold(both, n, trial % 2 == 1);
      std::vector<double> state(n), passes(n);
      together.write_state(true, state);
      together.write_passes(passes);
      for (std::size_t i = 0; i < n; ++i) {
        Folded one;
        if (!std::isnan(check[i])) one = one.with_row(number(state_of_check(check[i])), check[i], true);
        if (!std::isnan(limit[i]))
          one = one.with_row(number(state_of_limit(bounds, is_criterion, limit[i])), none, false);
        one = one.with_row(number(state_of_check(other[i])), other[i], true);
        const auto when = static_cast<double>(static_cast<int>(applies[i]));
        const Judged first = judged(one, when, by), second = judged(Folded{}, when, by);
        REQUIRE(same(modes[0].state[i], first.state));
        REQUIRE(same(modes[0].utilisation[i], first.utilisation));
        REQUIRE(same(modes[1].state[i], second.state));
        const double open = number(trial % 2 == 1 ? State::not_judged : State::open);
        const Folded all =
            Folded{}.with_mode(first.state, first.utilisation, open).with_mode(second.state, second.utilisation, open);
        REQUIRE(same(state[i], all.whole()));
        REQUIRE(same(together.utilisation()[i], all.utilisation));
        REQUIRE(passes[i] == (all.worst <= number(State::open) ? 1.0 : 0.0));
      }
    }
  }

  TEST_CASE("modes pass with those that are accepted or not considered, and with none worse") {
    CHECK(passes({}));
    CHECK(passes({mode_of(State::open)}));
    CHECK(passes({mode_of(State::pass), mode_of(State::accepted), mode_of(State::open)}));
    for (const State state : {State::not_judged, State::not_covered, State::not_available, State::fail})
      CHECK_FALSE(passes({mode_of(State::pass), mode_of(state)}));
    CHECK_FALSE(passes(strictly({mode_of(State::pass), mode_of(State::open)})));
    CHECK(worst(strictly({mode_of(State::open)})) == State::not_judged);
  }

  TEST_CASE("groups and headline follow from the states") {
    CHECK(group_of(mode_of(State::fail)) == account::Group::fails);
    CHECK(group_of(mode_of(State::not_judged)) == account::Group::needs_input);
    CHECK(group_of(mode_of(State::not_judged, false)) == account::Group::outside_scope);
    CHECK(group_of(mode_of(State::not_covered, false)) == account::Group::needs_input);
    CHECK(group_of(mode_of(State::not_available)) == account::Group::needs_input);
    CHECK(group_of(mode_of(State::open, false)) == account::Group::not_considered);
    CHECK(group_of(mode_of(State::accepted)) == account::Group::accepted);
    CHECK(group_of(mode_of(State::pass)) == account::Group::passes);
    CHECK(conclude({}).headline == Headline::pass);
    CHECK(conclude({mode_of(State::open), mode_of(State::accepted)}).headline == Headline::pass);
    for (const State state : {State::not_judged, State::not_covered, State::not_available})
      CHECK(conclude({mode_of(State::pass), mode_of(state)}).headline == Headline::incomplete);
    CHECK(conclude({mode_of(State::not_judged, false)}).headline == Headline::incomplete);
    account::Mode search = mode_of(State::not_available);
    search.subject = Subject::search;
    const Conclusion none_found = conclude({search, mode_of(State::not_judged)});
    CHECK(none_found.headline == Headline::no_solution);
    CHECK(none_found.modes() == 1);  // a search is not a failure mode
    CHECK(conclude({search, mode_of(State::fail)}).headline == Headline::fail);
    const Conclusion mixed = conclude({mode_of(State::fail), mode_of(State::pass), mode_of(State::pass)});
    CHECK(mixed.headline == Headline::fail);
    CHECK(mixed.count(account::Group::passes) == 2);
    CHECK(mixed.count(account::Group::fails) == 1);
    CHECK(mixed.modes() == 3);
  }

  TEST_CASE("the headline names its basis") {
    account::Mode fails = mode_of(State::fail);
    fails.title = say("yield");
    fails.utilisation = 1.27;
    CHECK(explanation({fails}).text() == "part: yield, utilisation 1.27");
    CHECK(explanation({fails, fails}).text() == "part: yield, utilisation 1.27; and 1 more");
    CHECK(explanation({mode_of(State::not_judged), mode_of(State::pass)}).text() ==
          "1 of 2 failure modes needs input or another step");
    CHECK(explanation({mode_of(State::not_judged), mode_of(State::not_judged, false)}).text() ==
          "1 of 2 failure modes needs input or a step, 1 outside the scope");
    CHECK(explanation({mode_of(State::not_judged, false)}).text() ==
          "1 of 1 failure modes is outside the scope of loadpath");
    // Those not considered are not part of the total; those accepted are assessed.
    CHECK(explanation({mode_of(State::not_judged), mode_of(State::pass), mode_of(State::open)}).text() ==
          "1 of 2 failure modes needs input or another step");
    CHECK(explanation({mode_of(State::pass), mode_of(State::pass), mode_of(State::accepted)}).text() ==
          "3 failure modes assessed");
    CHECK(explanation({}).text() == "no failure mode is assessed here");
    account::Mode open = mode_of(State::open);
    open.title = say("fatigue, at shoulders first");
    CHECK(explanation({mode_of(State::pass), open}).text() == "1 failure mode assessed; fatigue not considered");
  }
}
