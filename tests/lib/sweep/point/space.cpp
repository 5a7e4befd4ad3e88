// The points of a sweep as a function of their index.
#include "lib/sweep/point/space.hpp"

#include "lib/sweep/point/latin.hpp"
#include "lib/sweep/point/uniform.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace loadpath::sweep;

using Columns = std::vector<std::vector<double>>;

Columns columns_of(const Space& space, std::uint64_t first, std::size_t n) {
  Columns columns(space.variables(), std::vector<double>(n));
  std::vector<double*> places;
  for (auto& column : columns) places.push_back(column.data());
  space.fill(first, n, places);
  return columns;
}

std::vector<double> values_of(const Axis& axis) {
  std::vector<double> values;
  for (std::uint64_t i = 0; i < axis.size(); ++i) values.push_back(axis.at(i));
  return values;
}

Axis list(std::vector<double> values) { return *Axis::list(std::move(values)); }

Space::Random two_normals(double rho, std::uint64_t samples) {
  Space::Random random;
  random.variables = {Distribution(Normal{10.0, 2.0}), Distribution(Weibull{5.0, 2.0})};
  if (rho != 0.0) random.correlation = *Correlation::of({1.0, rho, rho, 1.0}, {"a", "b"});
  random.samples = samples;
  random.seed = 7;
  return random;
}

double mean_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_SUITE("points of sweeps") {
  TEST_CASE("random numbers are Philox4x32-10: the known answers of Random123") {
    using Bits = std::array<std::uint64_t, 2>;  // the second word of each two is the upper one
    const auto as_purpose = [](std::uint32_t word) { return static_cast<Purpose>(word); };
    CHECK(random_bits(0, 0, 0, as_purpose(0)) == Bits{0xe169c58d6627e8d5, 0x9b00dbd8bc57ac4c});
    const std::uint64_t ones = ~std::uint64_t{0};
    CHECK(random_bits(ones, ones, ones, as_purpose(0xffffffff)) == Bits{0x41c83b0e408f276d, 0x6d5451fda20bc7c6});
    CHECK(random_bits(0x299f31d0a4093822, 0x85a308d3243f6a88, 0x13198a2e, as_purpose(0x03707344)) ==
          Bits{0x94fdccebd16cfe09, 0x24126ea15001e420});
  }

  TEST_CASE("a column of random numbers has the bits of its single numbers, wherever it begins") {
    for (const std::uint64_t first : {0ULL, 1ULL, 6ULL, (1ULL << 33) - 5, 1'000'000'007ULL}) {
      std::vector<double> column(first % 2 == 0 ? 331 : 23);
      uniform(3, first, 2, column);
      for (std::size_t i = 0; i < column.size(); ++i) {
        CHECK(column[i] == uniform(3, first + i, 2));
        CHECK_UNARY(column[i] > 0.0 && column[i] < 1.0);
      }
    }
    CHECK(uniform(3, 5, 2) != uniform(4, 5, 2));
    CHECK(uniform(3, 5, 2) != uniform(3, 5, 1));
    CHECK(uniform(3, 5, 2) != uniform(3, 5, 2, Purpose::search));
  }

  TEST_CASE("random numbers are spread evenly") {
    constexpr std::size_t n = 100'000, parts = 100;
    std::vector<double> column(n), counts(parts, 0.0);
    uniform(1, 0, 0, column);
    for (const double u : column) ++counts[static_cast<std::size_t>(u * parts)];
    double chi_square = 0.0;
    for (const double count : counts) chi_square += (count - 1000.0) * (count - 1000.0) / 1000.0;
    CHECK(chi_square > 60.0);   // 99 degrees of freedom: 0.1 % lie below 61.1
    CHECK(chi_square < 149.0);  // and 0.1 % above 148.2
  }

  TEST_CASE("an axis by steps meets its end within rounding, and accumulates no error") {
    const auto tenths = values_of(*Axis::by_step(0.0, 1.0, 0.1));
    REQUIRE(tenths.size() == 11);
    for (std::size_t i = 0; i < 10; ++i) CHECK(tenths[i] == static_cast<double>(i) * 0.1);
    CHECK(tenths.back() == 1.0);
    CHECK(values_of(*Axis::by_step(0.0, 0.3, 0.1)).back() == 0.3);
    CHECK(values_of(*Axis::by_step(100.0, 100.3, 0.1)).back() == 100.3);
    CHECK(values_of(*Axis::by_step(0.0, 1.0, 0.3)) == std::vector<double>{0.0, 0.3, 0.6, 3.0 * 0.3});
    CHECK(values_of(*Axis::by_step(0.0, 1.0, 0.4)).back() == 0.8);
    CHECK(values_of(*Axis::by_step(2.0, 1.0, -0.5)) == std::vector<double>{2.0, 1.5, 1.0});
    CHECK(values_of(*Axis::by_step(2.0, 2.0, 0.5)) == std::vector<double>{2.0});
    CHECK(values_of(*Axis::by_step(1e17, 1e17 + 16.0, 64.0)) == std::vector<double>{1e17});
    CHECK(Axis::by_step(0.0, 1e9, 1.0)->size() == 1'000'000'001);
  }

  TEST_CASE("an axis by number has both its ends") {
    CHECK(values_of(*Axis::by_count(0.0, 1.0, 11))[3] == 0.3);
    CHECK(values_of(*Axis::by_count(0.1, 0.5, 5)) == std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5});
    CHECK(values_of(*Axis::by_count(5.0, -5.0, 3)) == std::vector<double>{5.0, 0.0, -5.0});
    CHECK(values_of(*Axis::logarithmic(1.0, 1000.0, 4)) == std::vector<double>{1.0, 10.0, 100.0, 1000.0});
    CHECK(values_of(*Axis::logarithmic(-1.0, -0.01, 3)) == std::vector<double>{-1.0, -0.1, -0.01});
  }

  TEST_CASE("an axis without points is refused") {
    CHECK(Axis::by_step(0.0, 1.0, 0.0).fault().message.text() == "the step must not be zero");
    CHECK(Axis::by_step(0.0, 1.0, -0.1).fault().message.text() == "the step leads away from the end of the range");
    CHECK(Axis::by_step(0.0, 1.0, 1e-20).fault().message.text() == "the step is too small for the range");
    CHECK(Axis::by_count(0.0, 1.0, 1).fault().message.text() == "a range has 2 values at least");
    CHECK(Axis::logarithmic(0.0, 1.0, 3).fault().message.text() ==
          "the ends of a logarithmic range must be of one sign, and not zero");
    CHECK(Axis::logarithmic(1.0, 0.0, 3).fault().message.text() ==
          "the ends of a logarithmic range must be of one sign, and not zero");
    CHECK(Axis::list({}).fault().message.text() == "the list of values is empty");
    CHECK(Axis::list({1.0, NAN}).fault().message.text() == "the values must be numbers");
  }

  TEST_CASE("the first level is the slowest, and values of a level vary together") {
    const Space space = *Space::of({{list({1.0, 2.0})}, {list({3.0, 4.0, 5.0}), list({6.0, 7.0, 8.0})}}, {});
    CHECK(space.count() == 6);
    CHECK(columns_of(space, 0, 6) ==
          Columns{{1.0, 1.0, 1.0, 2.0, 2.0, 2.0}, {3.0, 4.0, 5.0, 3.0, 4.0, 5.0}, {6.0, 7.0, 8.0, 6.0, 7.0, 8.0}});
    CHECK(space.point(4) == std::vector<double>{2.0, 4.0, 7.0});
  }

  TEST_CASE("the first point at a place of the grid") {
    const Space space =
        *Space::of({{list({1.0, 2.0})}, {list({9.0})}, {list({3.0, 4.0, 5.0}), list({6.0, 7.0, 8.0})}, {list({9.0})}},
                   two_normals(0.0, 37));
    for (std::uint64_t a = 0; a < 2; ++a) {
      for (std::uint64_t b = 0; b < 3; ++b) {
        const std::uint64_t first = space.first_at(std::vector<std::uint64_t>{a, 0, b, b, 0});
        CHECK(first == (3 * a + b) * 37);
        const auto point = space.point(first);
        CHECK(point[0] == 1.0 + static_cast<double>(a));
        CHECK(point[3] == 6.0 + static_cast<double>(b));
      }
    }
  }

  TEST_CASE("an empty space is one point") {
    CHECK(Space().count() == 1);
    CHECK(Space().point(0).empty());
  }

  TEST_CASE("a point is a function of its index alone, in whatever order points are requested") {
    for (const auto sampling : {Sampling::random, Sampling::latin_hypercube, Sampling::sobol}) {
      for (const bool common : {false, true}) {
        Space::Random random = two_normals(0.6, 37);
        random.sampling = sampling;
        random.common = common;
        const Space space = *Space::of({{*Axis::by_count(0.0, 1.0, 9)}, {list({1.0, 2.0, 4.0})}}, random);
        REQUIRE(space.count() == 999);
        const Columns whole = columns_of(space, 0, 999);
        std::mt19937 order(5);
        for (std::uint64_t first = 0; first < 999;) {
          const auto n = std::min<std::uint64_t>(1 + order() % 150, 999 - first);
          const Columns part = columns_of(space, first, n);
          for (std::size_t k = 0; k < part.size(); ++k)
            CHECK_UNARY(std::equal(part[k].begin(), part[k].end(), whole[k].begin() + static_cast<long>(first)));
          CHECK(space.point(first)[3] == part[3][0]);
          first += n;
        }
        const auto& a = whole[2];
        CHECK(std::equal(a.begin(), a.begin() + 37, a.begin() + 37) == common);
      }
    }
  }

  TEST_CASE("samples have the moments and the correlation of their distributions") {
    constexpr std::size_t n = 200'000;
    const double rho = 0.7;
    Space::Random random = two_normals(rho, n);
    random.variables[1] = Distribution(Normal{-3.0, 0.5});
    const Columns found = columns_of(*Space::of({}, random), 0, n);
    std::vector<double> a, b;
    for (std::size_t i = 0; i < n; ++i) {
      a.push_back((found[0][i] - 10.0) / 2.0);
      b.push_back((found[1][i] + 3.0) / 0.5);
    }
    const std::vector<double> one(n, 1.0);
    const double error = 4.0 / std::sqrt(static_cast<double>(n));  // four times the standard error
    CHECK(std::abs(mean_product(a, one)) < error);
    CHECK(std::abs(mean_product(b, one)) < error);
    CHECK(std::abs(mean_product(a, a) - 1.0) < error * std::sqrt(2.0));
    CHECK(std::abs(mean_product(b, b) - 1.0) < error * std::sqrt(2.0));
    CHECK(std::abs(mean_product(a, b) - rho) < error * std::sqrt(1.0 + rho * rho));
  }

  TEST_CASE("correlated variables keep their own distribution") {
    constexpr std::size_t n = 20'000;
    const Columns found = columns_of(*Space::of({}, two_normals(-0.8, n)), 0, n);
    std::vector<double> sorted = found[1];
    std::sort(sorted.begin(), sorted.end());
    double away = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double p = Distribution(Weibull{5.0, 2.0}).cumulative(sorted[i]);
      away = std::max(away, std::abs(p - (static_cast<double>(i) + 0.5) / n));
    }
    CHECK(away * std::sqrt(static_cast<double>(n)) < 1.95);  // Kolmogorov: 0.1 % lie above
  }

  TEST_CASE("an uncorrelated variable of a correlation matrix has the bits that it has alone") {
    Space::Random alone = two_normals(0.0, 100), beside = alone;
    beside.variables.push_back(Distribution(Lognormal{2.0, 0.1}));
    beside.correlation = *Correlation::of({1.0, 0.0, 0.5, 0.0, 1.0, 0.0, 0.5, 0.0, 1.0}, {"a", "b", "c"});
    CHECK(columns_of(*Space::of({}, alone), 0, 100)[1] == columns_of(*Space::of({}, beside), 0, 100)[1]);
  }

  TEST_CASE("a Latin hypercube has each variable once in each part") {
    Space::Random random = two_normals(0.0, 1000);
    random.variables = {Distribution(Uniform{}), Distribution(Uniform{})};
    random.sampling = Sampling::latin_hypercube;
    const Columns found = columns_of(*Space::of({{list({1.0, 2.0})}}, random), 0, 2000);
    for (const std::size_t variable : {1, 2}) {
      for (const std::size_t cube : {0, 1}) {
        std::set<int> parts;
        for (std::size_t i = 0; i < 1000; ++i)
          parts.insert(static_cast<int>(found[variable][1000 * cube + i] * 1000.0));
        CHECK(parts.size() == 1000);
      }
    }
    CHECK(std::abs(12.0 * (mean_product(found[1], found[2]) - 0.25)) < 4.0 / std::sqrt(2000.0));
  }

  TEST_CASE("permutations by a key are permutations") {
    for (const std::uint64_t size : {1ULL, 2ULL, 3ULL, 5ULL, 64ULL, 65ULL, 1000ULL}) {
      const Permutation permutation(size, 1, 2, 3);
      std::set<std::uint64_t> met;
      for (std::uint64_t i = 0; i < size; ++i) met.insert(permutation(i));
      CHECK(met.size() == size);
      CHECK(*met.rbegin() == size - 1);
    }
  }

  TEST_CASE("an impossible correlation matrix is refused, with the pair") {
    const std::vector<std::string> names{"d", "T", "R_e"};
    const auto refused = [&](std::vector<double> matrix) { return Correlation::of(std::move(matrix), names).fault(); };
    CHECK(refused({1.0, 0.0, 0.0, 0.0, 1.0, 0.1, 0.0, 0.2, 1.0}).message.text() ==
          "the correlation of T and R_e must be the same as that of R_e and T");
    CHECK(refused({1.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0}).message.text() ==
          "the correlation of d and T must lie between -1 and 1");
    CHECK(refused({1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 1.0}).message.text() ==
          "the correlation of T with itself must be 1");
    CHECK(refused({1.0}).message.text() == "the correlation matrix must have 3 rows and columns");
    // With r_12 = r_23 = 0.9, r_13 lies in 0.81 +- 0.19: r_12 r_23 +- sqrt((1 - r_12^2)(1 - r_23^2)).
    const auto contradicts = refused({1.0, 0.9, 0.5, 0.9, 1.0, 0.9, 0.5, 0.9, 1.0});
    CHECK(contradicts.message.text() ==
          "the correlation of T and R_e contradicts the others: the matrix is not positive definite");
    // 0.45 +- sqrt(0.19 * 0.75) = 0.45 +- 0.377492
    CHECK(contradicts.hint.text() == "with the other correlations unchanged it must be between 0.07251 and 0.8275");
  }

  TEST_CASE("impossible spaces are refused") {
    const Axis big = *Axis::by_count(0.0, 1.0, std::uint64_t{1} << 31);
    CHECK(Space::of({{big}, {big}}, {})->count() == std::uint64_t{1} << 62);
    CHECK(Space::of({{big}, {big}, {list({1.0, 2.0, 3.0})}}, {}).fault().message.text() ==
          "these are more than 2^63 points");
    CHECK(Space::of({{list({1.0, 2.0}), list({1.0, 2.0, 3.0})}}, {}).fault().message.text() ==
          "values varied in parallel must be equal in number: 2 and 3");
    Space::Random none = two_normals(0.0, 0);
    CHECK(Space::of({}, none).fault().message.text() == "the number of samples must be > 0");
    none.samples = 5;
    none.variables.clear();
    CHECK(Space::of({}, none).fault().message.text() == "samples are given, and nothing is random");
  }
}
