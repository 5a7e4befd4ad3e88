// Figures as calculators make them, for the tests of drawing.
#pragma once

#include "lib/draw/svg.hpp"
#include "lib/figure/figure.hpp"

#include <cmath>
#include <numbers>

namespace loadpath::draw::test {

inline constexpr double degree = std::numbers::pi / 180.0;

/// A driving moment over one turn with its peak of -86 N m at 202.7 degrees.
inline figure::Plot moment_plot() {
  figure::Plot plot;
  plot.x = {"phi", "crank angle", "deg"};
  plot.y = {"M", "driving moment", "N*m"};
  figure::Curve curve{"M", {}, {}};
  for (int i = 0; i < 360; ++i) {
    curve.x.push_back(i * degree);
    curve.y.push_back(-86.0 * std::exp(-std::pow((i - 202.7) / 38.0, 2)));
  }
  plot.curves = {curve};
  plot.marks = {{202.7 * degree, -86.0, "peak"}};
  return plot;
}

/// Two reactions that cross, with a bound above.
inline figure::Plot reaction_plot() {
  figure::Plot plot;
  plot.x = {"phi", "crank angle", "deg"};
  plot.y = {"R", "reaction", "N"};
  figure::Curve a{"R_12", {}, {}}, b{"R_23", {}, {}};
  for (int i = 0; i < 360; ++i) {
    const double phi = i * degree;
    a.x.push_back(phi), b.x.push_back(phi);
    a.y.push_back(900.0 + 500.0 * std::sin(phi)), b.y.push_back(1400.0 * std::fabs(std::cos(0.5 * phi + 0.3)));
  }
  plot.curves = {a, b};
  plot.bounds = {{1900.0, "R_adm"}};
  return plot;
}

/// The torque along a shaft with 900, -2700 and -1200 N m.
inline figure::Plot torque_plot() {
  figure::Plot plot;
  plot.x = {"x", "", "mm"};
  plot.y = {"T", "torque", "N*m"};
  plot.curves = {{"T", {0, 0.3, 0.3, 0.8, 0.8, 1.0}, {900, 900, -2700, -2700, -1200, -1200}, true}};
  return plot;
}

/// A slotted lever in one position: the crank rotates about O, its slider moves on the lever about B.
inline figure::Scheme lever() {
  const figure::Point O{0.09, 0.0}, B{0.0, 0.0}, A{0.105, -0.0259808};
  const double angle = std::atan2(A.y, A.x);
  const figure::Point C{0.04 * std::cos(angle), 0.04 * std::sin(angle)};
  figure::Scheme scheme;
  scheme.bodies = {{"1", {O, A}}, {"3", {B, C, A}}};
  scheme.joints = {{"O", O, figure::Scheme::Pin::revolute, true},
                   {"B", B, figure::Scheme::Pin::revolute, true},
                   {"", A, figure::Scheme::Pin::slider, false, angle},
                   {"A", A}};
  scheme.points = {{"C", C}};
  scheme.arrows = {{C, {0.0, -500.0}, "F"}, {O, {-200.0, 420.0}, "R_O", false}, {B, {150.0, 260.0}, "R_B", false}};
  scheme.moments = {{O, -27.35, "M"}};
  return scheme;
}

/// A crank with a group of six links, its reactions and couples.
inline figure::Scheme six_bar() {
  const figure::Point O{0, 0}, H{6, 0}, E{2, 6}, G{6, 6}, A{2, 3.464}, B{3.732, 4.464}, I{3.732, 1}, C{3.732, 8},
      D{0, 8}, F{8, 8};
  figure::Scheme scheme;
  scheme.bodies = {{"1", {O, A}},    {"2", {A, B}}, {"3", {I, B, C}}, {"4", {H, I}},
                   {"5", {D, C, F}}, {"6", {E, D}}, {"7", {G, F}}};
  const auto fixed = figure::Scheme::Pin::revolute;
  scheme.joints = {{"O", O, fixed, true},
                   {"H", H, fixed, true},
                   {"E", E, fixed, true},
                   {"G", G, fixed, true},
                   {"A", A},
                   {"B", B},
                   {"I", I},
                   {"C", C},
                   {"D", D},
                   {"F", F}};
  scheme.arrows = {{O, {-9.116, -5.263}, "R_01", false},
                   {H, {4.605, -2.03}, "R_04", false},
                   {E, {-3.891, 3.891}, "R_06", false},
                   {G, {8.403, 3.403}, "R_07", false}};
  scheme.moments = {{G, -10.0, "M"}, {O, 21.05, "Q"}};
  return scheme;
}

inline figure::Shaft stepped_shaft() {
  figure::Shaft shaft;
  shaft.parts = {{0.3, 0.05, 0.0}, {0.5, 0.07, 0.02}, {0.2, 0.055, 0.0}};
  shaft.torques = {{0.0, 900.0, "T_1"}, {0.3, -3600.0, "T_2"}, {0.8, 1500.0, "T_3"}, {1.0, 1200.0, "T_4"}};
  return shaft;
}

template <class Content>
std::string drawn(const Content& content) {
  return svg({"figure", "A figure", content});
}

}  // namespace loadpath::draw::test
