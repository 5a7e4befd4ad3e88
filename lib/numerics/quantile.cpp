#include "lib/numerics/quantile.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <limits>

namespace loadpath::numerics {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool is_open_share(double p) { return p > 0.0 && p < 1.0; }

}  // namespace

double normal_quantile(double p) {
  return is_open_share(p) ? boost::math::quantile(boost::math::normal_distribution<double>{}, p) : nan;
}

double student_quantile(double p, int n) {
  return is_open_share(p) && n >= 1 ? boost::math::quantile(boost::math::students_t_distribution<double>(n), p) : nan;
}

}  // namespace loadpath::numerics
