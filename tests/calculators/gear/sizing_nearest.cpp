// gear.sizing where no pair passes, and the bounds that spare ratings, against ratings of all combinations.
#include "calculators/gear/sizing/load_bound.hpp"
#include "calculators/gear/sizing/rated.hpp"
#include "calculators/gear/sizing/sizing.hpp"
#include "tests/calculators/evaluated.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace {

using namespace loadpath;
using namespace loadpath::gear;
using sizing::Shortfall;

constexpr auto solve = test::evaluated<PairSizing>;

PairSizing::Input overloaded() {
  PairSizing::Input in;
  in.P = 5e6 * W, in.n_1 = 1450.0 * rpm, in.i_set = 3.5, in.K_A = 1.25;
  in.z_min = 17, in.z_max = 24, in.m_min = 1.5 * mm, in.m_max = 6.0 * mm;
  in.betas = {{0.0}, {15.0 * deg.one}};
  in.grade = 6, in.finish = Finish::ground, in.R_z1 = in.R_z2 = 5.0 * um, in.nu_40 = 220.0 * mm2_per_s.one;
  in.material_1 = GearMaterial::case_hardened, in.quality_1 = Quality::MQ, in.H_1 = 720;
  in.material_2 = GearMaterial::through_alloy, in.quality_2 = Quality::MQ, in.H_2 = 280;
  in.place = gear::Place::middle, in.S_Hmin = 1.1, in.S_Fmin = 1.4;
  return in;
}

/// Every pair of the range that gear.rating takes; of pairs beyond a limit the first width.
std::vector<sizing::Found> all_of(const PairSizing::Input& in) {
  PairSizing::Input loaded = in;
  loaded.T_1 = in.P / in.n_1;
  const sizing::Range range = sizing::range_of(loaded);
  std::vector<sizing::Found> all;
  for (std::size_t i = 0; i < range.options.size(); ++i) {
    RatingTypes::Input teeth = range.teeth(i);
    for (const double b : sizing::widths_of(in, range.options[i].m, sizing::laid_out(teeth).d_1 / mm)) {
      teeth.b = b * mm;
      if (!sizing::is_admissible(teeth)) break;
      all.push_back(sizing::rated(in, teeth));
      if (!sizing::is_of_load(all.back().shortfall.failure)) break;
    }
  }
  return all;
}

void check_nearest(const PairSizing::Input& in) {
  std::vector<sizing::Found> all = all_of(in);
  REQUIRE(all.size() >= 10);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.shortfall.less_than(b.shortfall); });
  const auto r = solve(in);
  CHECK(r.found == 0.0);
  REQUIRE(r.rejected.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(r.rejected[i].u == all[i].shortfall.check);
    CHECK(r.rejected[i].failure == all[i].shortfall.failure);
  }
}

}  // namespace

TEST_SUITE("gear sizing") {
  TEST_CASE("where none passes, the ten shown are the nearest of all combinations") {
    for (const auto standard : {RatingStandard::din3990, RatingStandard::iso6336}) {
      for (const double life : {unset<double>, 100.0}) {
        auto in = overloaded();
        in.standard = standard;
        if (is_set(life)) in.L_h = from_si<Time>(life * 3600.0);
        check_nearest(in);
        in.x_sum = 0.6;
        check_nearest(in);
        in.by = PairSizing::By::centre;
        check_nearest(in);
      }
    }
  }

  TEST_CASE("where the velocity rejects all, the ten shown are the nearest of all combinations") {
    auto in = overloaded();
    in.n_1 = 60000.0 * rpm;
    check_nearest(in);
    for (const auto& c : solve(in).rejected) CHECK(c.failure == PairSizing::Failure::dynamic);
  }

  TEST_CASE("no module and width has a smaller check than the bound of its numbers") {
    for (const auto standard : {RatingStandard::din3990, RatingStandard::iso6336}) {
      for (const auto edition : {RootEdition::of_2006, RootEdition::of_2019}) {
        auto in = overloaded();
        in.standard = standard, in.T_1 = 4000.0 * N_m;
        if (standard == RatingStandard::iso6336) in.root_edition = edition;
        const sizing::Range range = sizing::range_of(in);
        for (std::size_t i = 0; i < range.options.size(); i += 5) {
          const std::size_t numbers = range.options[i].numbers;
          std::size_t last = i;
          while (last + 1 < range.options.size() && range.options[last + 1].numbers == numbers) ++last;
          RatingTypes::Input largest = range.teeth(last), teeth = range.teeth(i);
          largest.b = 180.0 * mm;
          const sizing::LoadBound bound = sizing::bound_of(largest);
          const double m = teeth.m_n / mm;
          for (const double b : {6.0 * m, 12.0 * m, 30.0 * m}) {
            teeth.b = b * mm;
            const Shortfall shortfall = sizing::rated(in, teeth).shortfall;
            CHECK(bound.at(m, b) <= shortfall.check);
            CHECK(bound.at(m, b) > 0.3 * shortfall.check);  // loose bounds spare nothing
          }
        }
      }
    }
  }
}
