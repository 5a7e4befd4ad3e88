#include "lib/sweep/point/correlation.hpp"

#include "lib/numerics/dense_inverse.hpp"
#include "lib/simd/attributes.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace loadpath::sweep {

namespace {

// Below it the residual share of a variable, given the others, is rounding.
constexpr double smallest_share = 1e-12;

struct Matrix {
  const std::vector<double>& values;
  std::size_t size;
  double operator()(std::size_t i, std::size_t j) const { return values[i * size + j]; }
};

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

Fault refused(Message message, Message hint = {}) { return {0, 1, std::move(message), std::move(hint)}; }

std::optional<Fault> fault_of_entries(const Matrix& R, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < R.size; ++i) {
    if (R(i, i) != 1.0) return refused(say("the correlation of {1} with itself must be 1", names[i]));
    for (std::size_t j = 0; j < i; ++j) {
      if (!(R(i, j) == R(j, i)))
        return refused(
            say("the correlation of {1} and {2} must be the same as that of {2} and {1}", names[j], names[i]));
      if (!(std::abs(R(i, j)) < 1.0))
        return refused(say("the correlation of {1} and {2} must lie between -1 and 1", names[j], names[i]));
    }
  }
  return std::nullopt;
}

/// The rows up to the first one without residual variance; all of them if there is none.
std::size_t root_of(const Matrix& R, std::vector<double>& root) {
  root.assign(R.size * R.size, 0.0);
  for (std::size_t i = 0; i < R.size; ++i) {
    double left = 1.0;
    for (std::size_t j = 0; j < i; ++j) {
      double sum = R(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= root[i * R.size + k] * root[j * R.size + k];
      root[i * R.size + j] = sum / root[j * R.size + j];
      left -= root[i * R.size + j] * root[i * R.size + j];
    }
    if (!(left > smallest_share)) return i;
    root[i * R.size + i] = std::sqrt(left);
  }
  return R.size;
}

struct Bounds {
  std::size_t with;
  double low, high, away;
};

/// The permitted interval of row i in column j, with its other coefficients before i fixed: where 1 - r' A^-1 r > 0.
std::optional<Bounds> bounds_of(const Matrix& R, const std::vector<double>& inverse, std::size_t i, std::size_t j) {
  double linear = 0.0, rest = -1.0;
  for (std::size_t a = 0; a < i; ++a) {
    if (a == j) continue;
    linear += inverse[j * i + a] * R(i, a);
    for (std::size_t b = 0; b < i; ++b) rest += b == j ? 0.0 : R(i, a) * inverse[a * i + b] * R(i, b);
  }
  const double square = inverse[j * i + j], under = linear * linear - square * rest;
  if (!(under > 0.0)) return std::nullopt;
  const double low = (-linear - std::sqrt(under)) / square, high = (-linear + std::sqrt(under)) / square;
  return Bounds{j, low, high, std::max(low - R(i, j), R(i, j) - high)};
}

/// The permitted coefficient of row i that is nearest to the given one.
Fault not_definite(const Matrix& R, std::size_t i, const std::vector<std::string>& names) {
  std::vector<double> inverse(i * i);
  for (std::size_t a = 0; a < i; ++a) {
    for (std::size_t b = 0; b < i; ++b) inverse[a * i + b] = R(a, b);
  }
  numerics::DenseInverse(i).invert(inverse);
  std::optional<Bounds> nearest;
  for (std::size_t j = 0; j < i; ++j) {
    const auto bounds = bounds_of(R, inverse, i, j);
    if (bounds && (!nearest || bounds->away < nearest->away)) nearest = bounds;
  }
  if (!nearest) {
    return refused(
        say("the correlations of {1} contradict those of the others: the matrix is not positive definite", names[i]));
  }
  return refused(say("the correlation of {1} and {2} contradicts the others: the matrix is not positive definite",
                     names[nearest->with], names[i]),
                 say("with the other correlations unchanged it must be between {1} and {2}", number(nearest->low),
                     number(nearest->high)));
}

/// y = y * own.
LOADPATH_COLUMNS void scale(double* y, double own, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) y[i] *= own;
}

/// y = y + share * z.
LOADPATH_COLUMNS void add(double* y, const double* z, double share, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) y[i] += share * z[i];
}

}  // namespace

Outcome<Correlation> Correlation::of(std::vector<double> matrix, const std::vector<std::string>& names) {
  const Matrix R{matrix, names.size()};
  if (matrix.size() != R.size * R.size)
    return refused(say("the correlation matrix must have {1} rows and columns", std::to_string(R.size)));
  if (auto fault = fault_of_entries(R, names)) return *std::move(fault);
  Correlation made;
  made.size_ = R.size;
  const std::size_t good = root_of(R, made.root_);
  if (good < R.size) return not_definite(R, good, names);
  made.bound_.assign(R.size, 0);
  for (std::size_t i = 0; i < R.size; ++i) {
    for (std::size_t j = 0; j < R.size; ++j) {
      if (i != j && R(i, j) != 0.0) made.bound_[i] = 1;
    }
  }
  return made;
}

// From the last row up: the rows before it are still unchanged.
void Correlation::apply(std::span<double* const> columns, std::size_t n) const {
  for (std::size_t i = size_; i-- > 1;) {
    const double own = root_[i * size_ + i];
    if (own != 1.0) scale(columns[i], own, n);
    for (std::size_t j = 0; j < i; ++j) {
      if (const double share = root_[i * size_ + j]; share != 0.0) add(columns[i], columns[j], share, n);
    }
  }
}

}  // namespace loadpath::sweep
