// A mechanism drawn in one position: common part of lib/draw/scheme*.cpp.
#pragma once

#include "lib/draw/canvas/canvas.hpp"
#include "lib/draw/canvas/labels.hpp"
#include "lib/draw/canvas/picture.hpp"
#include "lib/draw/scheme/fit.hpp"

namespace loadpath::draw {

class SchemePicture {
 public:
  /// `motion`: null, or the motion of the scheme; its parts are then in groups named after their carriers.
  SchemePicture(figure::Scheme scheme, const Fit& fit, const figure::Motion* motion = nullptr)
      : scheme_(std::move(scheme)),
        fit_(fit),
        motion_(motion),
        labels_({2.0, 2.0, view_width - 2.0, fit_.height - 30.0}) {}
  Picture drawn();

 private:
  void draw_guides();
  void draw_paths();
  void draw_bodies();
  void draw_supports();
  void draw_block(const figure::Scheme::Joint& joint);
  void draw_pins();
  void draw_forces();
  void draw_couples();
  void draw_belts();
  void draw_racks();
  void draw_outlines();
  void draw_wheels();
  void draw_wheel(const figure::Scheme::Wheel& wheel);
  void draw_springs();
  void draw_weld(const figure::Scheme::Joint& joint);
  void label_points();
  void label_forces();
  void label_moments();
  void label_bodies();
  void label_springs();
  void draw_scales();

  [[nodiscard]] Point at(Point p) const { return fit_.at(p); }
  [[nodiscard]] std::vector<Point> outline(const figure::Scheme::Body& body) const;
  [[nodiscard]] Point couple_opening(Point p) const;
  [[nodiscard]] std::vector<Point> directions_at(const figure::Scheme::Joint& joint) const;
  [[nodiscard]] Point support_direction(const figure::Scheme::Joint& joint) const;
  [[nodiscard]] bool lies_on(Point p, const figure::Scheme::Guide& guide) const;
  [[nodiscard]] bool carries_block(const figure::Scheme::Guide& guide) const;
  void label(std::string_view style, const std::vector<Candidate>& places, const Text& text) {
    canvas_.centred_text(style, labels_.place(places), text);
  }
  double draw_scale(double x, double view_per_si, std::string (*written)(double));
  [[nodiscard]] std::string description() const;

  using Carriers = std::vector<figure::Motion::Carried> figure::Motion::*;
  [[nodiscard]] figure::Motion::Carried carrier(Carriers of, std::size_t index) const {
    return motion_ == nullptr ? figure::Motion::Carried{} : (motion_->*of)[index];
  }
  /// A part carried by links: it moves with its anchor and rotates about it.
  template <class Draw>
  void carried(figure::Motion::Carried by, Point anchor, const Draw& draw) {
    const bool moves = motion_ != nullptr && (by.place >= 0 || by.turn >= 0);
    if (moves) canvas_.begin_group({{"data-carried", text_of(by, at(anchor))}});
    draw();
    if (moves) canvas_.end_group();
  }
  template <class Draw>
  void force_group(const char* kind, std::size_t index, const Draw& draw) {
    if (motion_ == nullptr) return draw();
    const figure::Motion::Carried by = motion_->forces[index].carried;
    canvas_.begin_group({{kind, std::to_string(index)}, {"data-at", text_of(by, at(scheme_.arrows[index].at))}});
    draw();
    canvas_.end_group();
  }
  static std::string text_of(figure::Motion::Carried by, Point anchor);
  static std::string text_of(figure::Motion::Between by, Point from, Point to);

  figure::Scheme scheme_;
  Fit fit_;
  const figure::Motion* motion_;
  Labels labels_;
  Canvas canvas_;
};

}  // namespace loadpath::draw
