// The mechanisms of the worked examples of four texts on machine theory.
#pragma once

#include "tests/lib/mechanism/models.hpp"

#include <cmath>
#include <numbers>

namespace loadpath::mechanism::models {

inline constexpr double degree = std::numbers::pi / 180.0;

inline Pose between(Vec from, Vec to) { return {from.x, from.y, std::atan2(to.y - from.y, to.x - from.x)}; }
inline double distance(Vec a, Vec b) { return length(b - a); }

/// The point of the link whose frame is at `pose` where `global` is now.
inline Vec on(const Pose& pose, Vec global) { return turn(-pose.phi)(global - Vec{pose.x, pose.y}); }

inline int bar_between(Model& model, const char* name, Vec from, Vec to) {
  return add_link(model, name, between(from, to));
}

/// Joint of two links at a global point of the stated assembly.
inline void pin_at(Model& model, const char* name, int i, int j, Vec at) {
  const auto local = [&](int link) {
    return link == ground ? at : on(model.links[static_cast<std::size_t>(link)].pose, at);
  };
  pin(model, name, i, local(i), j, local(j));
}

inline void load_at(Model& model, const char* name, int link, Vec at, Vec force, double moment = 0.0) {
  load(model, name, link, on(model.links[static_cast<std::size_t>(link)].pose, at), force, moment);
}

/// Crank OA and the group of the links 2 to 7; a couple of -10 N m on link 7.
inline Model crank_with_six_link_group() {
  const Vec o{0.0, 0.0}, h{6.0, 0.0}, e{2.0, 6.0}, g{6.0, 6.0};
  const Vec a{4.0 * std::cos(60.0 * degree), 4.0 * std::sin(60.0 * degree)};
  const Vec b = a + Vec{2.0 * std::cos(30.0 * degree), 2.0 * std::sin(30.0 * degree)};
  const Vec i{b.x, 1.0}, c{b.x, 8.0}, d{0.0, 8.0}, f{8.0, 8.0};
  Model model;
  const int crank = bar_between(model, "1", o, a);
  const int second = bar_between(model, "2", a, b);
  const int third = bar_between(model, "3", i, c);
  const int fourth = bar_between(model, "4", h, i);
  const int fifth = bar_between(model, "5", d, f);
  const int sixth = bar_between(model, "6", e, d);
  const int seventh = bar_between(model, "7", g, f);
  pin_at(model, "O", crank, ground, o);
  pin_at(model, "A", second, crank, a);
  pin_at(model, "B", third, second, b);
  pin_at(model, "I", third, fourth, i);
  pin_at(model, "H", fourth, ground, h);
  pin_at(model, "C", fifth, third, c);
  pin_at(model, "D", fifth, sixth, d);
  pin_at(model, "E", sixth, ground, e);
  pin_at(model, "F", fifth, seventh, f);
  pin_at(model, "G", seventh, ground, g);
  drive_turning(model, "Q", crank);
  load(model, "M", seventh, {}, {}, -10.0);
  return model;
}

/// Cylinder 1 with rod 2 lifts the arm 3 about B; cylinder 4 with rod 5 turns the bucket 8 by the lever 6 and the
/// bar 7.
inline Model loader() {
  const double root3 = std::sqrt(3.0);
  const Vec o{0.0, 0.0}, a{0.8 * root3, 0.0}, b{0.8 * root3, 1.2}, g{2.0 * root3, 2.0}, h{2.0 * root3, 1.2};
  const Vec f{g.x - 1.6, 2.0};
  const Vec e = f + (0.8 / std::sin(60.0 * degree)) * Vec{0.5, -0.5 * root3};
  const Vec d = e + 0.4 * root3 * Vec{-0.5, 0.5 * root3};
  const Vec c{0.0, d.y - d.x / root3};
  const Vec m{2.8 * root3, 2.0};
  Model model;
  const int first = bar_between(model, "1", o, a);
  const int second = bar_between(model, "2", o, a);
  const int third = add_link(model, "3", {b.x, b.y, 0.0});
  const int fourth = bar_between(model, "4", c, d);
  const int fifth = bar_between(model, "5", c, d);
  const int sixth = bar_between(model, "6", e, d);
  const int seventh = bar_between(model, "7", f, g);
  const int eighth = bar_between(model, "8", h, g);
  pin_at(model, "O", first, ground, o);
  slide(model, "cylinder 1", second, {distance(o, a), 0.0}, first, {});
  pin_at(model, "A", third, second, a);
  pin_at(model, "B", third, ground, b);
  pin_at(model, "C", fourth, ground, c);
  slide(model, "cylinder 2", fifth, {distance(c, d), 0.0}, fourth, {});
  pin_at(model, "D", sixth, fifth, d);
  pin_at(model, "E", sixth, third, e);
  pin_at(model, "F", seventh, sixth, f);
  pin_at(model, "G", eighth, seventh, g);
  pin_at(model, "H", eighth, third, h);
  drive_sliding(model, "Q1", 1);
  drive_sliding(model, "Q2", 5);
  load_at(model, "P", eighth, m, {0.0, -20.0});
  return model;
}

/// Text C: two links, forces and couples on both.
inline Model group_with_three_turning_pairs() {
  Model model;
  const Vec a{0.1, 0.05}, b{0.42, 0.31}, c{0.8, -0.04};
  const int second = bar_between(model, "2", a, b);
  const int third = bar_between(model, "3", c, b);
  pin_at(model, "A", second, ground, a);
  pin_at(model, "B", second, third, b);
  pin_at(model, "C", third, ground, c);
  load_at(model, "F2", second, {0.25, 0.2}, {30.0, -120.0}, 4.0);
  load_at(model, "F3", third, {0.6, 0.16}, {-200.0, -55.0}, -7.5);
  return model;
}

/// Text C: link 2 and a slider 3 on a guide at 10 degrees.
inline Model group_with_outer_sliding_pair() {
  Model model;
  const Vec a{0.06, 0.08}, b{0.33, -0.02};
  const int second = bar_between(model, "2", a, b);
  const int third = add_link(model, "3", {b.x, b.y, 10.0 * degree});
  pin_at(model, "A", second, ground, a);
  pin_at(model, "B", second, third, b);
  slide(model, "guide", third, {}, ground, b, 10.0 * degree, 10.0 * degree);
  load_at(model, "F2", second, {0.17, 0.05}, {15.0, -40.0}, -1.2);
  load_at(model, "F3", third, {0.3508618237, 0.03444983298}, {-300.0, 20.0}, 2.0);
  return model;
}

/// Text C: link 2 slides on link 3, which turns about C.
inline Model group_with_inner_sliding_pair() {
  Model model;
  const Vec a{0.25, 0.18};
  const double guide = 0.5590546111;
  const int second = add_link(model, "2", {a.x, a.y, guide});
  const int third = add_link(model, "3", {0.0, 0.0, guide});
  pin_at(model, "A", second, ground, a);
  pin(model, "C", third, {}, ground, {});
  slide(model, "slide", second, {}, third, on(model.links[1].pose, a));
  load_at(model, "F2", second, {0.26, 0.195}, {25.0, -10.0}, 0.8);
  load_at(model, "F3", third, {0.1123385287, 0.04669105881}, {-60.0, 140.0}, 5.0);
  return model;
}

}  // namespace loadpath::mechanism::models
