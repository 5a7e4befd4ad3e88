// The shaft from the side, with bearings and mounted components, its diagrams below it, and the governing sections;
// over a revolution the internal forces of the weakest.
#include "calculators/shaft/design/design.hpp"
#include "calculators/shaft/design/model/positions.hpp"
#include "calculators/shaft/design/model/turn.hpp"
#include "calculators/shaft/design/whirl.hpp"
#include "lib/numerics/magnitude.hpp"
#include "lib/text/issue.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::shaft {

namespace {

figure::Curve along(const Loaded& loaded, const char* label,
                    double (*of)(const Loaded&, std::size_t span, bool right)) {
  figure::Curve curve{label, {}, {}, true};
  for (std::size_t s = 0; s + 1 < loaded.stations.x.size(); ++s) {
    curve.x.insert(curve.x.end(), {loaded.stations.x[s], loaded.stations.x[s + 1]});
    curve.y.insert(curve.y.end(), {of(loaded, s, false), of(loaded, s, true)});
  }
  return curve;
}

figure::Plot diagram(figure::Scale up, std::vector<figure::Curve> curves) {
  figure::Plot plot;
  plot.x = {"z", "position along the shaft", "mm"};
  plot.y = std::move(up);
  plot.curves = std::move(curves);
  return plot;
}

/// Where the curves of a diagram are farthest from zero.
void mark_peaks(figure::Plot& plot) {
  for (const figure::Curve& curve : plot.curves) {
    const auto most = std::max_element(curve.y.begin(), curve.y.end(),
                                       [](double a, double b) { return numerics::exceeds(std::abs(b), std::abs(a)); });
    if (most == curve.y.end() || !(std::abs(*most) > 0.0)) continue;
    plot.marks.push_back({curve.x[static_cast<std::size_t>(most - curve.y.begin())], *most, curve.label});
  }
}

double moment_x(const Loaded& l, std::size_t s, bool right) {
  return right ? l.x.spans[s].right.M : l.x.spans[s].left.M;
}
double moment_y(const Loaded& l, std::size_t s, bool right) {
  return right ? l.y.spans[s].right.M : l.y.spans[s].left.M;
}
double force_x(const Loaded& l, std::size_t s, bool right) {
  return right ? l.x.spans[s].right.V : l.x.spans[s].left.V;
}
double force_y(const Loaded& l, std::size_t s, bool right) {
  return right ? l.y.spans[s].right.V : l.y.spans[s].left.V;
}
double torque(const Loaded& l, std::size_t s, bool) { return l.T[s]; }
double thrust(const Loaded& l, std::size_t s, bool) { return l.N[s]; }

using figure::Point;

/// In the planes X and Y of the shaft.
Point force_across(const Design::Input& in, const Seat& seat, std::size_t position) {
  const double towards = in.K_A * in_si(seat.F_x.at(position)), turned = in.K_A * in_si(seat.F_y.at(position));
  const double c = std::cos(seat.angle), s = std::sin(seat.angle);
  return {c * towards - s * turned, s * towards + c * turned};
}

/// As wide as its hub; up to the tips of its teeth, the bottom of its grooves or the surface of its hub.
figure::Shaft::Outline outline_of(const Seat& seat) {
  const auto first_of = [](std::initializer_list<Length> all) {
    for (const Length& one : all) {
      if (is_set(one) && one > 0.0 * mm) return in_si(one);
    }
    return 0.0;
  };
  const Length to_tips = is_set(seat.d_f) && is_set(seat.h_t) ? seat.d_f + 2.0 * seat.h_t : unset<Length>;
  return {in_si(seat.x), first_of({seat.b, seat.b_r, seat.l_c}), first_of({to_tips, seat.d_w, seat.d_f, seat.D_c})};
}

/// Torques and forces with K_A, as in the diagrams.
figure::Shaft side(const Design::Input& in, const Loaded& loaded, std::size_t position) {
  figure::Shaft shaft;
  double held = 0.0;  // the axial reaction
  for (const Piece& piece : in.pieces)
    shaft.parts.push_back({in_si(piece.l), in_si(piece.d), in_si(piece.d_bore), in_si(right_diameter(piece))});
  for (std::size_t i = 0; i < in.seats.size(); ++i) {
    const Seat& seat = in.seats[i];
    const double T = in_si(in.K_A * torque_of(in, i, position));
    const Point across = force_across(in, seat, position);
    const double axial = in.K_A * in_si(seat.F_z.at(position)), force = std::hypot(across.x, across.y);
    held -= axial;
    if (T != 0.0 || force > 0.0)
      shaft.torques.push_back(
          {in_si(seat.x), T, std::string(seat.name.view()), force, across, axial, outline_of(seat)});
  }
  for (std::size_t i = 0; i < in.supports.size(); ++i) {
    const Support& support = in.supports[i];
    const std::string name = support.name.empty() ? std::to_string(i + 1) : std::string(support.name.view());
    const Point reaction{loaded.x.reactions[i], loaded.y.reactions[i]};
    const bool is_locating = support.holds == Holds::both;
    shaft.bearings.push_back({in_si(pressure_centre(support)),
                              is_locating,
                              name,
                              std::hypot(reaction.x, reaction.y),
                              reaction,
                              is_locating ? held : 0.0,
                              {in_si(support.x)}});
  }
  return shaft;
}

figure::Plot elastic_line(const Loaded& loaded) {
  const std::vector<double> places(loaded.stations.x.begin(), loaded.stations.x.end());
  figure::Curve x{"v_X", places, {}}, y{"v_Y", places, {}};
  for (std::size_t n = 0; n < loaded.stations.x.size(); ++n) {
    x.y.push_back(loaded.x.nodes[n].v);
    y.y.push_back(loaded.y.nodes[n].v);
  }
  return diagram({"v", "deflection", "mm"}, {x, y});
}

/// The section that governs, as its line is called: "yield: pulley".
template <class Elements, class Use>
figure::Shaft::Place governing(const char* what, const Elements& all, const Use& use) {
  const auto most = std::max_element(all.begin(), all.end(),
                                     [&](const auto& a, const auto& b) { return numerics::exceeds(use(b), use(a)); });
  std::string name(most->name.view());
  if (name.empty()) name = std::to_string(most - all.begin() + 1);
  std::replace(name.begin(), name.end(), '_', ' ');  // else it would be typeset as a symbol
  return {in_si(most->x), say("{1}: {2}", what, name).text()};
}

std::vector<figure::Shaft::Place> governing(const Design::Result& r) {
  std::vector<figure::Shaft::Place> places;
  if (!r.sections.empty())
    places.push_back(governing("yield", r.sections, [](const Section& p) { return in_si(p.sigma_v); }));
  if (!r.safeties.empty()) places.push_back(governing("fatigue", r.safeties, [](const Safety& s) { return s.u_D; }));
  return places;
}

Turn turn_of(const Design::Input& in, const Elastic& elastic) {
  Turn turn(in, elastic.stations.x.size());
  for (std::size_t i = 0; i < turn.positions(); ++i) {
    const Loaded loaded = loaded_at(in, elastic, i);
    turn.take(loaded, loaded.largest_moment());
  }
  return turn;
}

/// The stresses of the section that decides, at a point that is fixed to the shaft.
figure::Figure over_turn(const Design::Input& in, const Elastic& elastic, const Turn& turn, const Section& p,
                         double theta) {
  const Value& series = *any_series(in);
  const std::size_t node = elastic.stations.at(p.x);
  const std::vector<double> at = series.signature.axis->at.values();
  figure::Curve sigma{"sigma", at, {}}, tau{"tau", at, {}};
  for (std::size_t i = 0; i < turn.positions(); ++i) {
    sigma.y.push_back(turn.moment(node, i, theta) * in_si(p.sigma_b / p.M));
    if (in_si(p.T) != 0.0) tau.y.push_back(turn.internal_forces(node, i).T * in_si(p.tau / abs(p.T)));
  }
  figure::Plot plot;
  plot.x = {"phi", series.signature.axis->quantity, series.signature.axis->unit};
  plot.y = {"sigma", "bending and torsional stress", "MPa"};
  plot.curves = {sigma};
  if (!tau.y.empty()) plot.curves.push_back(tau);
  return {"turn", "Stresses over a revolution at a point of the circumference, governing section", std::move(plot)};
}

}  // namespace

std::vector<figure::Figure> Design::figures(const Input& in, const Result& r) {
  const auto elastic = elastic_shaft(in);
  if (!elastic) return {};
  const Turn turn = turn_of(in, *elastic);
  const std::size_t position = turn.most_bent();
  const Loaded loaded = loaded_at(in, *elastic, position);
  figure::Shaft shaft = side(in, loaded, position);
  shaft.places = governing(r);
  if (std::any_of(loaded.N.begin(), loaded.N.end(), [](double N) { return N != 0.0; }))
    shaft.diagrams.push_back(diagram({"N", "axial force", "N"}, {along(loaded, "N", &thrust)}));
  shaft.diagrams.push_back(
      diagram({"V", "transverse force", "N"}, {along(loaded, "V_X", &force_x), along(loaded, "V_Y", &force_y)}));
  mark_peaks(shaft.diagrams.back());
  shaft.diagrams.push_back(
      diagram({"M", "bending moment", "N*m"}, {along(loaded, "M_X", &moment_x), along(loaded, "M_Y", &moment_y)}));
  mark_peaks(shaft.diagrams.back());
  shaft.diagrams.push_back(diagram({"T", "torque", "N*m"}, {along(loaded, "T", &torque)}));
  shaft.diagrams.push_back(elastic_line(loaded));
  mark_peaks(shaft.diagrams.back());
  const char* const caption =
      varies(in) ? "Shaft at its maximum bending in a revolution: loads, bearings, internal forces in both planes, "
                   "governing sections"
                 : "Shaft with loads and bearings, internal forces in both planes, governing sections";
  std::vector<figure::Figure> all{{"shaft", caption, std::move(shaft)}};
  if (auto whirl = campbell(in, *elastic, r)) all.push_back(*std::move(whirl));
  const auto weakest = std::max_element(r.safeties.begin(), r.safeties.end(), [](const Safety& a, const Safety& b) {
    return numerics::exceeds(b.u_D, a.u_D);
  });
  if (varies(in) && weakest != r.safeties.end()) {
    const Section& p = r.sections[static_cast<std::size_t>(weakest - r.safeties.begin())];
    if (p.M > 0.0 * N_m.one) all.push_back(over_turn(in, *elastic, turn, p, weakest->theta));
  }
  return all;
}

}  // namespace loadpath::shaft
