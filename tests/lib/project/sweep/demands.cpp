// The Pareto set of the designs that satisfy demands against a count over all points: with scatter and without, for
// every way to share the points out.
#include "tests/lib/project/sweep/swept.hpp"

#include <cmath>
#include <cstdint>
#include <set>

namespace {

using namespace loadpath;
using test::Swept;
using Kind = sweep::Constraint::Kind;

constexpr std::uint64_t samples = 50;
constexpr double quantile = 0.9;

std::string shaft(const std::string& torque) {
  return "[project.sweep]\nsamples = 50\nseed = 3\n[shaft]\ncalculator = \"shaft.torsion\"\ntau_adm = \"30 MPa\"\n"
         "d = { from = \"30 mm\", to = \"40 mm\", step = \"1 mm\" }\n"
         "d_bore = { from = \"0 mm\", to = \"35 mm\", step = \"5 mm\" }\nT = " +
         torque + "\n";
}

const std::vector<std::string> results{"area = shaft.d^2 - shaft.d_bore^2", "tau = shaft.tau_max",
                                       "demand 1 = shaft.passes", "demand 2 = shaft.d/(36 mm)"};

project::Keep asked() {
  project::Keep keep;
  keep.objectives = {{0, sweep::Aim::min}, {1, sweep::Aim::min}};
  keep.quantile = quantile;
  keep.demands = {{"shaft passes", 2, Kind::is_one, 1.0}, {"shaft.d <= 36 mm", 3, Kind::at_most_one, 1.0}};
  return keep;
}

/// With linear interpolation between ranks; NaN if a sample has no value.
double quantile_of(std::vector<double> values, double p) {
  if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) return NAN;
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto rank = static_cast<std::size_t>(place);
  const double next = values[std::min(rank + 1, values.size() - 1)];
  return values[rank] + (place - static_cast<double>(rank)) * (next - values[rank]);
}

struct Design {
  double area, tau;
  bool is_one, is_bounded;
};

std::vector<Design> all_designs(const Swept& swept, std::uint64_t of_each) {
  std::vector<Design> all;
  for (std::size_t first = 0; first < swept.columns[0].size(); first += of_each) {
    const auto part = [&](std::size_t k) {
      const auto from = swept.columns[k].begin() + static_cast<std::ptrdiff_t>(first);
      return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(of_each));
    };
    const std::vector<double> flags = part(2);
    const auto passing = static_cast<std::uint64_t>(std::count(flags.begin(), flags.end(), 1.0));
    const std::uint64_t allowed = of_each == 1 ? 0 : of_each / 10;  // one in ten samples may fail
    all.push_back({quantile_of(part(0), quantile), quantile_of(part(1), quantile), of_each - passing <= allowed,
                   quantile_of(part(3), quantile) <= 1.0});
  }
  return all;
}

std::set<std::uint64_t> front_of(const std::vector<Design>& all) {
  std::set<std::uint64_t> front;
  const auto counts = [](const Design& d) { return d.is_one && d.is_bounded && std::isfinite(d.tau); };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto beats = [&](const Design& d) {
      return counts(d) && d.area <= all[i].area && d.tau <= all[i].tau && (d.area < all[i].area || d.tau < all[i].tau);
    };
    if (counts(all[i]) && std::none_of(all.begin(), all.end(), beats)) front.insert(i);
  }
  return front;
}

std::set<std::uint64_t> numbers_of(const std::vector<sweep::Pareto::Point>& points) {
  std::set<std::uint64_t> numbers;
  for (const auto& point : points) numbers.insert(point.index);
  return numbers;
}

void check_counts(const project::DemandCounts& met, const std::vector<Design>& all) {
  const auto count = [&](auto holds) {
    return static_cast<std::uint64_t>(std::count_if(all.begin(), all.end(), holds));
  };
  CHECK(met.of_each[0] == count([](const Design& d) { return d.is_one; }));
  CHECK(met.of_each[1] == count([](const Design& d) { return std::isfinite(d.tau) && d.is_bounded; }));
  CHECK(met.all == count([](const Design& d) { return std::isfinite(d.tau) && d.is_one && d.is_bounded; }));
}

}  // namespace

TEST_SUITE("demands on a Pareto set") {
  TEST_CASE("designs with scatter, at the quantile") {
    for (const unsigned jobs : {1U, 3U}) {
      const Swept swept(shaft("{ mean = \"200 N*m\", sd = \"15 %\" }"), results, jobs, asked());
      REQUIRE(!has_errors(swept.issues));
      const auto all = all_designs(swept, samples);
      REQUIRE(all.size() == 88);
      const auto front = front_of(all);
      CHECK(front.size() > 2);
      CHECK(front.size() < all.size() / 2);
      CHECK(numbers_of(swept.sum.designs().pareto()) == front);
      check_counts(swept.sum.demands_met(), all);
    }
  }

  TEST_CASE("points without scatter") {
    for (const unsigned jobs : {1U, 3U}) {
      const Swept swept(shaft("\"200 N*m\""), results, jobs, asked());
      REQUIRE(!has_errors(swept.issues));
      const auto all = all_designs(swept, 1);
      const auto front = front_of(all);
      CHECK(front.size() > 2);
      CHECK(numbers_of(swept.sum.pareto()) == front);
      check_counts(swept.sum.demands_met(), all);
    }
  }

  TEST_CASE("stored and taken up again") {
    const Swept swept(shaft("{ mean = \"200 N*m\", sd = \"15 %\" }"), results, 1, asked());
    sweep::Writer writer;
    swept.sum.store(writer);
    project::SweepStatistics again = project::nothing_found(swept.plan, swept.read_again(), swept.keep);
    sweep::Reader reader(writer.bytes());
    again.load(reader);
    CHECK(reader.at_end());
    CHECK_FALSE(reader.failed());
    CHECK(again.demands_met().of_each == swept.sum.demands_met().of_each);
    CHECK(again.demands_met().all == swept.sum.demands_met().all);
  }
}
