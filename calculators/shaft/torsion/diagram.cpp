#include "calculators/shaft/torsion/diagram.hpp"

#include <utility>

namespace loadpath::shaft {

namespace {

/// By place. Few torques, mostly given in order: an insertion sort is the fastest, and keeps those that share a place.
void sort(Torques& torques) {
  for (std::size_t i = 1; i < torques.size(); ++i) {
    for (std::size_t k = i; k > 0 && torques[k].x < torques[k - 1].x; --k) std::swap(torques[k], torques[k - 1]);
  }
}

}  // namespace

Stretches stretches(Torques torques, const Cylinders& cylinders) {
  sort(torques);
  Length end = 0.0 * m.one;
  for (const Cylinder& c : cylinders) end += c.l;
  const Length same = 1e-12 * end;  // places closer than the rounding of a length count as one
  Stretches result;
  Length x = 0.0 * m.one;
  Moment M = 0.0 * N_m.one;
  auto next = torques.begin();
  end = x;
  for (const Cylinder& c : cylinders) {
    end += c.l;
    while (end - x > same) {
      for (; next != torques.end() && next->x <= x + same; ++next) M += next->T;
      const Length stop = next != torques.end() && next->x < end - same ? next->x : end;
      result.push_back({x, M, {stop - x, c.d, c.chi, c.d_bore, c.rho}});
      x = stop;
    }
  }
  if (result.empty()) result.push_back({x, M, cylinders.front()});
  return result;
}

}  // namespace loadpath::shaft
