// The drive of any chain on its pitch circles.
#pragma once

#include "calculators/belt/figures.hpp"
#include "lib/quantity/units.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace loadpath::chain {

/// The sprockets, the spans and the shaft load; the driving sprocket at n_1.
template <class Result>
std::vector<figure::Figure> drive_figures(AngularSpeed n_1, const Result& r) {
  belt::TwoWheels w;
  w.d_1 = in_si(r.d_1), w.d_2 = in_si(r.d_2), w.a = in_si(r.a);
  w.alpha_1 = r.alpha_1, w.alpha_2 = r.alpha_2;
  w.n_1 = in_si(n_1), w.n_2 = in_si(r.n_2);
  belt::Pulls pulls;
  pulls.tight_symbol = "F", pulls.tight = in_si(r.F);
  pulls.symbol = "F_W", pulls.R = pulls.R_x = in_si(r.F_W), pulls.R_y = 0.0;
  auto drawing = std::make_shared<figure::Drawing>();
  drawing->views = {belt::drive_view(w, pulls)};
  return {{"chain", "The drive on its pitch circles: 1 drives, clockwise as drawn, so that its tight span lies below",
           figure::Drawn(std::move(drawing))}};
}

}  // namespace loadpath::chain
