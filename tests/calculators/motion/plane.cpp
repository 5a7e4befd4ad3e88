#include "tests/calculators/motion/solved.hpp"

using namespace loadpath::test;

namespace {

SolvedStep body(const std::string& lines) { return {"motion.plane", lines}; }

const std::string level = "A = [\"0 m\", \"0 m\"]\nB = [\"2 m\", \"0 m\"]\nv_A = \"1 m/s\"\nalpha_A = \"90 deg\"\n";

}  // namespace

TEST_SUITE("motion plane") {
  TEST_CASE("equal velocities across AB are a translation, without a pole") {
    const auto b = body(level + "v_B = \"1 m/s\"\nalpha_B = \"90 deg\"\n");
    CHECK(b.word("kind") == "translation");
    CHECK(b("omega") == 0.0);
    CHECK(std::isnan(b("x_P")));
  }

  TEST_CASE("equal and opposite velocities are a rotation about the middle of AB") {
    const auto b = body(level + "v_B = \"-1 m/s\"\nalpha_B = \"90 deg\"\n");
    CHECK(b.word("kind") == "rotation");
    CHECK(near(b("x_P"), 1.0));
    CHECK(b("y_P") == 0.0);
    CHECK(near(b("omega"), -1.0));
  }

  TEST_CASE("with unequal velocities across AB the pole lies on AB, outside where they have the same direction") {
    CHECK(near(body(level + "v_B = \"3 m/s\"\nalpha_B = \"90 deg\"\n")("x_P"), -1.0));
    CHECK(near(body(level + "v_B = \"-3 m/s\"\nalpha_B = \"90 deg\"\n")("x_P"), 0.5));
  }

  TEST_CASE("parallel velocities oblique to AB are a translation") {
    const auto b = body(
        "A = [\"0 m\", \"0 m\"]\nB = [\"2 m\", \"1 m\"]\nv_A = \"1 m/s\"\nalpha_A = \"90 deg\"\n"
        "alpha_B = \"90 deg\"\n");
    CHECK(b.word("kind") == "translation");
    CHECK(b.word("found") == "inclined");
    CHECK(near(b("v_B"), 1.0));
  }

  TEST_CASE("every point moves perpendicular to the line to the pole, with a speed proportional to its distance") {
    const auto b = body(
        "A = [\"0 m\", \"4 m\"]\nB = [\"3 m\", \"0 m\"]\nv_A = \"0.6 m/s\"\nalpha_A = \"-90 deg\"\n"
        "alpha_B = \"0 deg\"\npoints = [{ name = \"C\", x = \"-1 m\", y = \"7 m\" }]\n");
    const double dx = -1.0 - b("x_P"), dy = 7.0 - b("y_P");
    CHECK(near(b("states.C.v"), b("omega") * std::hypot(dx, dy)));
    CHECK(std::abs(b("states.C.v_x") * dx + b("states.C.v_y") * dy) < 1e-12);
  }

  TEST_CASE("the pole of accelerations has zero acceleration") {
    const auto b = body(
        "A = [\"1 m\", \"2 m\"]\nv_A = \"3 m/s\"\nomega = \"2 rad/s\"\na_A = \"5 m/s^2\"\n"
        "alpha_aA = \"30 deg\"\nepsilon = \"-3 rad/s^2\"\n");
    const std::string Q = "x = \"" + std::to_string(b("x_Q")) + " m\", y = \"" + std::to_string(b("y_Q")) + " m\"";
    const auto again = body(
        "A = [\"1 m\", \"2 m\"]\nv_A = \"3 m/s\"\nomega = \"2 rad/s\"\na_A = \"5 m/s^2\"\n"
        "alpha_aA = \"30 deg\"\nepsilon = \"-3 rad/s^2\"\npoints = [{ name = \"Q\", " +
        Q + " }]\n");
    CHECK(again("states.Q.a") < 2e-5);  // the place is given to six digits
  }

  TEST_CASE("a body at rest is reported as at rest") {
    const auto b = body("A = [\"0 m\", \"0 m\"]\nv_A = \"0 m/s\"\nomega = \"0 rad/s\"\n");
    CHECK(b.word("kind") == "rest");
  }

  TEST_CASE("input that does not fit a rigid body is refused with the reason") {
    const std::string A = "A = [\"0 m\", \"0 m\"]\nv_A = \"1 m/s\"\n";
    const std::string AB = A + "B = [\"2 m\", \"0 m\"]\n";
    const std::string rows[][2] = {
        {A, "give one of the two"},
        {AB, "give one of the two"},
        {AB + "omega = \"1 rad/s\"\nalpha_B = \"0 deg\"\n", "give one of the two"},
        {A + "B = [\"0 m\", \"0 m\"]\nalpha_B = \"0 deg\"\n", "A and B must be different points"},
        {level + "alpha_B = \"90 deg\"\n", "does not follow from that of A"},
        {AB + "alpha_B = \"0 deg\"\nv_B = \"2 m/s\"\n", "AB would change its length"},
        {AB + "alpha_B = \"0 deg\"\na_A = \"1 m/s^2\"\n", "need epsilon"},
        {AB + "alpha_B = \"0 deg\"\nepsilon = \"1 rad/s^2\"\n", "that of A"},
        {AB + "alpha_B = \"0 deg\"\na_A = \"1 m/s^2\"\nalpha_aB = \"90 deg\"\n", "must not be perpendicular"}};
    for (const auto& row : rows) {
      CAPTURE(row[0]);
      const std::string fault = body(row[0]).fault();
      CAPTURE(fault);
      CHECK(contains(fault, row[1]));
    }
  }
}
