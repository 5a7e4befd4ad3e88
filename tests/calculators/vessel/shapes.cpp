#include "calculators/vessel/cone.hpp"
#include "calculators/vessel/ellipsoid.hpp"
#include "calculators/vessel/sphere.hpp"
#include "calculators/vessel/torus.hpp"
#include "tests/calculators/vessel/vessel_tests.hpp"

#include <doctest/doctest.h>

namespace {

using namespace loadpath;
using namespace loadpath::tests;
using vessel::Hypothesis;

template <class Input>
Input steel(double p_MPa, double delta_mm) {
  Input in;
  in.p = p_MPa * MPa;
  in.delta = delta_mm * mm;
  in.sigma_adm = 140.0 * MPa;
  return in;
}

constexpr double g = 9.80665;

}  // namespace

TEST_SUITE("vessel.sphere") {
  vessel::Sphere::Input sphere() {
    auto in = steel<vessel::Sphere::Input>(1.6, 8);
    in.R = 600.0 * mm;
    return in;
  }

  TEST_CASE("the sphere of the textbook: 60 MPa in all directions, half of the cylinder's thickness") {
    auto in = sphere();
    const auto r = solve<vessel::Sphere>(in);
    CHECK(rel(in_si(r.sigma_o), 60e6) < 1e-12);
    CHECK(rel(in_si(r.sigma_M), 60e6) < 1e-12);
    in.hypothesis = Hypothesis::membrane;
    CHECK(rel(in_si(solve<vessel::Sphere>(in).delta_min), 0.8 * 0.6 / 140) < 1e-12);
  }

  TEST_CASE("Tresca and von Mises agree, in the thin and in the thick wall") {
    auto in = sphere();
    in.delta = 60.0 * mm;
    const auto tresca = solve<vessel::Sphere>(in);
    in.hypothesis = Hypothesis::mises;
    const auto mises = solve<vessel::Sphere>(in);
    CHECK(rel(mises.u_v, tresca.u_v) < 1e-12);
    CHECK(rel(in_si(mises.sigma_L), in_si(tresca.sigma_L)) < 1e-12);
    const double R_i = 0.57, R_a = 0.63, b3 = R_a * R_a * R_a;
    CHECK(rel(in_si(tresca.sigma_L), 1.5e6 * 1.6 * b3 / (b3 - R_i * R_i * R_i)) < 1e-12);
  }

  TEST_CASE("a sphere full of liquid on its equator: the stresses of Timoshenko at the bottom and next to the ring") {
    auto in = sphere();
    in.p = 0.0 * MPa;
    in.rho = 1000.0 * vessel::kg_per_m3, in.h_l = 1200.0 * mm;
    in.hypothesis = Hypothesis::membrane;
    const double unit = 1000 * g * 0.6 * 0.6 / 0.008;
    CHECK(rel(in_si(solve<vessel::Sphere>(in).sigma_o), unit) < 1e-9);  // the pole
    CHECK(rel(solve<vessel::Sphere>(in).phi, pi) < 1e-9);
  }

  TEST_CASE("above and below the ring the meridional force differs by the weight of the liquid") {
    auto in = sphere();
    in.p = 0.0 * MPa;
    in.rho = 1000.0 * vessel::kg_per_m3, in.h_l = 1200.0 * mm;
    for (const double phi_deg : {60.0, 90.0, 120.0}) {
      in.phi_s = phi_deg * pi / 180;
      const auto along = vessel::Sphere::figures(in, solve<vessel::Sphere>(in)).back();
      const auto& curve = std::get<figure::Plot>(along.content).curves[1];  // the meridional stress
      double above = 0.0, below = 0.0;
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double phi = (static_cast<double>(i) + 0.5) / static_cast<double>(curve.x.size()) * pi;
        if (phi < in.phi_s) above = curve.y[i];
        if (phi > in.phi_s && below == 0.0) below = curve.y[i];
      }
      const double s = std::sin(in.phi_s), weight = 4.0 / 3 * pi * 0.6 * 0.6 * 0.6 * 1000 * g;
      CHECK(std::abs((below - above) * 0.008 * 2 * pi * 0.6 * s * s - weight) < 0.03 * weight);
    }
  }

  TEST_CASE("a liquid of zero height changes nothing") {
    auto in = sphere();
    const auto dry = solve<vessel::Sphere>(in);
    in.rho = 1000.0 * vessel::kg_per_m3, in.h_l = 0.0 * mm;
    CHECK(rel(solve<vessel::Sphere>(in).u_v, dry.u_v) < 1e-9);
  }

  TEST_CASE("wrong input is reported") {
    const std::string step = "calculator = \"vessel.sphere\"\nR = \"600 mm\"\nsigma_adm = \"140 MPa\"\np = \"1 MPa\"\n";
    CHECK(says(step + "rho = \"1000 kg/m^3\"\nh_l = \"1300 mm\"\n", "above the top of the sphere"));
    CHECK(says(step + "phi_s = \"5 deg\"\n", "must be"));
  }
}

TEST_SUITE("vessel.cone") {
  vessel::Cone::Input cone() {
    auto in = steel<vessel::Cone::Input>(0.5, 6);
    in.R = 800.0 * mm;
    in.alpha = pi / 6;
    return in;
  }

  TEST_CASE("gas: p r / (delta cos alpha) circumferentially, half of it meridionally, at the large end") {
    const auto r = solve<vessel::Cone>(cone());
    CHECK(rel(in_si(r.sigma_o), 0.5e6 * 0.8 / (0.006 * std::cos(pi / 6))) < 1e-12);
    CHECK(rel(in_si(r.sigma_M), 0.25e6 * 0.8 / (0.006 * std::cos(pi / 6))) < 1e-12);
    CHECK(rel(in_si(r.r), 0.8) < 1e-12);
  }

  TEST_CASE("a full hanging cone: largest hoop stress half-way up, largest meridional stress at three quarters") {
    auto in = cone();
    in.p = 0.0 * MPa;
    const double h = 0.8 / std::tan(pi / 6);
    in.rho = 1000.0 * vessel::kg_per_m3, in.h_l = h * (1 - 1e-12) * m;
    in.hypothesis = Hypothesis::membrane;
    const double unit = 1000 * g * h * h * std::tan(pi / 6) / (0.006 * std::cos(pi / 6));
    CHECK(rel(in_si(solve<vessel::Cone>(in).sigma_o), unit / 4) < 1e-6);
    CHECK(rel(in_si(solve<vessel::Cone>(in).r), 0.4) < 1e-9);
    in.z_c = 0.5, in.z_l = 1.0;  // now the meridional stress governs
    CHECK(rel(in_si(solve<vessel::Cone>(in).sigma_M), 3.0 / 16 * unit) < 1e-6);
    CHECK(rel(in_si(solve<vessel::Cone>(in).r), 0.6) < 1e-9);
  }

  TEST_CASE("a cone that becomes a cylinder has its stresses") {
    auto in = cone();
    in.alpha = pi / 180;
    CHECK(rel(in_si(solve<vessel::Cone>(in).sigma_o), 0.5e6 * 0.8 / 0.006) < 2e-4);
  }

  TEST_CASE("wrong input is reported") {
    const std::string step = "calculator = \"vessel.cone\"\nR = \"800 mm\"\nsigma_adm = \"140 MPa\"\np = \"1 MPa\"\n";
    CHECK(says(step + "alpha = \"90 deg\"\n", "must be"));
    CHECK(says(step + "alpha = \"45 deg\"\nrho = \"1000 kg/m^3\"\nh_l = \"900 mm\"\n", "above the large end"));
  }
}

TEST_SUITE("vessel.torus") {
  vessel::Torus::Input torus() {
    auto in = steel<vessel::Torus::Input>(2.0, 5);
    in.R_0 = 1000.0 * mm;
    in.r = 200.0 * mm;
    return in;
  }

  TEST_CASE("p r / 2 delta along the torus; around the tube the largest stress at the inside") {
    const auto r = solve<vessel::Torus>(torus());
    CHECK(rel(in_si(r.sigma_o), 2e6 * 0.2 / 0.01) < 1e-12);
    CHECK(rel(in_si(r.sigma_M), 2e6 * 0.2 / 0.01 * (2 - 0.2) / (1 - 0.2)) < 1e-12);
  }

  TEST_CASE("a torus that becomes straight is a cylinder") {
    auto in = torus();
    in.R_0 = 1e6 * m;
    const auto r = solve<vessel::Torus>(in);
    CHECK(rel(in_si(r.sigma_M), 2e6 * 0.2 / 0.005) < 1e-6);
    CHECK(rel(in_si(r.sigma_o), 2e6 * 0.2 / 0.01) < 1e-6);
  }

  TEST_CASE("wrong input is reported") {
    const std::string step = "calculator = \"vessel.torus\"\nsigma_adm = \"140 MPa\"\np = \"1 MPa\"\n";
    CHECK(says(step + "R_0 = \"200 mm\"\nr = \"200 mm\"\n", "R_0 must be larger than r"));
    CHECK(says(step + "R_0 = \"210 mm\"\nr = \"200 mm\"\ndelta = \"12 mm\"\n",
               "R_0 must be larger: the wall closes the ring"));
  }
}

TEST_SUITE("vessel.ellipsoid") {
  vessel::Ellipsoid::Input head(double a_over_b) {
    auto in = steel<vessel::Ellipsoid::Input>(1.0, 10);
    in.a = 1000.0 * mm;
    in.b = 1000.0 / a_over_b * mm;
    return in;
  }

  TEST_CASE("pole and equator have their known stresses; beyond a/b = root of 2 the equator is compressed") {
    for (const double q : {0.7, 1.0, 1.3, 1.5, 2.0}) {
      const auto r = solve<vessel::Ellipsoid>(head(q));
      CHECK(rel(in_si(r.sigma_pole), 1e6 * q / 0.02) < 1e-12);
      CHECK(std::abs(in_si(r.sigma_eq) - 1e8 * (1 - q * q / 2)) < 1.0);
      CHECK((r.sigma_eq < 0.0 * MPa) == (q > std::sqrt(2.0)));
    }
  }

  TEST_CASE("the knuckle in compression governs a flat head by Tresca") {
    const auto r = solve<vessel::Ellipsoid>(head(2));
    CHECK(rel(in_si(r.sigma_v), 150e6) < 1e-12);  // from -100 to 50 MPa
    CHECK(rel(in_si(r.r), 1.0) < 1e-12);
  }

  TEST_CASE("an ellipsoid of equal axes is a sphere") {
    vessel::Sphere::Input ball = steel<vessel::Sphere::Input>(1.0, 10);
    ball.R = 1000.0 * mm;
    CHECK(rel(solve<vessel::Ellipsoid>(head(1)).u_v, solve<vessel::Sphere>(ball).u_v) < 1e-12);
  }

  TEST_CASE("thin flat heads may buckle: the limit on both sides of 0.002 of the crown radius") {
    auto in = head(2);  // crown radius 2 m
    in.delta = 4.01 * mm;
    CHECK(solve<vessel::Ellipsoid>(in).w_b < 1.0);
    in.delta = 3.99 * mm;
    CHECK(solve<vessel::Ellipsoid>(in).w_b > 1.0);
    in = head(1.4);
    in.delta = 1.0 * mm;
    CHECK(solve<vessel::Ellipsoid>(in).w_b == 0.0);
  }

  TEST_CASE("wrong input is reported") {
    const std::string step = "calculator = \"vessel.ellipsoid\"\nsigma_adm = \"140 MPa\"\np = \"1 MPa\"\n";
    CHECK(says(step + "a = \"1 m\"\nb = \"0.1 m\"\n", "1/5 to 5"));
  }
}
