// Torsional-flexural buckling of open sections: against the eigenvalues of the three equations of bending in both
// planes and twisting, and the tables of rolled channels.
#include "calculators/column/torsional.hpp"

#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "tests/calculators/column/models.hpp"
#include "tests/found/modes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace loadpath;
using namespace loadpath::tests;

/// cm^2, cm^4, mm.
column::Buckling::Input section_of(SectionKind kind, double A, double I_y, double I_z, double h, double b, double t_f,
                                   double t_w) {
  column::Buckling::Input in = bar_of_steel(column::Ends::pinned_pinned);
  in.method = column::Method::ec3, in.gamma_M1 = in.gamma_F = 1.0;
  in.kind = kind;
  in.A = from_si<Area>(A * 1e-4);
  in.I_y = from_si<SecondMoment>(I_y * 1e-8), in.I_z = from_si<SecondMoment>(I_z * 1e-8);
  in.h = h * mm, in.b = b * mm, in.t_f = t_f * mm, in.t_w = t_w * mm;
  return in;
}

column::Buckling::Input upn_200() {
  column::Buckling::Input in = section_of(SectionKind::channel, 32.2, 1910, 148, 200, 75, 11.5, 8.5);
  in.l = 6.0 * m, in.I_t = from_si<SecondMoment>(11.9e-8), in.I_w = from_si<column::Warping>(9070e-12);
  in.y_M = 39.4 * mm, in.P = 300.0 * kN;
  in.supports_z.push_back({2.0 * m}), in.supports_z.push_back({4.0 * m});
  return in;
}

column::Buckling::Input angle(double l) {
  column::Buckling::Input in = section_of(SectionKind::angle, 19.2, 177, 177, 100, 100, 10, 10);
  in.I_min = from_si<SecondMoment>(73e-8), in.l = l * m, in.P = 300.0 * kN;
  return in;
}

}  // namespace

TEST_SUITE("column torsional") {
  TEST_CASE("the critical force is the smallest eigenvalue of bending in both planes and twisting") {
    CHECK(rel(in_si(solve(upn_200()).N_crTF), 816.2504e3) < 1e-6);
    CHECK(rel(in_si(solve(angle(0.8)).N_crTF), 1596.405e3) < 1e-6);
    CHECK(rel(in_si(solve(angle(2.0)).N_crTF), 975.5535e3) < 1e-6);
    column::Buckling::Input tee =
        section_of(SectionKind::tee, 17.2, 154.08449612403104, 83.71733333333336, 100, 100, 10, 8);
    tee.l = 1.5 * m, tee.P = 10.0 * kN;
    CHECK(rel(in_si(solve(tee).N_crTF), 692.54187e3) < 1e-7);
  }

  TEST_CASE("EN 1993-1-1 with it: 425 kN of a UPN 200, 393 kN of an L 100x100x10") {
    const auto resistance = [](const column::Buckling::Result& r) { return in_si(r.F) / r.u_TF / 1e3; };
    CHECK(std::abs(resistance(solve(upn_200())) - 425.0) < 0.6);
    CHECK(std::abs(resistance(solve(angle(0.8))) - 392.7) < 0.6);
  }

  TEST_CASE("a shear centre at the centroid uncouples them: the smaller of twisting and bending") {
    column::Buckling::Input in = upn_200();
    in.y_M = 1e-6 * mm;
    for (const double I_t : {1.0, 11.9, 200.0}) {
      in.I_t = from_si<SecondMoment>(I_t * 1e-8);
      const column::Buckling::Result r = solve(in);
      CHECK(rel(in_si(r.N_crTF), std::min(in_si(r.N_crT), in_si(r.axes[0].N_cr))) < 1e-9);
    }
  }

  TEST_CASE("it is never above twisting or bending, falls with length and offset, and rises with I_t and I_w") {
    double before = 1e12;
    for (const double l : {0.5, 1.0, 2.0, 4.0, 8.0}) {
      const column::Buckling::Result r = solve(angle(l));
      CHECK(in_si(r.N_crTF) < before);
      CHECK(in_si(r.N_crTF) < in_si(r.N_crT));
      before = in_si(r.N_crTF);
    }
    const double base = in_si(solve(upn_200()).N_crTF);
    column::Buckling::Input in = upn_200();
    in.y_M = 45.0 * mm;
    CHECK(in_si(solve(in).N_crTF) < base);
    in = upn_200(), in.I_t *= 1.1;
    CHECK(in_si(solve(in).N_crTF) > base);
    in = upn_200(), in.I_w *= 1.1;
    CHECK(in_si(solve(in).N_crTF) > base);
    in = upn_200(), in.l_T = 3.0 * m;
    CHECK(in_si(solve(in).N_crTF) > base);
    in = upn_200(), in.supports_z.clear(), in.ends = column::Ends::fixed_free;
    CHECK(in_si(solve(in).N_crTF) < 0.5 * base);
  }

  TEST_CASE("the centre lines of the walls give the constants of rolled channels") {
    int count = 0;
    for (const char* name : {"UPE 80", "UPE 100", "UPE 140", "UPE 200", "UPE 300", "UPE 400"}) {
      CAPTURE(name);
      const auto row = table::find_row("section", name);
      REQUIRE(row);
      const auto of = [&](const char* key) { return table::property(*row, key)->si; };
      const column::Buckling::Input in =
          section_of(SectionKind::channel, of("A") * 1e4, of("I_y") * 1e8, of("I_z") * 1e8, of("h") * 1e3,
                     of("b") * 1e3, of("t_f") * 1e3, of("t_w") * 1e3);
      const column::Twisting twist = column::twisting_of(in);
      CHECK(rel(in_si(twist.e), of("y_M")) < 0.04);
      CHECK(rel(in_si(twist.I_w), of("I_w")) < 0.08);
      CHECK(in_si(twist.I_t) < of("I_t"));
      CHECK(in_si(twist.I_t) > 0.7 * of("I_t"));
      ++count;
    }
    CHECK(count == 6);
  }

  TEST_CASE("AISC E4: the same elastic stress in both forms") {
    column::Buckling::Input in = angle(2.0);
    in.method = column::Method::aisc;
    const column::Buckling::Result r = solve(in);
    // (E4-3) as it is printed, with F_e = N_cr/A
    const double A = 19.2e-4, I_u = 2 * 177e-8 - 73e-8, F_s = pi * pi * 210e9 * I_u / 4.0 / A;
    const double e = std::sqrt(2.0) * (28.684210526315795e-3 - 5e-3), i_2 = 2 * 177e-8 / A + e * e, H = 1 - e * e / i_2;
    const double F_T = 210e9 / 2.6 * 190e-3 * 1e-6 / 3.0 / (A * i_2), sum = F_s + F_T;
    const double F_e = sum / (2 * H) * (1 - std::sqrt(1 - 4 * F_s * F_T * H / (sum * sum)));
    CHECK(rel(in_si(r.N_crTF) / A, F_e) < 1e-9);
    const double F_cr = F_e > 235e6 / 2.25 ? std::pow(0.658, 235e6 / F_e) * 235e6 : 0.877 * F_e;
    CHECK(rel(r.u_TF, 1.67 * 300e3 / (F_cr * A)) < 2e-3);  // 4.71 is rounded
  }

  TEST_CASE("unknown properties of a section are not assessed: unequal legs, no walls, no symmetry") {
    column::Buckling::Input in = angle(0.8);
    in.b = 75.0 * mm;
    CHECK(!is_set(solve(in).u_TF));
    in = angle(0.8), in.I_min = unset<SecondMoment>;
    CHECK(!is_set(solve(in).u_TF));
    in = upn_200(), in.t_f = unset<Length>, in.y_M = unset<Length>;
    CHECK(!is_set(solve(in).u_TF));
    in = upn_200(), in.kind = SectionKind::rolled_I;
    CHECK(!is_set(solve(in).N_crTF));
  }

  TEST_CASE("a typed constant more favourable than the walls needs a reason") {
    const std::string bar =
        "[bar]\ncalculator = \"column.buckling\"\nP = \"300 kN\"\nl = \"6 m\"\nends_y = \"pinned_pinned\"\nbeta_z = "
        "0.3\nE = \"210 GPa\"\nR_e = \"235 MPa\"\nmethod = \"ec3\"\ngamma_M1 = 1\ngamma_F = 1\nA = \"32.2 cm^2\"\nI_y "
        "= "
        "\"1910 cm^4\"\nI_z = \"148 cm^4\"\nkind = \"channel\"\nh = \"200 mm\"\nb = \"75 mm\"\nt_f = \"11.5 mm\"\nt_w "
        "= "
        "\"8.5 mm\"\n";
    const auto of = [&](const std::string& lines) {
      return test::mode_of(test::solved_as_found(bar + lines), "bar", "torsional_flexural");
    };
    CHECK(of("") == "pass");
    CHECK(of("I_t = \"11.9 cm^4\"\n") == "pass");
    CHECK(of("I_t = \"17 cm^4\"\n") == "not-judged");
    CHECK(of("I_w = \"16000 cm^6\"\n") == "not-judged");
    CHECK(of("y_M = \"10 mm\"\n") == "not-judged");
    CHECK(of("l_T = \"1 m\"\n") == "not-judged");
    CHECK(of("l_T = \"1 m\"\nbecause.l_T = \"held against twisting by purlins\"\n") == "pass");
  }
}
