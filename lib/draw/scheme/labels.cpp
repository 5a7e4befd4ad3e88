// The words of a mechanism's picture: names, forces, couples, scales.
#include "lib/draw/canvas/scale_bar.hpp"
#include "lib/draw/scheme/parts.hpp"
#include "lib/draw/scheme/picture.hpp"
#include "lib/quantity/format.hpp"
#include "lib/text/issue.hpp"

#include <set>

namespace loadpath::draw {

static std::string rounded(double v) { return format_number(std::round(100.0 * v) / 100.0); }

std::string SchemePicture::text_of(figure::Motion::Carried by, Point anchor) {
  return std::to_string(by.place) + " " + std::to_string(by.turn) + " " + rounded(anchor.x) + " " + rounded(anchor.y);
}

std::string SchemePicture::text_of(figure::Motion::Between by, Point from, Point to) {
  return text_of(figure::Motion::Carried{by.from, by.to}, from) + " " + rounded(to.x) + " " + rounded(to.y);
}

void SchemePicture::label_points() {
  std::set<std::string> done;
  const auto name = [&](const std::string& text, Point p, double gap, int by) {
    if (text.empty() || !done.insert(text).second) return;
    const Box place = labels_.place(around(at(p), gap, width(typeset(text), 1.1 * text_size)));
    // It goes round with its link, so that it stays off that.
    carried({by, -1}, fit_.back(place.centre()), [&] { canvas_.centred_text("halo", place, typeset(text)); });
  };
  for (std::size_t n = 0; n < scheme_.joints.size(); ++n)
    name(scheme_.joints[n].name, scheme_.joints[n].at, pin_radius + 2.5, carrier(&figure::Motion::joints, n).place);
  for (std::size_t n = 0; n < scheme_.points.size(); ++n)
    name(scheme_.points[n].name, scheme_.points[n].at, 5.0, carrier(&figure::Motion::points, n).place);
}

void SchemePicture::label_forces() {
  for (std::size_t n = 0; n < scheme_.arrows.size(); ++n) {
    const auto& a = scheme_.arrows[n];
    const Text text = typeset(a.label);
    const double wide = width(text, 1.1 * text_size);
    std::vector<Candidate> places = around(fit_.tip(a), 3.0, wide);
    for (Candidate& c : along_segment(at(a.at), fit_.tip(a), 4.0, wide)) places.push_back({c.box, 1.0 + c.cost});
    force_group("data-name", n, [&] { label(a.load ? "halo f1" : "halo f0", places, text); });
  }
}

void SchemePicture::label_moments() {
  for (std::size_t n = 0; n < scheme_.moments.size(); ++n) {
    const auto& moment = scheme_.moments[n];
    const std::string value = format_quantity(moment.value, "N*m", 4);
    const Text text = typeset(motion_ != nullptr ? moment.label  // its value changes and is below
                                                 : say("{1} = {2}", symbol(moment.label), value).text());
    const auto places = around(at(moment.at), couple_radius + 3.0, width(text, text_size));
    const int by = motion_ == nullptr ? -1 : motion_->couples[n].carried.place;
    carried({by, -1}, moment.at, [&] { label("halo f1", places, text); });
  }
}

void SchemePicture::label_bodies() {
  for (std::size_t k = 0; k < scheme_.bodies.size(); ++k) {
    const auto& body = scheme_.bodies[k];
    const std::vector<Point> points = outline(body);
    if (points.empty() || body.name.empty()) continue;
    const Text text = typeset(body.name);
    const double wide = width(text, text_size);
    std::vector<Candidate> places;
    if (points.size() > 2) {
      Point sum;
      for (const Point p : points) sum = sum + p;
      places = {{Box::around(1.0 / static_cast<double>(points.size()) * sum, wide, line_height), -5.0}};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto sides = along_segment(points[i], points[(i + 1) % points.size()], 5.0, wide);
      places.insert(places.end(), sides.begin(), sides.end());
    }
    if (points.size() < 3) {  // a short link in a crowd: farther off
      for (const double gap : {12.0, 26.0, 40.0}) {
        for (Candidate& c : around(0.5 * (points.front() + points.back()), gap, wide))
          places.push_back({c.box, 18.0 + gap + c.cost});
      }
    }
    const Box place = labels_.place(places);
    const Point centre = fit_.back(place.centre());
    carried({static_cast<int>(k), -1}, centre, [&] { canvas_.centred_text("quiet halo", place, text); });
  }
}

/// A bar of a round length with the value it represents; returns the start of the next one.
double SchemePicture::draw_scale(double x, double view_per_si, std::string (*written)(double)) {
  return scale_bar(canvas_, {x, fit_.height - 13.0}, view_per_si, written);
}

void SchemePicture::draw_scales() {
  double x = 10.0;
  if (!scheme_.bodies.empty() || !scheme_.joints.empty() || !scheme_.wheels.empty())
    x = draw_scale(x, fit_.scale, length_text);
  const bool has_forces = !scheme_.arrows.empty() && fit_.newton > 0.0;  // zero forces have no scale
  if (has_forces) draw_scale(x, fit_.newton, force_text);
}

std::string SchemePicture::description() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const auto& body : scheme_.bodies) add(say("link {1}", plain(body.name)).text());
  for (const auto& joint : scheme_.joints) {
    const bool slider = joint.pin == figure::Scheme::Pin::slider;
    const bool welded = joint.pin == figure::Scheme::Pin::welded;
    if (joint.name.empty()) continue;
    add(say(slider        ? "slider {1}"
            : welded      ? "weld {1}"
            : joint.fixed ? "fixed pin {1}"
                          : "pin {1}",
            plain(joint.name))
            .text());
  }
  for (const auto& s : scheme_.springs) add(say(s.pulls ? "spring {1}" : "damper {1}", plain(s.name)).text());
  for (const auto& c : scheme_.coils) add(say(c.pulls ? "spring {1}" : "damper {1}", plain(c.name)).text());
  for (const auto& a : scheme_.arrows) {
    add(say("force {1} = {2}", plain(a.label), force_text(length(a.force))).text());
  }
  for (const auto& m : scheme_.moments) {
    add(say("moment {1} = {2}", plain(m.label), format_quantity(m.value, "N*m", 4)).text());
  }
  return text;
}

}  // namespace loadpath::draw
