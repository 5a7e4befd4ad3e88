// A flat end in section: its thickness with the corrosion allowance, the diameter that the pressure acts on.
#include "calculators/vessel/ends/flat.hpp"
#include "lib/figure/drawing.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace loadpath::vessel {

namespace {

using figure::Drawing;
using figure::Point;

std::vector<Point> plate(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// The shell on the right of the axis, of a bolted cover with its flange; its thickness is not an input.
std::vector<Point> shell_of(FlatEnd::Attachment attachment, double inside, double outside, double wall, double low,
                            double thickness) {
  if (attachment != FlatEnd::Attachment::bolted) return plate(inside, outside, low, 0.0);
  const double under = -0.8 * thickness;
  return {{inside, low}, {inside + wall, low}, {inside + wall, under}, {outside, under}, {outside, 0.0}, {inside, 0.0}};
}

void add_shell(const FlatEnd::Input& in, double outside, double low, double delta, Drawing::View& view) {
  const double inside = 0.5 * in_si(in.D_i), wall = std::min(0.5 * delta, 0.1 * inside);
  std::vector<Point> shell = shell_of(in.attachment, inside, outside, wall, low, delta);
  view.areas.push_back({shell, Drawing::Kind::cut, say("shell").text()});
  for (Point& p : shell) p.x = -p.x;
  view.areas.push_back({std::move(shell), Drawing::Kind::cut});
}

void add_pressure(const FlatEnd::Input& in, double low, Drawing::View& view) {
  constexpr int arrows = 7;
  const double D = in_si(in.D_i);
  Drawing::Pressure pressure{{}, {"p", in_si(in.p), "MPa"}, {0.25 * D, 0.6 * low}};
  for (int k = 0; k < arrows; ++k) pressure.arrows.push_back({{D * ((k + 0.5) / arrows - 0.5), 0.0}, {0.0, 1.0}});
  view.pressures.push_back(std::move(pressure));
}

void add_lengths(const FlatEnd::Input& in, const FlatEnd::Result& r, double outside, double low, Drawing::View& view) {
  const double D = in_si(in.D_i), delta = in_si(r.delta), e = in_si(r.e), c = in_si(in.c);
  view.lengths.push_back({{-0.5 * D, low}, {0.5 * D, low}, {"D_i", D, "mm"}, Drawing::Side::below});
  view.lengths.push_back({{outside, 0.0}, {outside, delta}, {"delta", delta, "mm"}, Drawing::Side::right});
  if (e < delta * (1.0 - 1e-9))
    view.lengths.push_back({{-outside, c}, {-outside, c + e}, {"e", e, "mm"}, Drawing::Side::left});
}

}  // namespace

std::vector<figure::Figure> FlatEnd::figures(const Input& in, const Result& r) {
  if (!is_set(r.u_e) || !is_set(r.delta) || !is_set(r.e)) return {};
  const double half = 0.5 * in_si(in.D_i), delta = in_si(r.delta), c = in_si(in.c);
  const double outside = in.attachment == Attachment::bolted ? 1.2 * half : half + std::min(0.5 * delta, 0.1 * half);
  const double low = -std::max(0.4 * half, 1.5 * delta);
  Drawing::View view;
  view.areas.push_back({plate(-outside, outside, 0.0, delta), Drawing::Kind::cut, say("flat end").text()});
  if (c > 0.0)
    view.areas.push_back({plate(-half, half, 0.0, c), Drawing::Kind::lost, say("corrosion allowance").text()});
  add_shell(in, outside, low, delta, view);
  view.paths.push_back({{{0.0, 1.1 * low}, {0.0, delta - 0.1 * low}}, Drawing::Line::centre});
  add_pressure(in, low, view);
  add_lengths(in, r, outside, low, view);
  view.note = say("end to scale; the shell is a sketch").text();
  auto drawing = std::make_shared<Drawing>();
  drawing->views = {std::move(view)};
  return {{"section", "Section of the flat end through its axis", figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::vessel
