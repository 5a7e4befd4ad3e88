// A view of a drawing: its parts, its dimensions, its words.
#pragma once

#include "lib/draw/canvas/labels.hpp"
#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/drawing/fit.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loadpath::draw {

class ViewPicture {
 public:
  ViewPicture(const figure::Drawing::View& view, const ViewFit& fit, Canvas& canvas)
      : view_(view), fit_(fit), canvas_(canvas), labels_(fit.words) {}
  void drawn();

 private:
  void draw_areas();
  [[nodiscard]] bool is_outline_of(const figure::Drawing::Path& path, const figure::Drawing::Area& area) const;
  [[nodiscard]] bool is_outlined(const figure::Drawing::Area& area) const;
  void draw_cut(const std::vector<Point>& face, const std::vector<Point>& outline, const std::vector<Point>& hole);
  void draw_circles();
  void draw_paths();
  void draw_surfaces();
  void draw_frame();
  void draw_support(const figure::Drawing::Support& support);
  void stroke(figure::Drawing::Line line, const std::vector<Point>& page);

  void draw_lengths();
  void draw_row(const Row& row);
  void draw_level(const Row& row, Point from, Point to, double y, bool above);
  void draw_upright(const Row& row, Point from, Point to, double x, bool left);
  void draw_in_place(const figure::Drawing::Length& length);
  void draw_radius(const figure::Drawing::Radius& radius);
  void draw_angle(const figure::Drawing::Angle& angle);
  [[nodiscard]] std::pair<Point, Point> placed(const figure::Drawing::Force& force) const;
  void draw_forces();
  void name_forces();
  void draw_turn(const figure::Drawing::Turn& turn);
  void name_turns();
  void draw_pressure(const figure::Drawing::Pressure& pressure);
  void draw_names();
  void draw_words();

  /// A line with heads at its ends, from the inside or, where it is short, from the outside.
  void headed(Point from, Point to);
  void fixed_text(Point centre, const Text& text, bool turned = false);
  void free_text(std::string_view style, const std::vector<Candidate>& places, const Text& text);
  [[nodiscard]] Point at(Point p) const { return fit_.at(p); }
  [[nodiscard]] std::vector<Point> at(const std::vector<Point>& points) const;
  [[nodiscard]] bool is_in_window(Point page) const;

  const figure::Drawing::View& view_;
  const ViewFit& fit_;
  Canvas& canvas_;
  Labels labels_;
  struct Fixed {
    Point centre;
    Text text;
    bool turned;
  };
  std::vector<Fixed> fixed_texts_;
};

/// A description of a view for screen readers.
std::string description(const figure::Drawing::View& view);

}  // namespace loadpath::draw
