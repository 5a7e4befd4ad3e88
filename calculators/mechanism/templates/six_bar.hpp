// Common part of the six-bars: a four-bar with a pin D on one of its links, and a second dyad DE, FE behind it.
#pragma once

#include "calculators/mechanism/templates/four_bar_lengths.hpp"
#include "lib/calculator/fields.hpp"

namespace loadpath::planar::templates {

struct SixBar : FourBarLengths {
  Length g = unset<Length>;
  double gamma = 0.0;
  Length f = unset<Length>, h = unset<Length>, x_F = unset<Length>, y_F = unset<Length>;
  Assembly assembly_2 = Assembly::open;
  static constexpr auto fields = join(
      FourBarLengths::fields,
      Fields{Field{&SixBar::g, "g", mm, "distance of D from the first pin of its link"}.positive(),
             Field{&SixBar::gamma, "gamma", deg, "direction of D there, from the line to B, counter-clockwise"},
             Field{&SixBar::f, "f", mm, "length of the second coupler DE"}.positive(),
             Field{&SixBar::h, "h", mm, "length of the second rocker FE"}.positive(),
             Field{&SixBar::x_F, "x_F", mm, "fixed pin F"}, Field{&SixBar::y_F, "y_F", mm, "fixed pin F"},
             Choice{&SixBar::assembly_2, "assembly_2", "E is left of the line from D to F: open, or right: crossed"}
                 .may_be_missing()});

  /// D in the axes of its link, and on paper where that link runs from `first` to B.
  [[nodiscard]] Pin pin_D() const { return {"D", polar(g, gamma)}; }
  [[nodiscard]] Pin pin_D(const Pin& first, const Pin& B) const {
    return {"D", first.at + polar(g, gamma + direction(first.at, B.at))};
  }
  /// The second coupler and the second rocker; `carrier`: the link that D is on.
  void draw_dyad(Sketch& sketch, const Pin& D, const char* carrier) const {
    const Pin F{"F", cartesian(x_F, y_F)};
    const Pin E{"E", sketch.meet({"coupler_2", D.at, f}, PlacedLink{"rocker_2", F.at, h}, assembly_2)};
    sketch.fixed(F);
    sketch.bar("coupler_2", D, E, f);
    sketch.bar("rocker_2", F, E, h);
    sketch.revolute("D", carrier, "coupler_2");
    sketch.revolute("E", "coupler_2", "rocker_2");
    sketch.revolute("F", "ground", "rocker_2");
  }
};

}  // namespace loadpath::planar::templates
