#include "calculators/fatigue/endurance.hpp"

#include "lib/quantity/fit_units.hpp"
#include "tests/calculators/evaluated.hpp"
#include "tests/lib/project/says.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

namespace {

using namespace loadpath;
using E = fatigue::Endurance;
using test::rel;

constexpr auto limit = test::evaluated<E>;

/// The shaft of examples 6-4 and 6-6 of [Shigley6].
E::Input shoulder() {
  E::Input in;
  in.R_m = 690.0 * MPa;
  in.rule = E::RuleOf::shigley;
  in.school = E::School::marin;
  in.d = 32.0 * mm;
  in.K_t = 1.65;
  in.r_n = 3.0 * mm;
  return in;
}

bool says(const std::string& lines, const std::string& words) {
  return test::says("[c]\ncalculator = \"fatigue.endurance\"\n" + lines, words);
}

}  // namespace

TEST_SUITE("fatigue.endurance") {
  TEST_CASE("estimates of the rules for one steel") {
    struct Row {
      E::RuleOf rule;
      E::Loading loading;
      double MPa_of_600;
    };
    for (const Row row :
         {Row{E::RuleOf::textbook, E::Loading::bending, 240}, Row{E::RuleOf::din743, E::Loading::bending, 300},
          Row{E::RuleOf::din743, E::Loading::tension, 240}, Row{E::RuleOf::din743, E::Loading::torsion, 180},
          Row{E::RuleOf::fkm, E::Loading::tension, 270}, Row{E::RuleOf::fkm, E::Loading::torsion, 155.79},
          Row{E::RuleOf::shigley, E::Loading::bending, 300}, Row{E::RuleOf::shigley, E::Loading::tension, 255},
          Row{E::RuleOf::shigley, E::Loading::torsion, 177}}) {
      E::Input in;
      in.R_m = 600.0 * MPa;
      in.rule = row.rule, in.loading = row.loading;
      CHECK(rel(in_si(limit(in).sigma_m1), row.MPa_of_600 * 1e6) < 1e-12);
    }
  }

  TEST_CASE("half of R_m applies up to R_m of 700 MPa and no further") {
    E::Input in = shoulder();
    in.R_m = 1400.0 * MPa;
    CHECK(rel(in_si(limit(in).sigma_m1), 700e6) < 1e-12);
    in.R_m = 1600.0 * MPa;
    CHECK(rel(in_si(limit(in).sigma_m1), 700e6) < 1e-12);
  }

  TEST_CASE("the textbook's bands, and the conventional limit of non-ferrous metals at 1e8 cycles") {
    E::Input in;
    in.R_m = 400.0 * MPa;
    CHECK(rel(in_si(limit(in).sigma_high), 180e6) < 1e-12);
    in.group = E::Group::wrought_aluminium;
    CHECK(rel(in_si(limit(in).sigma_low), 96e6) < 1e-12);
    CHECK(rel(in_si(limit(in).sigma_high), 200e6) < 1e-12);
    CHECK(limit(in).N_0 == 1e8);
    in.group = E::Group::grey_iron;
    CHECK(rel(in_si(limit(in).sigma_m1), 160e6) < 1e-12);
    CHECK(limit(in).N_0 == 1e7);
  }

  TEST_CASE("Marin's factors and Neuber's notch of the shoulder: 0.9065, 0.8558, 1.55") {
    const auto r = limit(shoulder());
    CHECK(std::abs(r.k_a - 0.906473) < 5e-6);
    CHECK(std::abs(r.k_b - 0.855797) < 5e-6);
    E::Input thick = shoulder();
    thick.d = 100.0 * mm;
    CHECK(std::abs(limit(thick).k_b - 0.732786) < 5e-7);  // 1.51 100^-0.157, by hand
    CHECK(std::abs(r.K_f - 1.55) < 5e-3);
    CHECK(rel(in_si(r.sigma_D), 345e6 * r.k_a * r.k_b / r.K_f) < 1e-12);
  }

  TEST_CASE("a smooth polished specimen keeps its fatigue limit in Serensen's school") {
    E::Input in;
    in.R_m = 600.0 * MPa;
    CHECK(limit(in).K_D == 1.0);
    in.d = 7.5 * mm;
    CHECK(limit(in).K_D == 1.0);
  }

  TEST_CASE("size and roughness of DIN 743 in K_D") {
    E::Input in;
    in.R_m = 800.0 * MPa;
    in.rule = E::RuleOf::din743;
    in.d = 40.0 * mm;
    in.R_z = 10.0 * um;
    const double epsilon = 1 - 0.2 * std::log10(40 / 7.5) / std::log10(20.0);
    const double K_F = 1 - 0.22 * 1.0 * (std::log10(40.0) - 1);
    CHECK(rel(limit(in).K_D, 1 / epsilon + 1 / K_F - 1) < 1e-12);
    in.loading = E::Loading::torsion;
    CHECK(rel(limit(in).beta_F, 0.575 * K_F + 0.425) < 1e-12);
    in.loading = E::Loading::tension;
    CHECK(limit(in).epsilon == 1.0);
    in.d = 200.0 * mm, in.loading = E::Loading::bending;
    CHECK(rel(limit(in).epsilon, 0.8) < 1e-12);
  }

  TEST_CASE("larger, rougher, sharper parts are weaker, surface-hardened ones stronger") {
    E::Input in;
    in.R_m = 700.0 * MPa;
    in.rule = E::RuleOf::din743;
    in.d = 30.0 * mm, in.R_z = 4.0 * um, in.K_t = 1.8, in.r_n = 2.0 * mm;
    const auto base = limit(in);
    const auto weaker = [&](auto change) {
      E::Input other = in;
      change(other);
      return limit(other).sigma_D < base.sigma_D;
    };
    CHECK(weaker([](E::Input& o) { o.d = 60.0 * mm; }));
    CHECK(weaker([](E::Input& o) { o.R_z = 25.0 * um; }));
    CHECK(weaker([](E::Input& o) { o.K_t = 2.2; }));
    CHECK(weaker([](E::Input& o) { o.r_n = 4.0 * mm; }));  // more of the same K_t is effective
    CHECK_FALSE(weaker([](E::Input& o) { o.beta_V = 1.3; }));
  }

  TEST_CASE("the notch is applied once: K_f in place of K_t and q changes nothing") {
    E::Input in = shoulder();
    const auto by_radius = limit(in);
    in.r_n = unset<Length>, in.K_t = 1.0;
    in.K_f = by_radius.K_f;
    CHECK(rel(in_si(limit(in).sigma_D), in_si(by_radius.sigma_D)) < 1e-12);
  }

  TEST_CASE("limits on both sides: sizes and strengths of the fits") {
    E::Input in = shoulder();
    in.d = 254.0 * mm;
    CHECK(limit(in).x_d <= 1 + 1e-9);
    in.d = 255.0 * mm;
    CHECK(limit(in).x_d > 1 + 1e-9);
    in.d = 2.7 * mm;
    CHECK(limit(in).x_d < 0);
    in = shoulder();
    in.R_m = 341.0 * MPa;
    CHECK(limit(in).x_n > 0);
    in.R_m = 339.0 * MPa;
    CHECK(limit(in).x_n < 0);
    in.R_m = 1501.0 * MPa;
    CHECK(limit(in).x_n < 1);
    in.loading = E::Loading::torsion;
    CHECK(limit(in).x_n > 1);
    in.school = E::School::serensen;
    in.d = 7.4 * mm;
    CHECK(limit(in).x_d < 0);
  }

  TEST_CASE("Shigley 6-8: reversed tension of 99 % of the parts; solutions of 6-1, 11th edition, and of 6-15") {
    E::Input in = shoulder();
    in.K_t = 1.0, in.r_n = unset<Length>;
    in.R_m = 49.0 * 6.894757 * MPa, in.loading = E::Loading::tension, in.finish = E::Finish::machined, in.P_s = 0.99;
    CHECK(std::abs(limit(in).k_a - 0.963) < 1.5e-3);  // the book has the constants of kpsi
    CHECK(std::abs(limit(in).k_e - 0.814) < 5e-4);
    CHECK(std::abs(in_si(limit(in).sigma_D) / 6.894757e6 - 16.3) < 0.05);

    in = shoulder();
    in.K_t = 1.0, in.r_n = unset<Length>;
    in.R_m = 1020.0 * MPa, in.d = 10.0 * mm, in.edition = E::Edition::eleventh;
    CHECK(std::abs(in_si(limit(in).sigma_D) - 429e6) < 5e5);

    in.R_m = 120.0 * 6.894757 * MPa, in.d = 45.72 * mm, in.edition = E::Edition::ninth;
    in.finish = E::Finish::machined, in.turning = E::Turning::standing;
    CHECK(rel(in_si(limit(in).d_e), 16.9164e-3) < 1e-12);
    CHECK(rel(in_si(limit(in).sigma_D), 42.0 * 6.894757e6) < 5e-3);
    in.loading = E::Loading::torsion;  // all of the rim is sheared, whether it turns or not
    CHECK_FALSE(is_set(limit(in).d_e));
  }

  TEST_CASE("reliability by the deviates of table 6-5, temperature by the rows of table 6-4") {
    E::Input in = shoulder();
    const std::pair<double, double> table[] = {{0.5, 1.0},     {0.9, 0.897},    {0.95, 0.868},    {0.99, 0.814},
                                               {0.999, 0.753}, {0.9999, 0.702}, {0.99999, 0.659}, {0.999999, 0.620}};
    for (const auto& [P_s, k_e] : table) {
      in.P_s = P_s;
      CHECK(std::abs(limit(in).k_e - k_e) < 1e-3);
    }
    in.P_s = unset<double>;
    in.T = 293.15 * kelvin.one;
    CHECK(limit(in).k_d == 1.0);
    for (const auto& [T_F, k_d] : {std::pair{500.0, 0.995}, {600.0, 0.963}}) {
      in.T = (T_F + 459.67) / 1.8 * kelvin.one;
      CHECK(std::abs(limit(in).k_d - k_d) < 5e-3);
    }
    CHECK(limit(in).x_T < 1.0);
    in.T = 815.0 * kelvin.one;
    CHECK(limit(in).x_T > 1.0);
    in.T = 290.0 * kelvin.one;
    CHECK(limit(in).x_T < 0.0);
  }

  TEST_CASE("all factors are in K_D; one that is 1 changes nothing") {
    E::Input in = shoulder();
    const auto plain = limit(in);
    in.P_s = 0.5;
    CHECK(rel(in_si(limit(in).sigma_D), in_si(plain.sigma_D)) < 1e-12);
    in.P_s = 0.99, in.T = 600.0 * kelvin.one, in.sigma_W = 345.0 * MPa, in.k_c = 0.9;
    const auto r = limit(in);
    CHECK(rel(r.K_D, r.K_f / (r.k_a * r.k_b * 0.9 * r.k_d * r.k_e)) < 1e-12);
  }

  TEST_CASE("Peterson's sensitivity and that of cast iron") {
    E::Input in = shoulder();
    in.sensitivity = E::Sensitivity::peterson;
    const double a = 0.0254 * std::pow(3.0, 1.8);  // 2070 over 690
    CHECK(rel(limit(in).K_f, 1 + 0.65 / (1 + a / 3)) < 1e-12);
    in.loading = E::Loading::torsion;
    CHECK(rel(limit(in).K_f, 1 + 0.65 / (1 + 0.6 * a / 3)) < 1e-12);
    in.R_m = 559.0 * MPa;
    CHECK(limit(in).x_n < 0);
    in.sensitivity = E::Sensitivity::cast_iron, in.r_n = unset<Length>;
    CHECK(rel(limit(in).K_f, 1 + 0.65 * 0.2) < 1e-12);
  }

  TEST_CASE("wrong input is reported") {
    const std::string steel = "R_m = \"600 MPa\"\ngroup = \"carbon-steel\"\n";
    CHECK(says("group = \"carbon-steel\"\nloading = \"bending\"\n", "give the tensile strength"));
    CHECK(says(steel + "loading = \"torsion\"\n", "in bending only"));
    CHECK(says("R_m = \"300 MPa\"\ngroup = \"grey-iron\"\nloading = \"bending\"\nrule = \"din743\"\n", "for steels"));
    CHECK(says(steel + "loading = \"bending\"\nrule = \"fkm\"\n", "tension and torsion"));
    CHECK(says(steel + "loading = \"bending\"\nK_t = 2\n", "needs its sensitivity"));
    CHECK(
        says(steel + "loading = \"bending\"\nK_t = 2\nq = 0.8\nr_n = \"2 mm\"\n", "give either the notch sensitivity"));
    CHECK(says(steel + "loading = \"bending\"\nK_f = 2\nq = 0.8\n", "not both"));
    CHECK(says(steel + "loading = \"bending\"\nepsilon = 0.8\nd = \"40 mm\"\n", "give either the size factor"));
    CHECK(says(steel + "loading = \"bending\"\nbeta_F = 0.8\nR_z = \"4 um\"\n", "give either the surface factor"));
    CHECK(says(steel + "loading = \"bending\"\nschool = \"marin\"\nR_z = \"4 um\"\n", "belong to Serensen"));
    CHECK(says(steel + "loading = \"bending\"\nK_t = 0.8\nq = 1\n", "must be"));
    const std::string marin = steel + "rule = \"shigley\"\nschool = \"marin\"\nfinish = \"ground\"\n";
    const std::string square = "h = \"20 mm\"\nb = \"20 mm\"\n", stands = "turning = \"standing\"\n";
    CHECK(says(steel + "loading = \"bending\"\nP_s = 0.99\n",
               "T, P_s, k_a, k_b, k_c, h, b, turning and edition belong to Marin's method"));
    CHECK(says(marin + "loading = \"bending\"\nh = \"20 mm\"\n", "height h and width b"));
    CHECK(says(marin + stands + square + "loading = \"bending\"\nd = \"20 mm\"\n", "height h and width b"));
    CHECK(says(marin + square + "loading = \"bending\"\n", "of a non-rotating part"));
    CHECK(says(marin + stands + square + "loading = \"torsion\"\n", "of a non-rotating part"));
    CHECK(says(marin + "loading = \"tension\"\nk_c = 0.85\n",
               "k_c requires a measured limit sigma_W; the rules include their load factors"));
    CHECK(
        says("R_m = \"300 MPa\"\ngroup = \"cast-aluminium\"\nloading = \"bending\"\nsigma_W = \"80 MPa\"\n"
             "school = \"marin\"\nT = \"100 degC\"\n",
             "applies to steels"));
    CHECK(says(steel + "loading = \"bending\"\nK_t = 2\nsensitivity = \"cast-iron\"\n", "q = 0.2 of cast iron"));
    CHECK(says("sigma_W = \"200 MPa\"\ngroup = \"carbon-steel\"\nloading = \"bending\"\nR_z = \"4 um\"\n",
               "the surface factor needs the tensile strength R_m"));
  }
}
