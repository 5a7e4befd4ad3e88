#include "calculators/section/torsion/thin_walled.hpp"

#include "tests/calculators/section/sections.hpp"
#include "tests/found/modes.hpp"

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace loadpath;
using namespace loadpath::section;

namespace {

using Input = ThinWalled::Input;

ThinWalled::Cell cell(const char* name, double A) {
  ThinWalled::Cell c;
  c.name = name, c.A = A * mm2;
  return c;
}
ThinWalled::Wall wall(const char* cell, const char* beside, double l, double t, double G = 27.6) {
  ThinWalled::Wall w;
  w.cell = cell, w.beside = beside, w.l = l * mm, w.t = t * mm, w.G = G * GPa, w.tau_adm = 100.0 * MPa;
  return w;
}
Input section_of(double T) {
  Input in;
  in.T = T * N_m, in.G = 27.6 * GPa;
  return in;
}
double in_N_per_mm(Stiffness q) { return q / N_per_mm; }

}  // namespace

TEST_SUITE("thin-walled sections") {
  TEST_CASE("[Megson] example 22.2: a wing of three cells whose walls differ in G") {
    auto in = section_of(11300);
    in.cells = {cell("I", 258000), cell("II", 355000), cell("III", 161000)};
    in.walls = {wall("I", "", 1650, 1.22, 24.2),  wall("I", "II", 508, 2.03, 27.6), wall("II", "", 775, 1.22, 24.2),
                wall("II", "", 775, 1.22, 24.2),  wall("II", "III", 380, 1.63),     wall("III", "", 508, 0.92, 20.7),
                wall("III", "", 508, 0.92, 20.7), wall("III", "", 254, 0.92, 20.7)};
    const auto r = solve<ThinWalled>(in);
    CHECK(in_N_per_mm(r.cells[0].q) == doctest::Approx(7.1).epsilon(0.007));
    CHECK(in_N_per_mm(r.cells[1].q) == doctest::Approx(8.9).epsilon(0.006));
    CHECK(in_N_per_mm(r.cells[2].q) == doctest::Approx(4.2).epsilon(0.012));
    // by Gauss and Jordan elsewhere, all digits; the strips of the walls take 7e-6 of the torque
    CHECK(in_N_per_mm(r.cells[1].q) == doctest::Approx(8.882054440596075).epsilon(1e-5));
    CHECK(r.I_B / mm4 == doctest::Approx(556305561.2284629).epsilon(1e-12));
  }

  TEST_CASE("[Megson-P10.9]: cells between an upper and a lower skin") {
    auto in = section_of(56500);
    in.cells = {cell("I", 108400), cell("II", 202500), cell("III", 528000)};
    in.walls = {wall("I", "", 1084, 1.22),    wall("III", "", 2160, 1.625), wall("I", "III", 127, 0.915),
                wall("I", "III", 127, 0.915), wall("I", "II", 797, 0.915),  wall("II", "III", 797, 0.915)};
    const auto r = solve<ThinWalled>(in);
    CHECK(in_N_per_mm(r.walls[0].q) == doctest::Approx(25.4).epsilon(0.002));
    CHECK(in_N_per_mm(r.walls[1].q) == doctest::Approx(33.5).epsilon(0.0015));
    CHECK(-in_N_per_mm(r.walls[2].q) == doctest::Approx(8.1).epsilon(0.002));
    CHECK(-in_N_per_mm(r.walls[4].q) == doctest::Approx(13.4).epsilon(0.005));
  }

  TEST_CASE("[Megson] problem 3.5: strips of one thickness") {
    auto in = section_of(100);
    in.walls = {wall("", "", 200, 4), wall("", "", 100, 4), wall("", "", 100, 4)};
    const auto r = solve<ThinWalled>(in);
    CHECK(r.tau_max / MPa == doctest::Approx(3 * 100e3 / (400.0 * 16)).epsilon(1e-12));
    CHECK(in_si(r.theta) == doctest::Approx(3 * 100.0 / (27.6e9 * 0.4 * 64e-9)).epsilon(1e-12));
    CHECK(r.I_B / mm4 == 0.0);
    CHECK(r.r_I == 1.0);
  }

  TEST_CASE("[Sun] problem 3.5: J = 800 cm^4 of one cell, and a web adds little") {
    auto in = section_of(100);
    in.cells = {cell("1", 20000)};
    in.walls = {wall("1", "", 600, 3)};
    CHECK(solve<ThinWalled>(in).I_B / mm4 == doctest::Approx(800e4).epsilon(1e-12));
    in.cells = {cell("1", 5000), cell("2", 15000)};
    in.walls = {wall("1", "", 200, 3), wall("1", "2", 100, 3), wall("2", "", 400, 3)};
    CHECK(solve<ThinWalled>(in).I_B / mm4 == doctest::Approx(814.2857142857e4).epsilon(1e-12));
  }

  TEST_CASE("two equal cells: no shear flow in the web between them, which changes nothing") {
    auto in = section_of(1000);
    in.cells = {cell("a", 10000), cell("b", 10000)};
    in.walls = {wall("a", "", 300, 3), wall("a", "b", 100, 3), wall("b", "", 300, 3)};
    const auto two = solve<ThinWalled>(in);
    CHECK(std::abs(in_N_per_mm(two.walls[1].q)) < 1e-12);
    in.cells = {cell("a", 20000)};
    in.walls = {wall("a", "", 600, 3)};
    CHECK(rel(solve<ThinWalled>(in).I_B, two.I_B) < 1e-14);
  }

  TEST_CASE("a thin round tube: exact stiffness, and stress to the square of its thickness, on the safe side") {
    for (const double t : {1.0, 5.0, 10.0}) {  // mean radius 50 mm
      auto in = section_of(1000);
      in.cells = {cell("1", pi * 2500)};
      in.walls = {wall("1", "", pi * 100, t)};
      const auto r = solve<ThinWalled>(in);
      const double outer = 50 + t / 2, inner = 50 - t / 2;
      const double I_p = pi / 2 * (std::pow(outer, 4) - std::pow(inner, 4)), W_p = I_p / outer;
      CHECK(rel(r.I_t / mm4, I_p) < 0.1 * t * t / 2500);
      CHECK(r.W_t / mm3 < W_p);
      CHECK(r.W_t / mm3 > (1 - 0.6 * t / 50) * W_p);
    }
  }

  TEST_CASE("any section: the torque of its shear flows and strips is the torque, and all cells have the same twist") {
    std::mt19937 random(4);
    const auto draw = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    const char* const names[] = {"a", "b", "c", "d"};
    for (int round = 0; round < 50; ++round) {
      auto in = section_of(draw(-5000, 5000));
      for (const char* name : names) in.cells.push_back(cell(name, draw(5000, 20000)));
      for (int i = 0; i < 4; ++i) {
        in.walls.push_back(wall(names[i], i == 2 ? "b" : "", draw(300, 600), draw(2, 6), draw(20, 40)));
        in.walls.push_back(wall(names[i], names[(i + 1) % 4], draw(100, 300), draw(2, 6), draw(20, 40)));
      }
      in.walls.push_back(wall("", "", 80, 5));
      const auto r = solve<ThinWalled>(in);
      const double G_theta = in_si(r.theta) * 27.6e9;
      double T = G_theta * in_si(r.I_s);
      for (const auto& c : r.cells) T += 2 * in_si(c.A) * in_si(c.q);
      CHECK(T == doctest::Approx(in.T / N_m).epsilon(1e-12));
      for (int i = 0; i < 4; ++i) {
        double around = 0.0;
        for (std::size_t k = 0; k < in.walls.size(); ++k) {
          const auto& w = in.walls[k];
          const double sense = w.cell == Name(names[i]) ? 1.0 : w.beside == Name(names[i]) ? -1.0 : 0.0;
          around += sense * in_si(r.walls[k].q) * in_si(w.l) / in_si(w.t) / (in_si(w.G) / 27.6e9);
        }
        CHECK(around / (2 * in_si(in.cells[i].A)) == doctest::Approx(G_theta).epsilon(1e-11));
      }
      CHECK(in_si(r.W_t) * in_si(r.tau_max) == doctest::Approx(std::abs(in.T / N_m)).epsilon(1e-12));
    }
  }

  TEST_CASE("an error message for a section names the reason") {
    const auto fault = [](const std::string& lines) { return test::ExampleStep("section.thin_walled", lines).fault(); };
    const std::string one = "cells = [{ name = \"a\", A = \"10000 mm^2\" }]\nwalls = ";
    CHECK(fault(one + "[{ cell = \"a\", l = \"353 mm\", t = \"4 mm\" }]").find("enclose at most 9916") !=
          std::string::npos);
    CHECK(fault(one + "[{ cell = \"b\", l = \"500 mm\", t = \"4 mm\" }]").find("unknown cell 'b'") !=
          std::string::npos);
    CHECK(fault(one + "[{ l = \"500 mm\", t = \"4 mm\" }]").find("no wall to the outside") != std::string::npos);
    CHECK(fault(one + "[{ cell = \"a\", beside = \"a\", l = \"500 mm\", t = \"4 mm\" }]").find("on both sides") !=
          std::string::npos);
    CHECK(fault(one + "[{ cell = \"a\", t = \"4 mm\" }]").find("length of a wall") != std::string::npos);
    CHECK(fault("cells = [{ name = \"a\", A = \"1 cm^2\" }, { name = \"b\", A = \"1 cm^2\" }]\n"
                "walls = [{ cell = \"a\", beside = \"b\", l = \"50 mm\", t = \"4 mm\" }]")
              .find("no wall to the outside") != std::string::npos);
  }
}
