#include "calculators/motion/rotation.hpp"

#include "tests/calculators/motion/solved.hpp"

using namespace loadpath;
using namespace loadpath::test;

namespace {

SolvedStep rotor(const std::string& lines) { return {"motion.rotation", lines}; }

}  // namespace

TEST_SUITE("motion rotation") {
  TEST_CASE("a uniform rotation has a normal acceleration only") {
    const auto r = rotor("phi = \"4 rad*t/(1 s)\"\nt = \"3 s\"\nR = \"250 mm\"\n");
    CHECK(near(r("omega"), 4.0));
    CHECK(r.word("change") == "steady");
    CHECK(r("a_tau") == 0.0);
    CHECK(near(r("a_n"), 4.0));
    CHECK(r("mu") == 0.0);
  }

  TEST_CASE("a body that turns backwards and is decelerated has the corresponding signs") {
    const auto r = rotor("phi = \"-10 rad*t/(1 s) + 1 rad*t^2/(1 s^2)\"\nt = \"2 s\"\nR = \"1 m\"\n");
    CHECK(near(r("omega"), -6.0));
    CHECK(near(r("epsilon"), 2.0));
    CHECK(r.word("change") == "slower");
    CHECK(near(r("a"), std::sqrt(4.0 + 1296.0)));
  }

  TEST_CASE("revolutions are the angle over 2 pi, and the mean speed the angle over the time") {
    const auto r = rotor("phi = \"90 deg*(t/(1 s))^2\"\nt = \"0 s\"\nt_1 = \"0 s\"\nt_2 = \"4 s\"\n");
    CHECK(near(r("turns"), 4.0));
    CHECK(near(r("omega_m"), 2.0 * 3.14159265358979));
    CHECK(r.word("change") == "at_rest");
  }

  TEST_CASE("speed and acceleration of a point increase with its radius") {
    const std::string law = "phi = \"1 rad*(t/(1 s))^3\"\nt = \"1 s\"\nR = ";
    const auto a = rotor(law + "\"100 mm\"\n"), b = rotor(law + "\"300 mm\"\n");
    CHECK(near(b("v"), 3.0 * a("v")));
    CHECK(near(b("a"), 3.0 * a("a")));
    CHECK(near(b("mu"), a("mu")));
  }

  TEST_CASE("the drawn speed covers the required range") {
    motion::Rotation::Input in;  // phi = t^3: omega = 3 t^2
    in.phi = "1 rad*(t/(1 s))^3";
    in.t = 2.0 * sec, in.t_1 = 1.0 * sec, in.t_2 = 3.0 * sec;
    NoTrace trace;
    const auto figures = motion::Rotation::figures(in, motion::Rotation::evaluate(in, trace));
    REQUIRE(!figures.empty());
    const auto& curve = std::get<figure::Plot>(figures[0].content).curves.at(0);
    CHECK(curve.x.front() == 1.0);
    CHECK(curve.x.back() == 3.0);
    for (std::size_t i = 0; i < curve.x.size(); ++i) CHECK(near(curve.y[i], 3.0 * curve.x[i] * curve.x[i]));
  }

  TEST_CASE("an impossible rotation is refused with the reason") {
    const Refused rows[] = {{"phi = \"3 m\"\nt = \"0 s\"\n", "expected"},
                            {"phi = \"1 rad*sqrt(t/(1 s))\"\nt = \"-1 s\"\n", "no value, speed or acceleration"},
                            {"phi = \"1 rad\"\nt = \"0 s\"\nt_2 = \"1 s\"\n", "give both t_1 and t_2, or neither"},
                            {"phi = \"1 rad\"\nt = \"0 s\"\nR = \"-1 mm\"\n", "must be"}};
    check_refusals("motion.rotation", rows);
  }
}
