// Finds positions for labels: next to their objects, off lines and other labels.
#pragma once

#include "lib/draw/canvas/view.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace loadpath::draw {

/// A place for a label; of free places the one of lowest cost is taken.
struct Candidate {
  Box box;
  double cost = 0.0;
};

class Labels {
 public:
  explicit Labels(Box area) : area_(area) {}

  void keep_off(const Box& box) { boxes_.push_back(box); }
  /// `weight`: below 1 for lines that a label may cross if there is no room.
  void keep_off(std::vector<Point> polyline, double half_width = 1.0, double weight = 1.0) {
    lines_.emplace_back(std::move(polyline), half_width, weight);
  }

  /// The best candidate, which is then kept off by later labels; nothing when each one hits something.
  std::optional<Box> place_free(const std::vector<Candidate>& candidates);
  /// The candidate that hits least.
  Box place(const std::vector<Candidate>& candidates);

 private:
  class Line {
   public:
    Line(std::vector<Point> points, double half_width, double weight);
    [[nodiscard]] bool crosses(const Box& box) const;
    [[nodiscard]] double weight() const { return weight_; }

   private:
    std::vector<Point> points_;
    Box extent_;
    std::vector<Box> extents_;  // of one stretch after another
    double half_width_, weight_;
  };
  /// The cost of the candidate with all its collisions; summation stops at `enough`.
  [[nodiscard]] double cost(const Candidate& candidate, double enough) const;

  Box area_;
  std::vector<Box> boxes_;
  std::vector<Line> lines_;
};

/// Boxes of a text around a point, clear of a circle of `gap`, above and to the right first.
std::vector<Candidate> around(Point point, double gap, double width, double height = line_height);

/// The boxes of a text on the two sides of a line through `foot`, clear of it by `gap`.
std::array<Box, 2> both_sides(Point foot, Point direction, double gap, double width, double height = line_height);

/// Boxes of a text on both sides of a segment, near its middle first.
std::vector<Candidate> along_segment(Point from, Point to, double gap, double width, double height = line_height);

}  // namespace loadpath::draw
