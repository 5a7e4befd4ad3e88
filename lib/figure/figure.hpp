// Figures as data: content in SI numbers and words. No SVG, no colour, no number text: lib/draw/svg.cpp chooses
// ticks, colours and sizes. Types used in many sources define their special members in the source, since each would
// compile its own copies.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace loadpath::figure {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// A quantity axis: symbol ("phi", "M"), meaning, display unit ("deg", "N*m").
struct Scale {
  std::string symbol;
  std::string meaning;
  std::string unit;
  bool logarithmic = false;  // values that are not positive are not drawn
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
  Plot();
  Plot(Scale across, Scale up);
  Plot(const Plot&);
  Plot(Plot&&) noexcept;
  Plot& operator=(const Plot&);
  Plot& operator=(Plot&&) noexcept;
  ~Plot();

  Scale x;
  Scale y;
  std::vector<Curve> curves;
  std::vector<Mark> marks;
  std::vector<Bound> bounds;
};

/// A mechanism in one position, metres.
struct Scheme {
  Scheme();
  Scheme(const Scheme&);
  Scheme(Scheme&&) noexcept;
  Scheme& operator=(const Scheme&);
  Scheme& operator=(Scheme&&) noexcept;
  ~Scheme();

  struct Body {
    std::string name;
    std::vector<Point> points;  // joints and points of the link; drawn as a bar, or a plate from three points on
  };
  enum class Pin { revolute, slider, welded };
  struct Joint {
    std::string name;
    Point at;
    Pin pin = Pin::revolute;
    bool fixed = false;  // one of its links is the ground: hatched support
    double angle = 0.0;  // direction of a slider's guide; for a weld half-way between its two links
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
    std::vector<Point> positions = {};  // some of them, evenly spread over the cycle
  };
  struct Named {  // a point of a link other than a joint: where a force acts
    std::string name;
    Point at;
  };
  struct Wheel {  // the pitch circle of a gear, a pulley, a roller
    Point at;
    double radius = 0.0;  // negative for a ring gear
    double angle = 0.0;   // angle of a mark on it that makes its rotation visible
    bool fixed = false;
  };
  struct Belt {  // or chain: around two wheels
    Point from;
    Point to;
    double radius_from = 0.0;
    double radius_to = 0.0;
    bool crossed = false;
  };
  struct Outline {  // a closed curve on a link: the profile of a cam
    Point at;       // its axis
    std::vector<Point> points;
    bool fixed = false;
  };
  struct Rack {  // the pitch line of a rack, or a track that a wheel rolls on
    Point from;
    Point to;
    bool toothed = true;
    bool left = true;  // the wheel is on the left-hand side going from `from` to `to`
    bool fixed = false;
  };
  struct Spring {  // between two points, with its damper
    std::string name;
    Point from;
    Point to;
    bool pulls = true;   // there is a spring
    bool damps = false;  // there is a damper
  };
  struct Coil {  // a torsional spring, or damper, between two links
    std::string name;
    Point at;
    bool pulls = true;
    bool damps = false;
  };
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Guide> guides;
  std::vector<Arrow> arrows;
  std::vector<Moment> moments;
  std::vector<Path> paths;
  std::vector<Named> points;
  std::vector<Wheel> wheels = {};
  std::vector<Belt> belts = {};
  std::vector<Rack> racks = {};
  std::vector<Outline> outlines = {};
  std::vector<Spring> springs = {};
  std::vector<Coil> coils = {};
};

/// Vectors from a pole or head to tail: a plan of forces, velocities or accelerations, drawn to one scale.
struct Plan {
  enum class Tone { first, second, third, part };  // colour group; a part is drawn thin
  struct Vector {
    Point from;
    Point to;
    std::string label;
    Tone tone = Tone::first;
  };
  struct Image {  // a link as the plan shows it
    std::string name;
    std::vector<Point> points;
  };
  struct Named {
    std::string name;
    Point at;
  };
  struct Mark {  // a mark on a trace
    Point at;
    std::string label;  // a crank angle
    bool governing = false;
  };
  struct Trace {  // the path of the end of a vector that starts at the pole: a hodograph
    std::vector<Point> points;
    std::vector<Mark> marks;
  };
  std::string title;  // title of the panel; empty if it is the only one
  std::string unit;   // unit of the vectors: "N"
  std::vector<Vector> vectors;
  std::vector<Image> images = {};
  std::vector<Named> points = {};
  std::vector<Scheme::Arrow> forces = {};    // at points of the plan, to a scale of their own: Zhukovsky's lever
  std::vector<Scheme::Moment> moments = {};  // on links of the plan
  std::vector<Trace> traces = {};
};
struct Plans {
  std::vector<Plan> panels;
};

/// A moving scheme: one of its positions as it is printed, and the changes from frame to frame.
struct Motion {
  /// The links that carry and rotate a part of the scheme; -1: none.
  struct Carried {
    int place = -1;
    int turn = -1;
  };
  /// The links that carry the two ends of a spring; -1: the ground.
  struct Between {
    int from = -1;
    int to = -1;
  };
  struct Pose {
    Point at;
    double phi = 0.0;
  };
  struct Link {
    std::vector<Pose> poses;
  };
  struct Force {
    std::vector<Point> values;       // N
    std::vector<Point> places = {};  // points of action, unless carried by a link
    Carried carried = {};
  };
  struct Couple {
    std::vector<double> values;  // N m
    Carried carried = {};
  };
  /// The force plan of a link: sides head to tail, each a force or its opposite.
  struct Side {
    std::size_t force = 0;
    double sense = 1.0;
    std::string label;
    Plan::Tone tone = Plan::Tone::first;
  };
  struct LinkPlan {
    std::string link;
    std::vector<Side> sides;
  };
  /// A quantity that is shown as a number.
  struct Number {
    std::string symbol;
    std::string meaning;
    std::string unit;
    std::vector<double> si;
  };
  Scheme still;
  std::size_t shown = 0;                                                 // the frame of `still`
  std::vector<Link> links;                                               // link k carries body k
  std::vector<Carried> joints, guides, points, wheels, racks, outlines;  // the parts of `still`, in their order
  std::vector<Between> springs;                                          // likewise
  std::vector<Carried> coils;
  std::vector<Force> forces;    // first those of the arrows of `still`, in their order, then others of the plans
  std::vector<Couple> couples;  // values of the moments of `still`, in their order
  std::vector<LinkPlan> plans;
  std::size_t shown_plan = 0;
  Number axis;
  std::vector<Number> numbers;
};

/// A shaft seen from the side: cylinders and tapers in order along x, with torques and bearings at places; under it its
/// diagrams, each place below that of the shaft.
struct Shaft {
  struct Part {
    double length = 0.0;  // m
    double diameter = 0.0;
    double bore = 0.0;
    double right = 0.0;     // diameter at the right end, of a taper; 0: the same
    bool is_sized = false;  // found by a search: its diameter is marked
    [[nodiscard]] double right_diameter() const { return right > 0.0 ? right : diameter; }
  };
  /// What is mounted, from the side: a hub or a bearing.
  struct Outline {
    double x = 0.0;         // m, its middle
    double width = 0.0;     // 0: not known, and not drawn
    double diameter = 0.0;  // 0: not known
  };
  struct Torque {
    double x = 0.0;
    double value = 0.0;  // N m, signed; 0: a component that only bends the shaft
    std::string label;
    double force = 0.0;    // N, across the shaft; 0: none
    Point across = {};     // its components, N, seen from the right end
    double axial = 0.0;    // N, to the right
    Outline outline = {};  // the component
  };
  struct Bearing {
    double x = 0.0;
    bool fixed = false;  // it holds the shaft along its axis too
    std::string label;
    double force = 0.0;  // N, its radial reaction; 0: not known
    Point across = {};   // its components, N, as they act on the shaft
    double axial = 0.0;  // N, reaction on the shaft, to the right
    Outline outline = {};
    std::string type = {};  // "6308"
  };
  struct Place {  // a named section: the governing one
    double x = 0.0;
    std::string label;
  };
  std::vector<Part> parts;
  std::vector<Torque> torques;
  std::vector<Bearing> bearings = {};
  std::vector<Plot> diagrams = {};
  std::vector<Place> places = {};
  bool seen_from_end = false;  // with an end view, if forces act in two planes; it widens the picture
};

/// Many machines over two scales, see lib/figure/chart.hpp; too large to be copied with each figure.
struct Chart;
using Charted = std::shared_ptr<const Chart>;

/// Parts to scale with their dimensions, see lib/figure/drawing.hpp.
struct Drawing;
using Drawn = std::shared_ptr<const Drawing>;

struct Figure {
  Figure(std::string name, std::string words, Plot drawn);
  Figure(std::string name, std::string words, Scheme drawn);
  Figure(std::string name, std::string words, Shaft drawn);
  Figure(std::string name, std::string words, Plans drawn);
  Figure(std::string name, std::string words, Motion drawn);
  Figure(std::string name, std::string words, Charted drawn);
  Figure(std::string name, std::string words, Drawn drawn);
  Figure(const Figure&);
  Figure(Figure&&) noexcept;
  Figure& operator=(const Figure&);
  Figure& operator=(Figure&&) noexcept;
  ~Figure();

  std::string id;       // unique in a step, a file-name part: "torque-diagram"
  std::string caption;  // a message id, without numbers
  std::variant<Plot, Scheme, Shaft, Plans, Motion, Charted, Drawn> content;
};

}  // namespace loadpath::figure
