// Parts to scale with their dimensions, as on a workshop drawing: sections with cut walls, drives, teeth in mesh. All
// positions in metres. lib/draw/drawing finds the positions of dimension lines and names.
#pragma once

#include "lib/figure/figure.hpp"

#include <optional>

namespace loadpath::figure {

struct Drawing {
  /// The style of a line: outlines, thin edges and breaks, hidden edges, axes and pitch lines, and accented lines: a
  /// belt, a line of action, a path of contact.
  enum class Line { outline, thin, hidden, centre, belt, action, contact };
  /// The value of a dimension, a force or a pressure: "R = 600 mm". Without a symbol only the number.
  struct Value {
    std::string symbol;
    double si = 0.0;
    std::string unit;
  };
  struct Path {
    std::vector<Point> points;
    Line line = Line::outline;
    bool closed = false;
  };
  struct Circle {
    Point centre;
    double radius = 0.0;
    Line line = Line::outline;
    bool filled = false;  // a body: a pulley, a wheel
  };
  /// A closed outline: a cut face, hatched or, for a thin wall, filled; and, without a line, a body seen from the
  /// side, a liquid, the allowances of a wall.
  enum class Kind { cut, body, liquid, lost };
  struct Area {
    std::vector<Point> outline;
    Kind kind = Kind::body;
    std::string name = {};         // for screen readers
    std::vector<Point> hole = {};  // a closed outline within the other
  };
  /// A length between two points, with its line outside the drawing on one side, or in place, where it is measured
  /// along the two points themselves.
  enum class Side { below, above, left, right, in_place };
  struct Length {
    Point from, to;
    Value value;
    Side side = Side::below;
  };
  /// A radius, or a diameter through the centre: a line with heads at the circle.
  struct Radius {
    Point centre;
    double radius = 0.0;
    double angle = 0.0;  // direction of the line
    Value value;
    bool diameter = false;
  };
  /// An angle about a corner from `start` over `sweep`, counter-clockwise positive; at the radius of its arc, m.
  struct Angle {
    Point corner;
    double radius = 0.0;
    double start = 0.0, sweep = 0.0;
    Value value;
    bool legs = false;  // with thin lines from the corner to the arc
  };
  /// A force at a point; arrows of one view share one scale.
  struct Force {
    Point at;
    Point force;  // N
    Value value;
    bool load = true;      // load or reaction
    double offset = 0.0;   // offset of the arrow from its reference line, to its left
    bool towards = false;  // the arrow ends at the point
  };
  /// The symbol of a support: `into` points into the ground. A roller permits displacement across `into`, a sleeve
  /// along it; a plate permits displacement across but no rotation.
  struct Support {
    enum class Kind { hinge, clamp, roller, sleeve, plate };
    Point at, into;
    Kind kind = Kind::hinge;
  };
  /// A direction of rotation: an arc about its axis.
  struct Turn {
    Point centre;
    double radius = 0.0;
    bool counter_clockwise = true;
    double around = 1.5707963267948966;  // the direction of its middle
    std::optional<Value> value = {};
  };
  /// A pressure on a surface: arrows that end at it.
  struct Pressure {
    struct At {
      Point foot;       // on the surface
      Point direction;  // direction of the arrow
    };
    std::vector<At> arrows;
    Value value;
    Point label;  // approximate position of the label
  };
  struct Name {  // a point that is named, with a dot
    Point at;
    std::string words;
    std::optional<Value> value = {};
    bool dot = true;
  };
  /// The surface of a liquid.
  struct Surface {
    Point from, to;
  };
  struct View {
    View();
    View(const View&);
    View(View&&) noexcept;
    View& operator=(const View&);
    View& operator=(View&&) noexcept;
    ~View();

    std::string title;   // empty if it is the only one
    double share = 1.0;  // share of the page's width; views that fit are side by side
    double most_height = 330.0;
    bool is_scaled = true;  // otherwise its positions are proportions, without a scale bar
    double room = 26.0;     // margin around the parts, for names and arrows
    std::vector<Area> areas = {};
    std::vector<Path> paths = {};
    std::vector<Circle> circles = {};
    std::vector<Surface> surfaces = {};
    std::vector<Length> lengths = {};
    std::vector<Radius> radii = {};
    std::vector<Angle> angles = {};
    std::vector<Force> forces = {};
    std::vector<Support> supports = {};
    std::vector<Turn> turns = {};
    std::vector<Pressure> pressures = {};
    std::vector<Name> names = {};
    /// The visible part of a larger view: paths are clipped to it.
    struct Window {
      Point low, high;
    };
    std::optional<Window> window = {};
    std::string note = {};  // below it
  };
  std::vector<View> views;
};

}  // namespace loadpath::figure
