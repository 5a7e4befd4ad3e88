// The bar of shaft.held from the side, its moment and its rotation.
#include "calculators/shaft/held/bar.hpp"
#include "calculators/shaft/held/held.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace loadpath::shaft {

namespace {

using Input = Held::Input;

/// The outermost ring of a stretch, with the bore of the innermost.
Ring outline_of(const Input& in, const Slice& s) {
  Ring ring = ring_at(in.segments[s.segment], s.a);
  for (const Sleeve& sleeve : in.sleeves) {
    if (is_around(sleeve, s)) ring = {max(ring.d, sleeve.d), min(ring.d_bore, sleeve.d_bore)};
  }
  return ring;
}

figure::Shaft side(const Input& in, const Slices& slices, const Held::Result& r) {
  figure::Shaft shaft;
  for (const Slice& s : slices) {
    const Ring ring = outline_of(in, s);
    shaft.parts.push_back({in_si(s.l), in_si(ring.d), in_si(ring.d_bore)});
  }
  for (const AxialTorque& t : in.torques) {
    if (in_si(t.T) != 0.0) shaft.torques.push_back({in_si(t.x), in_si(t.T), std::string(t.name.view())});
  }
  if (in_si(r.R_1) != 0.0) shaft.torques.push_back({0.0, in_si(r.R_1), "R_1"});
  if (in_si(r.R_2) != 0.0) shaft.torques.push_back({in_si(length_of(in)), in_si(r.R_2), "R_2"});
  return shaft;
}

figure::Plot along(const figure::Scale& up, figure::Curve curve) {
  figure::Plot plot{{"x", "position along the bar", "mm"}, up};
  plot.curves.push_back(std::move(curve));
  return plot;
}

figure::Curve moment(const Held::Result& r) {
  figure::Curve curve{"M", {}, {}, true};
  for (const Held::Stretch& s : r.stretches) {
    curve.x.insert(curve.x.end(), {in_si(s.x), in_si(s.x + s.l)});
    curve.y.insert(curve.y.end(), {in_si(s.M_1), in_si(s.M_2)});
  }
  return curve;
}

/// Straight where the moment and the section are constant.
figure::Curve rotation(const Input& in, const Slices& slices, const Held::Result& r) {
  constexpr int parts = 16;
  figure::Curve curve{"phi", {0.0}, {r.phi_1}};
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Slice& s = slices[i];
    const bool straight = in_si(s.m) == 0.0 && !is_cone(in.segments[s.segment]);
    for (int k = straight ? parts : 1; k <= parts; ++k) {
      const Length x = s.l * (static_cast<double>(k) / parts);
      curve.x.push_back(in_si(s.x + x));
      curve.y.push_back(r.sections[i].phi + rotation_over(in, s, x, r.stretches[i].M_1));
    }
  }
  return curve;
}

}  // namespace

std::vector<figure::Figure> Held::figures(const Input& in, const Result& r) {
  const Slices slices = slices_of(in);
  std::vector<figure::Figure> figures;
  if (std::none_of(in.segments.begin(), in.segments.end(), &is_cone))
    figures.emplace_back("bar", "The bar from the side", side(in, slices, r));
  figures.emplace_back("torque-diagram", "Torque diagram", along({"M", "moment in the bar", "N*m"}, moment(r)));
  figures.emplace_back("rotation", "Rotation along the bar",
                       along({"phi", "rotation", "deg"}, rotation(in, slices, r)));
  return figures;
}

}  // namespace loadpath::shaft
