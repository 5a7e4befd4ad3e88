// Cams: against the mechanisms that an eccentric is equivalent to, against the laws of lift, and joints that only
// push. Invariants of every joint type are tested in pairs.cpp and sensitivity.cpp.
#include "lib/mechanism/groups/system.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "lib/mechanism/studies/cam_state.hpp"
#include "tests/lib/mechanism/cam_models.hpp"
#include "tests/lib/mechanism/proof/methods.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace loadpath::mechanism;
using namespace loadpath::mechanism::models;
using std::numbers::pi;

constexpr double degree = pi / 180.0;

/// At this angle of the only driver, at 20 rad/s with 50 rad/s^2.
template <class System>
Position solved(System& system, const Model& model, double angle) {
  Position at = blank_position(model);
  const Drive drive{angle, 20.0, 50.0};
  REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
  return at;
}

struct Running {
  explicit Running(Model of) : model(std::move(of)), system(model) {
    CHECK(diagnose(model).empty());
    REQUIRE(system.assemble() == Status::closed);
  }
  Position operator()(double angle) { return solved(system, model, angle); }
  Model model;
  GroupSystem system;
};

constexpr double eccentricity = 0.011, radius = 0.03, roller = 0.008, offset = 0.005;

Model eccentric(CamContact contact, double roller_radius, double face = 0.0) {
  Model model;
  const int cam = add_cam(model, 0.8);
  const int follower = add_follower(model, offset, 0.04);
  const Profile circle(Circle{{eccentricity, 0.0}, radius});
  touch(model, follower, {}, cam, circle, contact, roller_radius, 0.0).angle = face;
  return model;
}

/// 1 m of a law's rise over the angle `beta`, by its own formula; s and its derivatives.
struct Expected {
  double s, first, second;
};
Expected cycloidal(double h, double beta, double phi) {
  const double x = 2.0 * pi * phi / beta;
  return {h * (phi / beta - std::sin(x) / (2.0 * pi)), h / beta * (1.0 - std::cos(x)),
          2.0 * pi * h / (beta * beta) * std::sin(x)};
}

double modified_sine_pieces(double x) {
  if (x < 0.125) return std::sin(0.5 * pi * x / 0.125);
  if (x < 0.875) return std::cos(pi * (x - 0.125) / 0.75);
  return -std::cos(0.5 * pi * (x - 0.875) / 0.125);
}

double modified_trapezoid_pieces(double x) {
  if (x > 0.5) return -modified_trapezoid_pieces(1.0 - x);
  if (x < 0.125) return std::sin(0.5 * pi * x / 0.125);
  return x < 0.375 ? 1.0 : std::cos(pi * (x - 0.375) / 0.25);
}

}  // namespace

TEST_SUITE("mechanism") {
  TEST_CASE("an eccentric with a roller is a slider-crank with a rod from centre to centre") {
    Model crank;
    const int shaft = add_cam(crank, 0.8);
    const int slider = add_follower(crank, offset, 0.04);
    const Vec A = turn(0.8)({eccentricity, 0.0}), B{-offset, 0.0455};
    const int rod = add_link(crank, "rod", {A.x, A.y, std::atan2(B.y - A.y, B.x - A.x)});
    pin(crank, "A", rod, {}, shaft, {eccentricity, 0.0});
    pin(crank, "B", slider, {}, rod, {radius + roller, 0.0});
    Running cam(eccentric(CamContact::round, roller)), equivalent(crank);
    for (double angle = 0.8; angle < 14.0; angle += 0.21) {
      CAPTURE(angle);
      const Position a = cam(angle), b = equivalent(angle);
      CHECK(a.pose[1].y == doctest::Approx(b.pose[1].y).epsilon(1e-13));
      CHECK(std::abs(a.velocity[1].y - b.velocity[1].y) <= 1e-13);
      CHECK(std::abs(a.acceleration[1].y - b.acceleration[1].y) <= 1e-11);
      CHECK(std::abs(a.effort[0] - b.effort[0]) <= 1e-11);
      CHECK(length(a.reactions[2].force - b.reactions[3].force) <= 1e-9);
      CHECK(length(a.reactions[1].force - b.reactions[1].force) <= 1e-9);
      CHECK(std::abs(a.reactions[1].couple - b.reactions[1].couple) <= 1e-10);
    }
  }

  TEST_CASE("an eccentric under a flat face is a yoke with a slot, also an oblique one") {
    for (const double face : {0.0, 0.3}) {
      CAPTURE(face);
      Model yoke;
      const int shaft = add_cam(yoke, 0.8);
      const int slider = add_follower(yoke, offset, 0.04);
      slot(yoke, "A", shaft, {eccentricity, 0.0}, slider, turn(face)({0.0, -radius}), face);
      Running cam(eccentric(CamContact::flat, 0.0, face)), equivalent(yoke);
      for (double angle = 0.8; angle < 14.0; angle += 0.23) {
        CAPTURE(angle);
        const Position a = cam(angle), b = equivalent(angle);
        CHECK(a.pose[1].y == doctest::Approx(b.pose[1].y).epsilon(1e-13));
        CHECK(std::abs(a.acceleration[1].y - b.acceleration[1].y) <= 1e-11);
        CHECK(std::abs(a.effort[0] - b.effort[0]) <= 1e-11);
        CHECK(length(a.reactions[2].force + b.reactions[2].force) <= 1e-9);
        CHECK(std::abs(a.reactions[1].couple - b.reactions[1].couple) <= 1e-10);
      }
    }
  }

  TEST_CASE("the follower moves by the law of its lift, whatever touches the cam") {
    const double h = 0.012, beta = 120.0 * degree, omega = 20.0, epsilon = 50.0;
    const double start = std::sqrt(0.04 * 0.04 - 0.006 * 0.006);
    Running run(cam_with_roller(LiftLaw::cycloidal));
    for (const double phi : {0.3, 0.9, 1.6, 2.0}) {
      const Expected s = cycloidal(h, beta, phi);
      const Position at = run(phi + 4.0 * pi);
      CHECK(at.pose[1].y == doctest::Approx(start + s.s).epsilon(1e-13));
      CHECK(at.velocity[1].y == doctest::Approx(s.first * omega).epsilon(1e-12));
      CHECK(std::abs(at.acceleration[1].y - (s.second * omega * omega + s.first * epsilon)) <= 1e-10);
      // Pressure angle with the guide on the left, the cam counter-clockwise: tan = (s' + e) / (s + s0).
      const double pressure = *cam_state(run.model, 2, at).pressure_angle;
      CHECK(std::tan(pressure) == doctest::Approx((s.first + 0.006) / (start + s.s)).epsilon(1e-11));
    }
    Running flat(cam_with_flat_face(LiftLaw::cycloidal));
    for (const double phi : {0.3, 0.9, 1.6, 2.0}) {
      const Expected s = cycloidal(0.008, beta, phi);
      const Position at = flat(phi);
      CHECK(at.pose[1].y == doctest::Approx(0.03 + s.s).epsilon(1e-13));
      CHECK(std::abs(at.acceleration[1].y - (s.second * omega * omega + s.first * epsilon)) <= 1e-10);
      // It touches as far to the side as the lift is steep.
      CHECK(std::abs(at.reactions[2].at.x) == doctest::Approx(s.first).epsilon(1e-11));
      CHECK(*cam_state(flat.model, 2, at).pressure_angle <= 1e-13);
    }
    Running arm(cam_with_arm());
    const double base = std::acos((0.07 * 0.07 + 0.06 * 0.06 - 0.038 * 0.038) / (2.0 * 0.07 * 0.06));
    // 4-5-6-7 over 120 degrees by 0.3 rad, at a quarter and at the middle of the rise.
    CHECK(pi - arm(30.0 * degree).pose[1].phi - base == doctest::Approx(0.3 * 0.070556640625).epsilon(1e-11));
    CHECK(pi - arm(60.0 * degree).pose[1].phi - base == doctest::Approx(0.15).epsilon(1e-12));
    CHECK(std::abs(arm(140.0 * degree).velocity[1].phi) <= 1e-12);
  }

  TEST_CASE("laws of lift rise by one from rest to rest, and their derivatives are those of the rise") {
    constexpr double h = 1e-4;
    using enum LiftLaw;
    for (const LiftLaw law :
         {harmonic, cycloidal, polynomial_345, polynomial_4567, modified_sine, modified_trapezoid}) {
      CAPTURE(static_cast<int>(law));
      const Lift lift = rise_dwell_fall(law, 1.0);
      CHECK(lift.at(120.0 * degree).s == doctest::Approx(1.0).epsilon(1e-14));
      CHECK(lift.at(60.0 * degree).s == doctest::Approx(0.5).epsilon(1e-14));
      CHECK(std::abs(lift.at(120.0 * degree).first) <= 1e-12);
      CHECK(std::abs(lift.at(-1e-9).s) <= 1e-12);
      for (const double phi : {0.4, 1.1, 2.0, 3.1, 4.4, 6.0, 7.0, -1.5}) {
        CAPTURE(phi);
        const double slope = (lift.at(phi + h).s - lift.at(phi - h).s) / (2.0 * h);
        const double bend = (lift.at(phi + h).first - lift.at(phi - h).first) / (2.0 * h);
        CHECK(std::abs(slope - lift.at(phi).first) <= 1e-6);
        CHECK(std::abs(bend - lift.at(phi).second) <= 1e-6);
      }
    }
    CHECK(rise_dwell_fall(harmonic, 0.01).jumps().size() == 4);
    for (const LiftLaw law : {cycloidal, polynomial_345, polynomial_4567, modified_sine, modified_trapezoid})
      CHECK(rise_dwell_fall(law, 0.01).jumps().empty());
  }

  // Peaks as MechDesigner's reference of motion laws and Rothbart's handbook have them, in h/T and h/T^2.
  TEST_CASE("modified sine and modified trapezoid are their pieces of acceleration, integrated twice") {
    struct Case {
      LiftLaw law;
      double (*pieces)(double x);  // up to a factor
      double velocity, acceleration;
    };
    for (const Case& c : {Case{LiftLaw::modified_sine, modified_sine_pieces, 1.7596, 5.5280},
                          Case{LiftLaw::modified_trapezoid, modified_trapezoid_pieces, 2.0, 4.8881}}) {
      CAPTURE(static_cast<int>(c.law));
      const Lift lift(std::vector<LiftSegment>{{c.law, 1.0, 1.0}, {LiftLaw::dwell, 2.0 * pi - 1.0, 0.0}});
      constexpr int parts = 40000;
      const double step = 1.0 / parts;
      double whole = 0.0, speed = 0.0;
      for (int k = 0; k < parts; ++k) {
        whole += step * (speed + 0.5 * step * c.pieces((k + 0.5) * step));
        speed += step * c.pieces((k + 0.5) * step);
      }
      CHECK(std::abs(speed) <= 1e-12);
      double s = 0.0, v = 0.0, fastest = 0.0, steepest = 0.0;
      for (int k = 0; k < parts; ++k) {
        const double x = k * step, a = c.pieces(x + 0.5 * step) / whole;
        if (k % 37 == 0) {
          CAPTURE(x);
          CHECK(std::abs(lift.at(x).s - s) <= 1e-8);
          CHECK(std::abs(lift.at(x).first - v) <= 1e-7);
          CHECK(std::abs(lift.at(x).second - c.pieces(x) / whole) <= 1e-7);
        }
        fastest = std::max(fastest, lift.at(x).first);
        steepest = std::max(steepest, std::abs(lift.at(x).second));
        s += step * (v + 0.5 * step * a);
        v += step * a;
      }
      CHECK(std::abs(fastest - c.velocity) <= 5e-5);
      CHECK(std::abs(steepest - c.acceleration) <= 5e-5);
      for (const double x : {0.125, 0.375, 0.5, 0.625, 0.875}) {
        CHECK(std::abs(lift.at(x + 1e-12).second - lift.at(x - 1e-12).second) <= 1e-9);
        CHECK(std::abs(lift.at(x + 1e-12).s - lift.at(x - 1e-12).s) <= 1e-11);
      }
    }
  }

  TEST_CASE("the tightest bends of a profile") {
    const double whole = 2.0 * pi;
    const auto harmonic = [&](double h) {
      return Lift(std::vector<LiftSegment>{{LiftLaw::harmonic, pi, h}, {LiftLaw::harmonic, pi, -h}});
    };
    // A harmonic lift under a flat face comes from a circle: base + h (1 - cos)/2 + h cos/2.
    CHECK(bends_of(Profile(FlatFollower{harmonic(0.01), {}, 0.03})).bulge == doctest::Approx(0.035).epsilon(1e-12));
    // Twice a turn: base + h/2 - 3/2 h, undercut where the base circle is smaller than that.
    const Lift twice(std::vector<LiftSegment>{{LiftLaw::harmonic, 0.25 * whole, 0.01},
                                              {LiftLaw::harmonic, 0.25 * whole, -0.01},
                                              {LiftLaw::harmonic, 0.25 * whole, 0.01},
                                              {LiftLaw::harmonic, 0.25 * whole, -0.01}});
    CHECK(bends_of(Profile(FlatFollower{twice, {}, 0.03})).bulge == doctest::Approx(0.02).epsilon(1e-6));
    CHECK(bends_of(Profile(FlatFollower{twice, {}, 0.009})).bulge < 0.0);
    // The path of a roller without offset: rho = (r^2 + s'^2)^(3/2) / (r^2 + 2 s'^2 - r s'').
    const Profile profile(SlidingFollower{rise_dwell_fall(LiftLaw::cycloidal, 0.012), {}, 0.04, 0.0}, 0.01);
    for (const double phi : {0.4, 1.2, 1.9}) {
      const Expected s = cycloidal(0.012, 120.0 * degree, phi);
      const double r = 0.04 + s.s,
                   rho = std::pow(r * r + s.first * s.first, 1.5) / (r * r + 2.0 * s.first * s.first - r * s.second);
      const CurvePoint on = profile.at(-phi);
      CHECK(on.pace / on.turning == doctest::Approx(rho).epsilon(1e-12));
    }
    const Bends oval = bends_of(Profile(SplineCurve(oval_points(48, 0.03, 0.025, {}))));
    CHECK(oval.bulge == doctest::Approx(0.025 * 0.025 / 0.03).epsilon(1e-2));
    CHECK(std::isinf(oval.hollow));
  }

  TEST_CASE("a smooth profile through points of a circle is that circle, with the same curvature all round") {
    const Profile spline(SplineCurve(oval_points(36, 0.03, 0.03, {0.01, -0.005})));
    for (double u = 0.0; u < 6.3; u += 0.01) {
      const CurvePoint on = spline.at(u);
      CHECK(length(on.at - Vec{0.01, -0.005}) == doctest::Approx(0.03).epsilon(1e-5));
      CHECK(on.pace / on.turning == doctest::Approx(0.03).epsilon(1e-2));
    }
    const CurvePoint before = spline.at(2.0 * pi - 1e-9), after = spline.at(1e-9);
    CHECK(before.turning == doctest::Approx(after.turning).epsilon(1e-6));
  }

  TEST_CASE("a follower under a spring lifts off above the speed at which m a is the spring force") {
    const double h = 0.012, m = 0.8, k = 3000.0, squeeze = 0.01, g = 9.81;
    Model model = cam_with_roller(LiftLaw::cycloidal, 0.0);
    model.loads.clear();
    const double rest = 0.04;  // position of the follower on the base circle
    model.springs.push_back({"spring", Spring::Kind::linear, 1, ground, {}, {0.0, rest + 0.1}, k, 0.1 + squeeze, 0.0});
    double least = 1e300;  // of omega^2, where the follower slows down
    for (double phi = 0.0; phi < 120.0 * degree; phi += 1e-5) {
      const Expected s = cycloidal(h, 120.0 * degree, phi);
      if (s.second < 0.0) least = std::min(least, (k * (squeeze + s.s) + m * g) / (-m * s.second));
    }
    GroupSystem system(model);
    REQUIRE(system.assemble() == Status::closed);
    for (const double part : {0.999, 1.001}) {
      double pressing = 1e300;
      Position at = blank_position(model);
      for (double phi = 0.7; phi < 0.7 + 2.0 * pi; phi += 1e-3) {
        const Drive drive{phi, part * std::sqrt(least), 0.0};
        REQUIRE(system.solve({&drive, 1}, at) == Status::closed);
        pressing = std::min(pressing, cam_state(model, 2, at).pressing);
      }
      CHECK((pressing < 0.0) == (part > 1.0));
    }
  }

  TEST_CASE("a flat face rubs with mu N against its sliding, and the drive supplies the power") {
    Model model = cam_with_flat_face();
    Running smooth(model);
    model.joints.back().friction.coefficient = 0.15;
    Running rough(model);
    for (const double phi : {0.4, 1.0, 1.7, 3.5}) {
      CAPTURE(phi);
      const Position a = smooth(phi), b = rough(phi);
      const CamState state = cam_state(model, 2, b);
      REQUIRE(state.pressing > 0.0);
      const Vec tangent{-1.0, 0.0};  // counter-clockwise round the cam, below the face
      CHECK(dot(b.reactions[2].force, tangent) ==
            doctest::Approx(-0.15 * state.pressing * std::copysign(1.0, state.sliding)).epsilon(1e-11));
      // The drive supplies the friction work; the guide has no friction.
      CHECK((b.effort[0] - a.effort[0]) * 20.0 ==
            doctest::Approx(0.15 * state.pressing * std::abs(state.sliding)).epsilon(1e-10));
    }
  }

  TEST_CASE("random cams with arms: both solvers agree, and every proof holds") {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    for (int n = 0; n < 40; ++n) {
      CAPTURE(n);
      const double side = n % 2 == 0 ? 1.0 : -1.0, pivot = between(0.06, 0.1), length = between(0.05, 0.09);
      const double reach = between(std::abs(pivot - length) + 0.02, 0.7 * (pivot + length)), roll = between(0.0, 0.01);
      const auto sense = n % 3 == 0 ? CamSense::clockwise : CamSense::counter_clockwise;
      const auto law = static_cast<LiftLaw>(1 + n % 4);
      const SwingingFollower path{rise_dwell_fall(law, between(0.05, 0.3)), sense, reach, pivot, length, side};
      Model model;
      const int cam = add_cam(model, between(-3.0, 3.0));
      const double start = model.links[0].pose.phi;
      // The position of the arm, by its own law: the cam's angle counts against its direction.
      const double angle = sense == CamSense::clockwise ? -start : start;
      const double swing = path.base_angle() + path.lift.at(angle).s;
      const int arm = add_bar(model, "arm", {pivot, 0.0, pi - side * swing}, length, between(0.1, 1.0));
      pin(model, "A", arm, {}, ground, {pivot, 0.0});
      load(model, "press", arm, {0.8 * length, 0.0}, {between(-50.0, 50.0), between(-300.0, 300.0)},
           between(-2.0, 2.0));
      touch(model, arm, {length, 0.0}, cam, Profile(path, roll), CamContact::round, roll, 0.0);
      Running groups(model);
      WholeSystem whole(model);
      REQUIRE(whole.assemble() == Status::closed);
      Prover prover(model);
      for (int k = 0; k < 12; ++k) {
        const Drive drive{start + 0.55 * k, 20.0, 50.0};
        const Position a = groups(drive.coordinate), b = solved(whole, model, drive.coordinate);
        CHECK(std::abs(a.pose[1].phi - b.pose[1].phi) <= 1e-11);
        CHECK(std::abs(a.effort[0] - b.effort[0]) <= 1e-9 * (1.0 + std::abs(b.effort[0])));
        const double now =
            path.base_angle() + path.lift.at(sense == CamSense::clockwise ? -drive.coordinate : drive.coordinate).s;
        CHECK(std::abs(a.pose[1].phi - (pi - side * now)) <= 1e-11);
        check_trustworthy(prover.prove({&drive, 1}, false, a));
      }
    }
  }

  TEST_CASE("random cams under a swinging face: it swings by the law, and every proof holds") {
    std::mt19937 random(11);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    for (int n = 0; n < 48; ++n) {
      CAPTURE(n);
      const SwingingFace face{rise_dwell_fall(static_cast<LiftLaw>(1 + n % 6), between(0.05, 0.3)),
                              n % 3 == 0 ? CamSense::clockwise : CamSense::counter_clockwise,
                              between(0.015, 0.03),
                              between(0.06, 0.1),
                              between(-0.01, 0.015),
                              n % 2 == 0 ? 1.0 : -1.0};
      Model model;
      const int cam = add_cam(model, between(-3.0, 3.0));
      const double start = model.links[0].pose.phi;
      const int arm = add_face(model, face, cam, start, 0.08);
      load(model, "press", arm, {0.07, 0.0}, {between(-50.0, 50.0), between(-300.0, 300.0)}, between(-2.0, 2.0));
      Running groups(model);
      WholeSystem whole(model);
      REQUIRE(whole.assemble() == Status::closed);
      Prover prover(model);
      for (int k = 0; k < 12; ++k) {
        const Drive drive{start + 0.55 * k, 20.0, 50.0};
        const Position a = groups(drive.coordinate), b = solved(whole, model, drive.coordinate);
        CHECK(std::abs(a.pose[1].phi - b.pose[1].phi) <= 1e-11);
        CHECK(std::abs(a.effort[0] - b.effort[0]) <= 1e-9 * (1.0 + std::abs(b.effort[0])));
        const double sense = face.sense == CamSense::clockwise ? -1.0 : 1.0;
        const auto law = face.lift.at(sense * drive.coordinate);
        const double swing = face.base_angle() + law.s, rate = sense * law.first;
        CHECK(std::abs(a.pose[1].phi - (pi - face.side * swing)) <= 1e-11);
        CHECK(std::abs(a.velocity[1].phi + face.side * rate * 20.0) <= 1e-10);
        CHECK(std::abs(a.acceleration[1].phi + face.side * (law.second * 400.0 + rate * 50.0)) <= 1e-8);
        // By the instant centre of cam and face, which is on the line of the axes: pivot cos / (1 + rate of the face).
        const Vec along = turn(a.pose[1].phi)({1.0, 0.0});
        CHECK(dot(a.reactions[2].at - Vec{face.pivot, 0.0}, along) ==
              doctest::Approx(face.pivot * std::cos(swing) / (1.0 + face.side * rate)).epsilon(1e-9));
        check_trustworthy(prover.prove({&drive, 1}, false, a));
      }
    }
  }

  TEST_CASE("the flank under a swinging face: its tangent and bend, far pivots, undercut") {
    const SwingingFace face{
        rise_dwell_fall(LiftLaw::polynomial_4567, 0.25), CamSense::clockwise, 0.03, 0.08, 0.006, -1.0};
    const Profile profile(face);
    constexpr double h = 1e-5;
    for (double u = 0.05; u < 6.2; u += 0.31) {
      CAPTURE(u);
      const CurvePoint on = profile.at(u), before = profile.at(u - h), after = profile.at(u + h);
      CHECK(length((1.0 / (2.0 * h)) * (after.at - before.at) - on.pace * on.tangent) <= 1e-8);
      CHECK(std::abs(cross(before.tangent, after.tangent) / (2.0 * h) - on.turning) <= 1e-7);
      CHECK(dot(on.at, outward(on.tangent)) > 0.0);
    }
    // About a pivot that is far away a face swings as if it slid; it is square to its guide where it is level then.
    const double far = 1e5, rise = 0.008;
    const Profile swung(SwingingFace{rise_dwell_fall(LiftLaw::cycloidal, rise / far), {}, 0.03, far, -0.03, 1.0});
    const Profile slid(FlatFollower{rise_dwell_fall(LiftLaw::cycloidal, rise), {}, 0.03});
    for (double u = 0.05; u < 6.2; u += 0.31) {
      const CurvePoint a = swung.at(u), b = slid.at(u);
      CHECK(length(a.at - turn(quarter_turn)(b.at)) <= 1e-6);
      CHECK(std::abs(a.pace / a.turning - b.pace / b.turning) <= 1e-6);
    }
    const auto bulge = [](double base) {
      return bends_of(Profile(SwingingFace{rise_dwell_fall(LiftLaw::cycloidal, 0.3), {}, base, 0.08, 0.0, 1.0})).bulge;
    };
    CHECK(bulge(0.05) > 0.0);
    CHECK(bulge(0.01) < 0.0);
    CHECK(std::isinf(bends_of(profile).hollow));
  }

  TEST_CASE("a follower leaves its dwell, and reaches it, as at any other position") {
    for (const double step : {1.0, 5.0, 15.0}) {
      CAPTURE(step);
      for (const Model& model : {cam_with_roller(LiftLaw::cycloidal), cam_with_flat_face(LiftLaw::polynomial_345)}) {
        Running run(model);
        int in_steps = 0;
        for (double angle = 0.7; angle < 7.5; angle += step * degree) {
          run(angle);
          in_steps += run.system.followed_in_steps() ? 1 : 0;
        }
        CHECK(in_steps == 0);
      }
    }
  }

  TEST_CASE("a cam removes one degree of freedom") {
    const Structure structure = analyse(cam_with_roller());
    CHECK(structure.mobility_by_count == 1);
    CHECK(structure.mobility == 1);
    CHECK(structure.redundant.empty());
    // A roller that is a link of its own has one more, which is named.
    Model rolling = cam_with_roller();
    const int roller_link = add_link(rolling, "roller", rolling.links[1].pose, 0.1, 1e-6);
    pin(rolling, "R", roller_link, {}, 1, {});
    rolling.joints[2].i = roller_link;
    const auto findings = diagnose(rolling);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].message.text() ==
          "the roller 'roller' spins about 'R' whatever the drive does: a passive freedom");
    Model bare = cam_with_roller();
    bare.joints.back().profile = nullptr;
    CHECK(check_parts(bare).size() == 1);
  }
}
