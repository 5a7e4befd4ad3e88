// Springs, dampers and welds of a mechanism's picture.
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/scheme/picture.hpp"

namespace loadpath::draw {
void SchemePicture::draw_springs() {
  for (std::size_t n = 0; n < scheme_.springs.size(); ++n) {
    const auto& s = scheme_.springs[n];
    const Point from = at(s.from), to = at(s.to);
    const bool moves = motion_ != nullptr;
    if (moves) canvas_.begin_group({{"data-between", text_of(motion_->springs[n], from, to)}});
    spring(canvas_, from, to, s.pulls, s.damps);
    if (moves) canvas_.end_group();
    labels_.keep_off({from, to}, (s.pulls && s.damps ? 2.5 : 1.0) * spring_half);
  }
  for (std::size_t n = 0; n < scheme_.coils.size(); ++n) {
    const auto& c = scheme_.coils[n];
    carried(carrier(&figure::Motion::coils, n), c.at, [&] { coil(canvas_, at(c.at), c.pulls); });
    labels_.keep_off(ring(at(c.at), coil_radius), 2.0);
  }
}

/// From a joint along its links to their other points, in view units; a link's first one is enough.
std::vector<Point> SchemePicture::directions_at(const figure::Scheme::Joint& joint) const {
  std::vector<Point> directions;
  for (const auto& body : scheme_.bodies) {
    const auto near = [&](Point p) { return length(at(p) - at(joint.at)) < 1.0; };
    if (!std::any_of(body.points.begin(), body.points.end(), near)) continue;
    const auto other = std::find_if_not(body.points.begin(), body.points.end(), near);
    if (other != body.points.end()) directions.push_back(unit(at(*other) - at(joint.at)));
  }
  return directions;
}

void SchemePicture::draw_weld(const figure::Scheme::Joint& joint) {
  const std::vector<Point> directions = directions_at(joint);
  const Point between{std::cos(joint.angle), -std::sin(joint.angle)};
  Point first = between, second = between;  // directions of the links joined here, those with the weld between them
  double most = -1.0;
  for (std::size_t a = 0; a < directions.size(); ++a) {
    for (std::size_t b = joint.fixed ? a : a + 1; b < (joint.fixed ? a + 1 : directions.size()); ++b) {
      const Point sum = directions[a] + directions[b];
      const double fit = length(sum) > 0.1 ? dot(unit(sum), between) : 0.0;
      if (fit > most) most = fit, first = directions[a], second = directions[b];
    }
  }
  if (joint.fixed) return clamp(canvas_, at(joint.at), first);
  if (std::fabs(cross(first, second)) > 0.1) return weld(canvas_, at(joint.at), first, second);
  const Point side = 6.0 * across(first);  // in one line: a seam across
  canvas_.line("rail", at(joint.at) + side, at(joint.at) - side);
}

void SchemePicture::label_springs() {
  for (std::size_t n = 0; n < scheme_.springs.size(); ++n) {
    const auto& s = scheme_.springs[n];
    const Text text = typeset(s.name);
    const auto places = along_segment(at(s.from), at(s.to), 3.0 + spring_half, width(text, text_size));
    const int by = motion_ == nullptr ? -1 : motion_->springs[n].from;
    const Box place = labels_.place(places);
    carried({by, -1}, fit_.back(place.centre()), [&] { canvas_.centred_text("quiet halo", place, text); });
  }
  for (std::size_t n = 0; n < scheme_.coils.size(); ++n) {
    const auto& c = scheme_.coils[n];
    const Text text = typeset(c.name);
    carried({carrier(&figure::Motion::coils, n).place, -1}, c.at,
            [&] { label("quiet halo", around(at(c.at), coil_radius + 2.0, width(text, text_size)), text); });
  }
}

}  // namespace loadpath::draw
