// Figures as data: what is to be seen, in SI numbers and words. No SVG, no colour, no number text: lib/draw/svg.cpp
// chooses ticks, colours and sizes.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace loadpath::draw {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// A quantity axis: symbol ("phi", "M"), meaning, display unit ("deg", "N*m").
struct Scale {
  std::string symbol;
  std::string meaning;
  std::string unit;
};

struct Curve {
  std::string label;      // a symbol ("M", "R_12") or words
  std::vector<double> x;  // SI
  std::vector<double> y;  // SI; NaN breaks the curve
  bool filled = false;    // area to the zero line: diagrams along a shaft
};

/// A point that is named: the peak, the design point.
struct Mark {
  double x = 0.0;
  double y = 0.0;
  std::string label;  // words without numbers: "peak"
};

/// A horizontal line that a curve is compared with: an allowable value.
struct Bound {
  double y = 0.0;
  std::string label;
};

struct Plot {
  Scale x;
  Scale y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
  std::vector<Bound> bounds;
};

/// A mechanism in one position, metres.
struct Scheme {
  struct Body {
    std::string name;
    std::vector<Point> points;  // joints and points of the link; drawn as a bar, or a plate from three points on
  };
  enum class Pin { revolute, slider };
  struct Joint {
    std::string name;
    Point at;
    Pin pin = Pin::revolute;
    bool fixed = false;  // one of its links is the ground: hatched support
    double angle = 0.0;  // of the guide, slider only
  };
  struct Guide {  // the line that a slider or a pin in a slot runs on
    Point from;
    Point to;
    bool fixed = false;  // belongs to the ground
  };
  struct Arrow {  // a force at a point, N; arrows of one scheme share one scale
    Point at;
    Point force;
    std::string label;
    bool load = true;  // load or reaction
  };
  struct Moment {  // a couple at a point, N m, counter-clockwise positive
    Point at;
    double value = 0.0;
    std::string label;
  };
  struct Path {  // the path of a point over the cycle
    std::string name;
    std::vector<Point> points;
  };
  struct Named {  // a point of a link that is no joint: where a force acts
    std::string name;
    Point at;
  };
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Guide> guides;
  std::vector<Arrow> arrows;
  std::vector<Moment> moments;
  std::vector<Path> paths;
  std::vector<Named> points;
};

/// A shaft seen from the side: cylinders in order along x, with torques and forces at places.
struct Shaft {
  struct Part {
    double length = 0.0;  // m
    double diameter = 0.0;
    double bore = 0.0;
  };
  struct Torque {
    double x = 0.0;
    double value = 0.0;  // N m, signed
    std::string label;
  };
  std::vector<Part> parts;
  std::vector<Torque> torques;
};

struct Figure {
  std::string id;       // unique in a step, a file-name part: "torque-diagram"
  std::string caption;  // a message id, without numbers
  std::variant<Plot, Scheme, Shaft> content;
};

/// The figure as one <svg> element: no script, no external reference, colours by CSS variables with fallbacks,
/// <title> and <desc>, all text escaped. Deterministic to the byte.
std::string svg(const Figure& figure);

}  // namespace loadpath::draw
