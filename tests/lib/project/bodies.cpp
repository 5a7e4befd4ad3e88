// Steps that describe one physical part: one size, the largest that they require.
#include "tests/lib/project/solved.hpp"
#include "tests/lib/project/texts.hpp"

#include <doctest/doctest.h>

#include <string>

namespace {

using namespace loadpath;
using account::State;
using test::contains;
using test::Solved;

std::string torsion(const std::string& name, const std::string& T, const std::string& more) {
  return "[" + name + "]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\nT = \"" + T + "\"\n" + more;
}
const std::string body = "body = \"crankshaft\"\n", less = "because.T = \"between the wheels\"\n";

}  // namespace

TEST_SUITE("project bodies") {
  TEST_CASE("a body has the largest size that its steps require, and all are assessed at it") {
    // d = (16 T/(pi tau))^(1/3): 53.46 mm of 900 N m, 37.07 mm of 300 N m
    const std::string strong = torsion("strong", "900 N*m", ""), weak = torsion("weak", "300 N*m", "");
    const Solved apart(strong + weak);
    CHECK(apart.value("strong.d") == doctest::Approx(0.056));
    CHECK(apart.value("weak.d") == doctest::Approx(0.0375));
    for (const std::string& text : {strong + body + weak + body + less, weak + body + less + strong + body}) {
      const Solved one(text);
      CHECK(one.value("strong.d") == doctest::Approx(0.056));
      CHECK(one.value("weak.d") == doctest::Approx(0.056));
      // 16 300 N m/(pi 56^3) = 8.70 MPa
      CHECK(*one.mode("weak.yield").utilisation == doctest::Approx(8.70 / 30.0).epsilon(1e-3));
      CHECK(contains(one.origin("weak", "d"), "the body 'crankshaft' has this size: strong"));
    }
  }

  TEST_CASE("results that depend on the size are computed with the size of the body") {
    const Solved one(torsion("strong", "900 N*m", body) + torsion("weak", "300 N*m", body) +
                     torsion("other", "1 N*m", "d = \"=weak.d\"\n"));
    CHECK(one.value("other.d") == doctest::Approx(0.056));
  }

  TEST_CASE("a size that one step gives is that of the body, sufficient or not") {
    const Solved thin(torsion("strong", "900 N*m", body) + torsion("weak", "300 N*m", "d = \"40 mm\"\n" + body));
    CHECK(thin.value("strong.d") == doctest::Approx(0.040));
    CHECK(thin.mode("strong.yield").state == State::fail);
    const Solved thick(torsion("strong", "900 N*m", body) + torsion("weak", "300 N*m", "d = \"=30 mm*2\"\n" + body));
    CHECK(thick.value("strong.d") == doctest::Approx(0.060));
    CHECK(thick.mode("strong.yield").state == State::pass);
  }

  TEST_CASE("two given sizes contradict each other") {
    const Solved two(torsion("strong", "900 N*m", "d = \"60 mm\"\n" + body) +
                     torsion("weak", "300 N*m", "d = \"40 mm\"\n" + body));
    CHECK(contains(two.errors(), "the body 'crankshaft' needs a single d, but strong has 60 mm and weak has 40 mm"));
  }

  TEST_CASE("a body is of one material") {
    const auto of = [](const std::string& material) { return "material = \"" + material + "\"\nS = 1.5\n"; };
    const std::string T = "[a]\ncalculator = \"shaft.torsion\"\nT = \"900 N*m\"\n",
                      T_b = "[b]\ncalculator = \"shaft.torsion\"\nT = \"300 N*m\"\n";
    CHECK(Solved(T + of("C45E") + body + T_b + of("C45E") + body).errors().empty());
    CHECK(contains(Solved(T + of("C45E") + body + T_b + of("S235JR") + body).errors(),
                   "the body 'crankshaft' needs a single material, but a has 'C45E' and b has 'S235JR'"));
  }

  TEST_CASE("a body has one section, also where it is searched for") {
    const auto strut = [](const std::string& name, const std::string& P, const std::string& section) {
      return "[" + name + "]\ncalculator = \"column.buckling\"\nbody = \"strut\"\nP = \"" + P +
             "\"\nl = \"3 m\"\nsection = { stock = \"sections/heb\" }\nmaterial = \"S235JR\"\nmethod = \"ec3\"\n"
             "gamma_M1 = 1.1\ngamma_F = 1.35\nends = \"pinned_pinned\"\n" +
             section;
    };
    CHECK(contains(Solved(strut("a", "100 kN", "") + strut("b", "900 kN", "")).errors(),
                   "the body 'strut' needs a single section"));
    CHECK(Solved(strut("a", "900 kN", "") + strut("b", "900 kN", "")).errors() == "");
  }

  TEST_CASE("a body with only one step, and steps without a common size, are refused") {
    CHECK(contains(Solved(torsion("strong", "900 N*m", body)).errors(), "no other step describes the body"));
    const Solved typo(torsion("a", "900 N*m", body) + torsion("b", "900 N*m", body) +
                      torsion("c", "900 N*m", "body = \"crankshat\"\n"));
    CHECK(contains(typo.errors(), "did you mean 'crankshaft'?"));
    const std::string flywheel = "[wheel]\ncalculator = \"machine.run_up\"\n" + body;
    CHECK(contains(Solved(torsion("a", "900 N*m", body) + flywheel).errors(), "no size in common"));
  }
}
