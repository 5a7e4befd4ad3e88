#include "calculators/belt/v/sizing.hpp"
#include "tests/calculators/belt/steps.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace loadpath;
using test::BeltStep;
using test::with;

belt::VSizing::Input fan() {
  belt::VSizing::Input in;
  in.basis = belt::Basis::optibelt;
  in.P = 11e3 * W;
  in.K_A = 1.2;
  in.n_1 = 1460.0 * rpm, in.n_2_set = 730.0 * rpm;
  in.a_set = 600.0 * mm;
  return in;
}

constexpr auto solve = test::evaluated<belt::VSizing>;

const std::string text = R"(calculator = "belt.v_sizing"
basis = "iso"
belt_class = "IV"
P = "7.5 kW"
K_A = 1.2
n_1 = "1440 rpm"
n_2_set = "720 rpm"
a_set = "600 mm"
)";

}  // namespace

TEST_SUITE("belt v sizing") {
  TEST_CASE("every drive of the list meets the requirements") {
    const auto in = fan();
    const auto r = solve(in);
    REQUIRE(r.candidates.size() > 3);
    for (const auto& c : r.candidates) {
      CHECK(std::abs(in_si(c.n_2 / in.n_2_set) - 1.0) <= in.tol_n);
      CHECK(std::abs(in_si(c.a / in.a_set) - 1.0) <= in.tol_a);
      CHECK(c.u_P <= 1.0);
      CHECK(c.z <= in.z_max);
      CHECK(c.z >= 1);
    }
    CHECK(r.tried == r.drives + r.too_weak + r.outside);
  }

  TEST_CASE("the list is ranked, and states how much worse each is and in what it is better") {
    for (const auto rank :
         {belt::VSizing::Rank::pulleys, belt::VSizing::Rank::shaft_load, belt::VSizing::Rank::width}) {
      auto in = fan();
      in.rank = rank;
      const auto r = solve(in);
      REQUIRE(!r.candidates.empty());
      CHECK(r.candidates[0].merit == belt::VSizing::Merit::best);
      CHECK(r.candidates[0].excess == 0.0);
      for (std::size_t i = 1; i < r.candidates.size(); ++i) {
        CHECK(r.candidates[i].excess >= r.candidates[i - 1].excess);
        CHECK(r.candidates[i].merit != belt::VSizing::Merit::best);
      }
    }
  }

  TEST_CASE("the first is as belt.v assesses it") {
    const auto in = fan();
    const auto r = solve(in);
    belt::V::Input drive;
    drive.basis = in.basis, drive.section = choices_of(r.section)[static_cast<std::size_t>(r.section)].key,
    drive.P = in.P, drive.K_A = in.K_A, drive.n_1 = in.n_1;
    drive.d_1 = r.d_1, drive.d_2 = r.d_2, drive.L = r.L;
    NoTrace trace;
    const auto whole = belt::V::evaluate(drive, trace);
    CHECK(whole.z == r.z);
    CHECK(in_si(whole.R_new) == in_si(r.R_new));
    CHECK(whole.u_P == r.u_P);
    CHECK(whole.u_P <= 1.0);
    CHECK(in_si(r.candidates[0].R_new) == in_si(r.R_new));
  }

  TEST_CASE("narrower requirements never find more") {
    const double all = solve(fan()).drives;
    auto in = fan();
    in.section = "SPA";
    CHECK(solve(in).drives < all);
    in = fan();
    in.tol_n = 0.01;
    CHECK(solve(in).drives <= all);
    in = fan();
    in.d_1_min = 180.0 * mm;
    for (const auto& c : solve(in).candidates) CHECK(c.d_1 >= 180.0 * mm);
    in = fan();
    in.d_max = 300.0 * mm;
    for (const auto& c : solve(in).candidates) CHECK(max(c.d_1, c.d_2) <= 300.0 * mm);
  }

  TEST_CASE("speed-up drives are found, too") {
    auto in = fan();
    in.n_1 = 730.0 * rpm, in.n_2_set = 1460.0 * rpm;
    const auto r = solve(in);
    REQUIRE(!r.candidates.empty());
    CHECK(r.d_1 > r.d_2);
  }

  TEST_CASE("if no drive can be bought, that is reported with the nearest drive and its checks") {
    const BeltStep none(with(text, "P", "\"2000 kW\""));
    CHECK(none.worst() != account::State::pass);
    CHECK(none.value("drives") == 0.0);
    CHECK(none.value("too_weak") > 0.0);
    const BeltStep weak(with(with(text, "P", "\"60 kW\""), "z_max", "2"));
    CHECK(weak.value("drives") == 0.0);
    CHECK(weak.value("z") == 2.0);
    CHECK(weak.value("u_P") > 1.0);
    const BeltStep slips(with(text, "mu", "0.05"));
    CHECK(slips.value("drives") == 0.0);
    CHECK(slips.value("outside") == slips.value("tried") - slips.value("too_weak"));
    CHECK(slips.value("u_grip") > 1.0);
    CHECK(slips.value("u_P") <= 1.0);
    const BeltStep far(with(text, "a_set", "\"15 m\""));
    CHECK(far.value("tried") == 0.0);
  }

  TEST_CASE("if no drive passes, all that is shown belongs to one drive: that with the most belts allowed") {
    auto in = fan();
    in.P = 300e3 * W;
    const auto r = solve(in);
    CHECK(r.drives == 0.0);
    CHECK(r.z == 8);
    CHECK(r.best.z == 8);
    CHECK(r.u_P > 1.0);
    NoTrace trace;
    const auto whole = belt::V::evaluate(r.best, trace);
    CHECK(whole.z == 8);
    for (const auto& [of_belt, shown] :
         {std::pair{whole.F_0, r.F_0}, {whole.R_0, r.R_0}, {whole.R_new, r.R_new}, {whole.R, r.R}})
      CHECK(of_belt == shown);
    CHECK(in_si(whole.B) == in_si(r.B));
    CHECK(whole.u_P == r.u_P);
    // Span forces of 8 belts at rest, by hand.
    const double sin_gamma = std::abs(in_si(r.d_2 - r.d_1)) / 2.0 / in_si(r.a);
    CHECK(in_si(r.R_0) == doctest::Approx(2.0 * 8.0 * in_si(r.F_0) * std::sqrt(1.0 - sin_gamma * sin_gamma)));
  }

  TEST_CASE("no passing drive is a failure") {
    const BeltStep none(with(text, "P", "\"2000 kW\""));
    const auto verdicts = project::verdicts(none.project);
    const auto drives =
        std::find_if(verdicts.begin(), verdicts.end(), [](const auto& row) { return row.symbol == "drives"; });
    REQUIRE(drives != verdicts.end());
    CHECK(drives->state == account::State::fail);
  }

  TEST_CASE("the rules of belt.v apply here, too") {
    CHECK(BeltStep(text).worst() == account::State::pass);
    CHECK(BeltStep(with(text, "basis", "")).says("the belt class requires the basis iso"));
    CHECK(BeltStep(with(text, "section", "\"XYZ\"")).says("does not rate a section 'XYZ'"));
    CHECK(BeltStep(with(text, "belt_class", "")).says("give belt_class"));
    CHECK(BeltStep(with(text, "K_A", "")).says("give either K_A or"));
    CHECK(BeltStep(with(with(text, "d_1_min", "\"300 mm\""), "d_max", "\"200 mm\"")).says("must not be larger"));
    CHECK(!BeltStep(with(text, "tol_n", "0.6")).issues.empty());
    CHECK(!BeltStep(with(text, "z_max", "0")).issues.empty());
  }
}
