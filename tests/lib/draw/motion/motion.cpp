#include "lib/draw/motion/motion.hpp"

#include "lib/draw/scheme/fit.hpp"
#include "lib/draw/svg.hpp"
#include "tests/lib/draw/figures.hpp"
#include "tests/lib/draw/svg_reader.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>

using namespace loadpath::draw;
using namespace loadpath::figure;
using namespace loadpath::draw::test;
namespace json = boost::json;

namespace {

/// A crank of 0.1 m that turns by a quarter in 91 frames; at its pin a force that turns with it, at O the opposite.
Figure crank(const std::string& name = "crank") {
  Motion motion;
  motion.still.bodies = {{name, {{0.0, 0.0}, {0.1, 0.0}}}};
  motion.still.joints = {{"O", {0.0, 0.0}, Scheme::Pin::revolute, true, 0.0}, {"A", {0.1, 0.0}}};
  motion.still.arrows = {{{0.0, 0.0}, {-500.0, 0.0}, "R_O", false}, {{0.1, 0.0}, {500.0, 0.0}, "F", true}};
  motion.still.moments = {{{0.0, 0.0}, 2.0, "M"}};
  motion.joints = {{-1, -1}, {0, -1}};
  motion.links.resize(1);
  motion.forces = {{{}, {}, {-1, -1}}, {{}, {}, {0, -1}}};
  motion.couples = {{{}, {-1, -1}}};
  motion.axis = {"phi", "crank angle", "deg", {}};
  motion.numbers = {{"R_O", "force", "N", {}}};
  motion.plans = {{name, {{0, 1.0, "R_O", Plan::Tone::first}, {1, 1.0, "F", Plan::Tone::second}}}};
  for (int k = 0; k <= 90; ++k) {
    const double c = std::cos(k * degree), s = std::sin(k * degree);
    motion.links[0].poses.push_back({{0.0, 0.0}, k * degree});
    motion.forces[0].values.push_back({-500.0 * c, -500.0 * s});
    motion.forces[1].values.push_back({500.0 * c, 500.0 * s});
    motion.couples[0].values.push_back(45.5 - k);
    motion.axis.si.push_back(k * degree);
    motion.numbers[0].si.push_back(k == 90 ? std::numeric_limits<double>::quiet_NaN() : 500.0 + k / 3.0);
  }
  return {"turn", "A crank", std::move(motion)};
}

/// A column as the script reads it: integers, each the change from the one before.
std::vector<double> summed(const json::value& column) {
  std::vector<double> values;
  double sum = 0.0;
  for (const json::value& change : column.as_array()) values.push_back(sum += change.to_number<double>());
  return values;
}

}  // namespace

TEST_SUITE("draw") {
  TEST_CASE("the pictures of a motion are well formed and its parts are marked") {
    const MotionPictures pictures = motion_pictures(crank());
    CHECK(well_formed(pictures.scheme));
    CHECK(well_formed(pictures.plan));
    CHECK(count(pictures.scheme, "data-force=") == 2);
    CHECK(count(pictures.scheme, "data-name=") == 2);
    CHECK(count(pictures.scheme, "data-couple=") == 2);  // both senses
    CHECK(count(pictures.scheme, "visibility=\"hidden\"") == 1);
    CHECK(count(pictures.plan, "data-plan=") == 1);
    CHECK(count(pictures.plan, "data-side=") == 2);
    CHECK(has(pictures.scheme, "data-carried=\"0 0 "));
  }

  TEST_CASE("the data of a motion are the poses, forces and numbers of its frames, rounded below visibility") {
    const Figure figure = crank();
    const auto& motion = std::get<Motion>(figure.content);
    const json::value data = json::parse(motion_pictures(figure).data);
    const auto phi = summed(data.at("links").at(0).at(2));
    CHECK(summed(data.at("links").at(0).at(0)).size() == 1);  // never changes
    REQUIRE(phi.size() == 91);
    const auto& force = data.at("forces").at(1);
    const auto x = summed(force.at(1)), y = summed(force.at(2));
    for (std::size_t k = 0; k < 91; ++k) {
      CHECK(std::fabs(data.at("turn").as_double() * phi[k] - motion.links[0].poses[k].phi) <= 0.00026);
      CHECK(std::fabs(force.at(0).to_number<double>() * x[k] - motion.forces[1].values[k].x) <= 0.13);
      CHECK(std::fabs(force.at(0).to_number<double>() * y[k] - motion.forces[1].values[k].y) <= 0.13);
    }
    CHECK(data.at("couples").at(0).as_string() == std::string(46, '+') + std::string(45, '-'));
    const std::string numbers = data.at("numbers").at(0).as_string().c_str();
    CHECK(numbers.starts_with("500 500.33 500.67 501 "));
    CHECK(numbers.ends_with(" –"));
  }

  TEST_CASE("a picture of a motion contains every frame, and is still in a file of its own") {
    const Figure figure = crank();
    const auto& motion = std::get<Motion>(figure.content);
    const Fit placed = fit(motion);
    for (const Point p : {Point{0.1, 0.0}, Point{0.0, 0.1}}) {
      const Point tip = placed.at(p) + placed.newton * Point{5e3 * p.x, -5e3 * p.y};
      CHECK(Box{0.0, 0.0, view_width, placed.height}.contains(Box::around(tip, 20.0, 20.0)));
    }
    CHECK(count(svg(figure), "data-") == 0);
  }

  TEST_CASE("the data of a motion are small, and contain no names") {
    const MotionPictures pictures = motion_pictures(crank("</script><b>\"x\""));
    CHECK_FALSE(has(pictures.data, "script"));
    CHECK_FALSE(has(pictures.scheme, "</script>"));
    CHECK(pictures.data.size() < 3000);
  }
}
