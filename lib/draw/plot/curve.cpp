#include "lib/draw/plot/curve.hpp"

#include "lib/draw/canvas/thin.hpp"

namespace loadpath::draw {
namespace {

void see_level(std::vector<Level>& levels, Point from, Point to, double si) {
  constexpr double equal = 1e-6;
  if (std::fabs(to.y - from.y) > equal || to.x <= from.x) return;
  const bool goes_on = !levels.empty() && length(levels.back().to - from) < equal;
  if (goes_on) {
    levels.back().to = to;
  } else {
    levels.push_back({from, to, si});
  }
}

}  // namespace

DrawnCurve drawn_curve(const figure::Curve& curve, const PlotFrame& frame) {
  DrawnCurve drawn;
  std::vector<Point> piece;
  const auto end_piece = [&] {
    if (!piece.empty()) drawn.pieces.push_back(thin(piece));
    piece.clear();
  };
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    const auto here = frame.place(curve.x[i], curve.y[i]);
    if (!here) {
      end_piece();
      continue;
    }
    if (curve.filled && !piece.empty()) see_level(drawn.levels, piece.back(), *here, curve.y[i]);
    piece.push_back(*here);
  }
  end_piece();
  return drawn;
}

}  // namespace loadpath::draw
