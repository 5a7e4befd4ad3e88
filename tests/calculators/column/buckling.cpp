#include "calculators/column/buckling.hpp"

#include "calculators/column/codes/curves.hpp"
#include "lib/table/library.hpp"
#include "lib/table/table.hpp"
#include "tests/calculators/column/models.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using column::Ends;
using column::Method;

/// The critical stress in MPa of a bar of slenderness lambda about both axes.
double stress(column::Buckling::Input in, double lambda, std::string_view method) {
  in.beta_y = in.beta_z = 1.0;
  in.ends = Ends::unsaid;
  in.b = in.h = unset<Length>;
  in.A = from_si<Area>(1e-3);
  in.i_y = in.i_z = 10.0 * mm;
  in.l = lambda * in.i_y;
  return in_si(by(solve(in), method).sigma_cr) / 1e6;
}

}  // namespace

TEST_SUITE("column buckling") {
  TEST_CASE("the four cases of the textbook, to nine digits") {
    struct Row {
      Ends ends;
      column::Basis basis;
      double N_cr, lambda;
    };
    for (const Row& row : {Row{Ends::fixed_free, column::Basis::exact, 51175.72652, 311.7691454},
                           Row{Ends::pinned_pinned, column::Basis::exact, 204702.9061, 155.8845727},
                           Row{Ends::fixed_pinned, column::Basis::text, 417761.0329, 109.1192009},
                           Row{Ends::fixed_fixed, column::Basis::exact, 818811.6244, 77.94228634}}) {
      column::Buckling::Input in = bar_of_steel(row.ends);
      in.beta_basis = row.basis;
      CHECK(rel(in_si(solve(in).N_cr), row.N_cr) < 1e-9);
      CHECK(rel(solve(in).lambda, row.lambda) < 1e-9);
    }
  }

  TEST_CASE("Euler does not apply where the bar would yield: 221 MPa by Tetmajer, not 341") {
    column::Buckling::Input in = bar_of_steel(Ends::fixed_fixed);
    in.method = Method::euler;
    const column::Buckling::Result r = solve(in);
    CHECK(std::isnan(in_si(r.sigma_cr)));
    CHECK(std::isnan(in_si(r.P_all)));
    CHECK(r.r_1 > 1.0);
    CHECK(rel(in_si(by(r, "tetmajer").sigma_cr), 221.1458e6) < 1e-6);
    CHECK(rel(in_si(by(r, "tetmajer").P_cr), 530.75e3) < 1e-5);
  }

  TEST_CASE("from stocky to slender no method rises, jumps or exceeds the yield strength") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.curve_y = in.curve_z = column::Curve::b;
    in.e_y = 0.1 * mm;
    in.c_y = 20.0 * mm;
    for (const std::string_view method : {"tetmajer", "johnson", "rankine", "secant", "ec3", "aisc"}) {
      CAPTURE(method);
      double before = stress(in, 0.01, method);
      CHECK(before <= 235.0 * (1 + 1e-12));
      CHECK(before > 210.0);
      for (double lambda = 0.5; lambda <= 300.0; lambda += 0.5) {
        CAPTURE(lambda);
        const double now = stress(in, lambda, method);
        CHECK(now <= before * (1 + 1e-12));
        CHECK(before - now < 3.0);
        before = now;
      }
    }
  }

  TEST_CASE("each set of the table changes to Euler where the two meet") {
    struct Row {
      const char* set;
      double lambda;
    };
    for (const Row& row : {Row{"St37", 104.072833}, Row{"St50", 85.756089}, Row{"Ni5", 88.011013},
                           Row{"grey_iron", 77.480243}, Row{"softwood", 97.357327}, Row{"pine", 59.441221},
                           Row{"D16T", 52.556371}, Row{"Steel_20", 96.985509}, Row{"Steel_45", 81.356907}}) {
      CAPTURE(row.set);
      const auto entry = table::find_row("tetmajer", row.set);
      REQUIRE(entry);
      const auto stress_of = [&](const char* key) { return from_si<Stress>(table::property(*entry, key)->si); };
      column::Material material;
      material.E = stress_of("E_T");
      material.a_T = stress_of("a_T"), material.b_T = stress_of("b_T"), material.c_T = stress_of("c_T");
      CHECK(rel(column::tetmajer_transition(material), row.lambda) < 1e-8);
    }
  }

  TEST_CASE("a set that lies below Euler everywhere is refused") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.E = 2100.0 * GPa;
    CHECK(!column::set_meets_euler(in));
    CHECK(column::set_meets_euler(bar_of_steel(Ends::pinned_pinned)));
  }

  TEST_CASE("the published transition keeps its gap, and the gap is reported") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.transition = column::Transition::published;
    CHECK(rel(stress(in, 105.0, "tetmajer"), 310.0 - 1.14 * 105.0) < 1e-12);
    CHECK(rel(stress(in, 105.1, "tetmajer"), pi * pi * 210e3 / (105.1 * 105.1)) < 1e-12);
    CHECK(std::abs(solve(in).gap - 0.012275) < 1e-6);
  }

  TEST_CASE("Johnson's parabola touches Euler's hyperbola at half the yield strength") {
    const column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    const double transition = std::sqrt(2 * pi * pi * 210e3 / 235.0);
    CHECK(rel(stress(in, transition * (1 - 1e-9), "johnson"), 117.5) < 1e-8);
    CHECK(rel(stress(in, transition * (1 + 1e-9), "johnson"), 117.5) < 1e-8);
  }

  TEST_CASE("Rankine with the theoretical constant is Euler for slender bars") {
    const column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    CHECK(rel(stress(in, 1e4, "rankine"), pi * pi * 210e3 / 1e8) < 1e-3);
  }

  TEST_CASE("EN 1993-1-1: the reduction is the smaller root of Perry's equation") {
    struct Row {
      column::Curve curve;
      double lambda_bar, chi;
    };
    using column::Curve;
    for (const Row& row : {Row{Curve::b, 0.6816, 0.7939988057}, Row{Curve::c, 1.203, 0.4323404463},
                           Row{Curve::a, 0.5, 0.9242726423}, Row{Curve::d, 2.0, 0.1766325808}}) {
      column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
      in.curve_y = in.curve_z = row.curve;
      const double lambda = row.lambda_bar * pi * std::sqrt(210e3 / 235.0);
      CHECK(rel(stress(in, lambda, "ec3") / 235.0, row.chi) < 1e-9);
    }
  }

  TEST_CASE("EN 1993-1-1: the curve follows from the section, table 6.2") {
    struct Row {
      double h, b, t_f;
      column::Grade grade;
      double alpha_y, alpha_z;
    };
    using column::Grade;
    for (const Row& row :
         {Row{200, 100, 8.5, Grade::to_S420, 0.21, 0.34}, Row{200, 100, 8.5, Grade::S460, 0.13, 0.13},
          Row{600, 300, 41, Grade::to_S420, 0.34, 0.49}, Row{200, 200, 15, Grade::to_S420, 0.34, 0.49},
          Row{200, 200, 15, Grade::S460, 0.21, 0.21}, Row{400, 400, 101, Grade::to_S420, 0.76, 0.76}}) {
      column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
      in.A = from_si<Area>(1e-2);
      in.i_y = in.i_z = 50.0 * mm;
      in.h = row.h * mm, in.b = row.b * mm, in.t_f = row.t_f * mm;
      in.kind = SectionKind::rolled_I;
      in.grade = row.grade;
      const column::Buckling::Result r = solve(in);
      CHECK(r.axes[0].alpha == row.alpha_y);
      CHECK(r.axes[1].alpha == row.alpha_z);
    }
  }

  TEST_CASE("a thin flange is local buckling, which is not covered") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.A = from_si<Area>(1e-2);
    in.i_y = in.i_z = 50.0 * mm;
    in.h = 200.0 * mm, in.b = 200.0 * mm, in.t_w = 8.0 * mm;
    in.kind = SectionKind::welded_I;
    in.t_f = 96.0 / 14.0 * 1.001 * mm;
    CHECK(solve(in).r_class < 1.0);
    in.t_f = 96.0 / 14.0 * 0.999 * mm;
    CHECK(solve(in).r_class > 1.0);
  }

  TEST_CASE("a round tube of unstated kind is assessed by its diameter over its wall") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.b = in.h = unset<Length>;
    in.d = 200.0 * mm, in.d_bore = 196.0 * mm;
    CHECK(rel(solve(in).r_class, 200.0 / 2.0 / 90.0) < 1e-12);
    in.d_bore = unset<Length>;  // a solid one has no walls
    CHECK(solve(in).r_class == 0.0);
  }

  TEST_CASE("the extreme fibre is at half the side only where the section is symmetric") {
    const std::string bar =
        "calculator = \"column.buckling\"\nl = \"2 m\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\n"
        "R_e = \"235 MPa\"\nmethod = \"secant\"\n";
    const std::string I = "section = \"IPE 200\"\n", U = "section = \"UPN 200\"\n", L = "section = \"L 50x50x5\"\n";
    const std::string tee =
        "kind = \"tee\"\nb = \"100 mm\"\nA = \"20.9 cm^2\"\nI_y = \"179 cm^4\"\nI_z = \"88.3 cm^4\"\n";
    CHECK(complaints(bar + I + "e_z = \"5 mm\"\n").empty());
    CHECK(complaints(bar + U + "e_y = \"5 mm\"\n").empty());
    CHECK(complaints(bar + U + "e_z = \"5 mm\"\nc_z = \"54.9 mm\"\n").empty());
    CHECK(complaints(bar + tee + "e_z = \"5 mm\"\n").empty());
    for (const std::string& lines :
         {U + "e_z = \"5 mm\"\n", L + "e_y = \"5 mm\"\n", tee + "h = \"100 mm\"\ne_y = \"5 mm\"\n"}) {
      CAPTURE(lines);
      CHECK(complaints(bar + lines).find("needs the distance of the extreme fibre") != std::string::npos);
    }
    CHECK(complaints(bar + I + "kind = \"tee\"\ne_y = \"5 mm\"\n").find("the section 'IPE 200', which has rolled_I") !=
          std::string::npos);
  }

  TEST_CASE("the secant load makes the extreme fibre yield, and falls with the eccentricity") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    double before = 1e9;
    for (const double e : {1e-6, 1.0, 5.0, 20.0}) {
      in.e_y = e * mm;
      const column::Buckling::Result r = solve(in);
      const column::AxisResult& y = r.axes[0];
      const double sigma = in_si(y.sigma_s);
      const double fibre = sigma * (1 + y.eta / std::cos(0.5 * y.lambda * std::sqrt(sigma / 210e9)));
      CHECK(rel(fibre, 235e6) < 1e-9);
      CHECK(sigma < before);
      before = sigma;
    }
  }

  TEST_CASE("utilisation is load over allowable load: twice the load is twice of it, by every method") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.curve_y = in.curve_z = column::Curve::c;
    in.gamma_M1 = 1.1, in.gamma_F = 1.35;
    in.e_y = 2.0 * mm;
    in.P = 20.0 * kN;
    const column::Buckling::Result once = solve(in);
    in.P = 40.0 * kN;
    const column::Buckling::Result twice = solve(in);
    REQUIRE(once.methods.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) CHECK(rel(twice.methods[i].u, 2 * once.methods[i].u) < 1e-12);
    CHECK(rel(by(once, "ec3").u, 20e3 * 1.35 * 1.1 / in_si(by(once, "ec3").P_cr)) < 1e-12);
    CHECK(rel(by(once, "euler").u, 20e3 * 2.0 / in_si(by(once, "euler").P_cr)) < 1e-12);
    CHECK(rel(by(once, "aisc").u, 20e3 * 1.67 / in_si(by(once, "aisc").P_cr)) < 1e-12);
  }

  TEST_CASE("N is positive in tension: a bar in tension does not buckle") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.N = -20.0 * kN;
    CHECK(solve(in).loading == column::Loading::compression);
    CHECK(rel(in_si(solve(in).F), 20e3) < 1e-15);
    in.N = 20.0 * kN;
    CHECK(solve(in).loading == column::Loading::tension);
    CHECK(solve(in).u == 0.0);
  }

  TEST_CASE("in tension the plain stress is compared with the yield strength") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.N = 564.0 * kN;  // 40 mm by 60 mm times 235 MPa
    CHECK(rel(solve(in).x_t, 1.0) < 1e-12);
    in.N = -564.0 * kN;
    CHECK(solve(in).x_t == 0.0);
    in.R_e = unset<Stress>;
    CHECK(solve(in).x_t == 0.0);
    in.N = 1.0 * kN;
    CHECK(std::isnan(solve(in).x_t));
  }

  TEST_CASE("twice the length of the full bar: the same slenderness and stress at four times the load") {
    column::Buckling::Input in = bar_of_steel(Ends::fixed_pinned);
    column::Buckling::Input twice = in;
    twice.l *= 2.0, twice.b *= 2.0, twice.h *= 2.0;
    CHECK(rel(solve(twice).lambda, solve(in).lambda) < 1e-12);
    CHECK(rel(in_si(solve(twice).N_cr), 4 * in_si(solve(in).N_cr)) < 1e-12);
  }

  TEST_CASE("each axis has its own ends, and the larger slenderness governs") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    CHECK(solve(in).axis == column::AxisName::z);
    in.ends_z = Ends::fixed_fixed;
    CHECK(solve(in).axis == column::AxisName::y);
    CHECK(rel(solve(in).lambda, 1.8 / 0.06 * std::sqrt(12.0)) < 1e-12);
  }

  TEST_CASE("a support in the middle halves the effective length about its axis") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.supports_z.push_back({0.9 * m});
    CHECK(rel(solve(in).axes[1].beta, 0.5) < 1e-12);
    CHECK(rel(solve(in).axes[0].beta, 1.0) < 1e-12);
  }

  TEST_CASE("the weak principal axis of an angle governs") {
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.b = in.h = unset<Length>;
    in.A = from_si<Area>(1.92e-3);
    in.I_y = in.I_z = from_si<SecondMoment>(177e-8);
    in.I_min = from_si<SecondMoment>(73e-8);
    CHECK(rel(in_si(solve(in).axes[1].i), std::sqrt(73e-8 / 1.92e-3)) < 1e-12);
  }

  TEST_CASE("the kind of section, and with it the buckling curve, follows from the row of its table") {
    struct Row {
      const char *lines, *kind;
      double alpha_y, alpha_z;
    };
    for (const Row& row :
         {Row{"section = \"IPE 200\"", "rolled_I", 0.21, 0.34}, Row{"section = \"HEB 200\"", "rolled_I", 0.34, 0.49},
          Row{"section = \"W8X31\"", "rolled_I", 0.34, 0.49}, Row{"section = \"UPN 200\"", "channel", 0.49, 0.49},
          Row{"section = \"L 50x50x5\"", "angle", 0.34, 0.34},
          Row{"section = \"RHS 60x40x3\"", "hot_hollow", 0.21, 0.21},
          Row{"section = \"CHS 60.3x3\"\nkind = \"cold_hollow\"", "cold_hollow", 0.49, 0.49},
          Row{"section = \"CHS 60.3x3\"", "", 0.49, 0.49}}) {
      CAPTURE(row.lines);
      std::vector<Issue> issues;
      const auto project = solved(
          "[bar]\ncalculator = \"column.buckling\"\nl = \"2 m\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\n"
          "R_e = \"235 MPa\"\nmethod = \"johnson\"\n" +
              std::string(row.lines) + "\n",
          issues);
      REQUIRE(issues.empty());
      const auto& inputs = project.find("bar")->account().inputs;
      const auto kind = std::find_if(inputs.begin(), inputs.end(), [](const auto& e) { return e.path == "kind"; });
      CHECK((kind == inputs.end() ? "" : kind->word) == row.kind);  // an unset value is not shown
      CHECK(project.value("bar.axes.y.alpha")->si[0] == row.alpha_y);
      CHECK(project.value("bar.axes.z.alpha")->si[0] == row.alpha_z);
    }
    CHECK(complaints("calculator = \"column.buckling\"\nl = \"2 m\"\nends = \"pinned_pinned\"\nE = \"210 GPa\"\nR_e = "
                     "\"235 MPa\"\nmethod = \"johnson\"\nsection = \"RHS 60x40x3\"\nkind = \"cold_hollow\"\n")
              .find("kind = cold_hollow contradicts the section 'RHS 60x40x3', which has hot_hollow") !=
          std::string::npos);
  }

  TEST_CASE("SP 16: phi is the smaller root of its quadratic, falls from 1, and ends with its table") {
    struct Row {
      SectionKind kind;
      double lambda_r, phi;
    };
    for (const Row& row : {Row{SectionKind::hot_hollow, 1.0, 0.967809}, Row{SectionKind::rolled_I, 1.0, 0.947589},
                           Row{SectionKind::angle, 1.0, 0.900865}, Row{SectionKind::rolled_I, 3.0, 0.642786},
                           Row{SectionKind::hot_hollow, 6.0, 7.6 / 36.0}, Row{SectionKind::rolled_I, 0.6, 0.985686},
                           Row{SectionKind::hot_hollow, 0.4, 1.0}, Row{SectionKind::channel, 0.01, 1.0}}) {
      CAPTURE(row.lambda_r);
      column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
      in.kind = row.kind;
      const double lambda = row.lambda_r * std::sqrt(210e3 / 235.0) * (1.0 - 1e-15);
      CHECK(std::abs(stress(in, lambda, "sp16") / 235.0 - row.phi) < 1e-6);
    }
    column::Buckling::Input in = bar_of_steel(Ends::pinned_pinned);
    in.kind = SectionKind::channel;
    double before = 235.0 * (1 + 1e-12);
    for (double lambda = 1.0; lambda < 400.0; lambda += 1.0) {
      const double now = stress(in, lambda, "sp16");
      CHECK(now <= before);
      before = now;
    }
    CHECK(std::isnan(stress(in, 14.01 * std::sqrt(210e3 / 235.0), "sp16")));
  }
}
