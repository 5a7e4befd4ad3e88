#include "cli/points.hpp"

#include <algorithm>
#include <charconv>

namespace loadpath::cli {

namespace {

std::vector<project::Placed> split(const std::string& list, const char* option) {
  std::vector<project::Placed> all;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    std::string name = list.substr(from, to - from);
    while (name.starts_with(' ')) name.erase(0, 1);
    while (name.ends_with(' ')) name.pop_back();
    all.push_back({std::move(name), {option, 1, 1, 1}});
    from = to + 1;
  }
  return all;
}

/// Two integers and their separator; 0 for any other text.
char parted(const std::string& text, std::uint64_t& a, std::uint64_t& b) {
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, a);
  if (first.ec != std::errc() || first.ptr == end) return 0;
  const auto second = std::from_chars(first.ptr + 1, end, b);
  return second.ec == std::errc() && second.ptr == end ? *first.ptr : '\0';
}

/// The share K of N, counted from 1. If N is doubled, each share is split in two: finished work still fits.
project::BlockRange share_of(std::uint64_t blocks, std::uint64_t k, std::uint64_t n) {
  const auto start = [&](std::uint64_t i) { return blocks / n * i + blocks % n * i / n; };
  return {start(k - 1), start(k)};
}

}  // namespace

void take_points(const PointOptions& options, project::SweepSettings& settings) {
  settings.samples = options.samples.value_or(settings.samples);
  settings.seed = options.seed.value_or(settings.seed);
  settings.latin = settings.latin || options.latin;
  for (const std::string& zip : options.zip) settings.zip.push_back(split(zip, "--zip"));
}

std::string needs_point(const PointOptions& options) {
  const std::string given = options.samples       ? "--samples"
                            : options.seed        ? "--seed"
                            : options.latin       ? "--latin"
                            : options.zip.empty() ? ""
                                                  : "--zip";
  return given.empty() ? given : "'" + given + "' applies to a sweep, and this solves a single design";
}

void take_point(project::Project& project, std::uint64_t point, std::vector<Issue>& issues) {
  const project::SweepPlan plan = project::plan_sweep(project, project.sweep, issues);
  if (has_errors(issues)) return;
  if (point >= plan.space.count()) {
    issues.push_back({{"--point", 0, 0, 1},
                      "",
                      say("point {1} does not exist: the sweep has {2}, counted from 0", std::to_string(point),
                          std::to_string(plan.space.count())),
                      {},
                      Severity::error});
    return;
  }
  project::set_point(project, plan, point, issues);
  project.meta.emplace_back("point", std::to_string(point) + " of " + std::to_string(plan.space.count()));
}

Outcome<project::BlockRange> read_share(const std::string& text, const project::SweepPlan& plan) {
  const auto wrong = [&](Message hint) {
    return Fault{0, 1, say("'{1}' is not a shard of a sweep", text), std::move(hint)};
  };
  std::uint64_t a = 0, b = 0;
  const char between = parted(text, a, b);
  constexpr std::uint64_t most = 1'000'000'000;  // shares
  if (between == '/' && a >= 1 && a <= b && b <= most) return share_of(project::all_blocks(plan).count(), a, b);
  if (between != '-') return wrong(say("write --shard 2/10, counted from 1, or points: --shard 512-1023"));
  constexpr std::uint64_t size = project::block_size;
  const std::uint64_t count = plan.space.count();
  if (a > b || b >= count) return wrong(say("the points are 0 to {1}", std::to_string(count - 1)));
  if (a % size != 0 || ((b + 1) % size != 0 && b + 1 != count))
    return wrong(
        say("points are solved in blocks of {1}: a shard starts with a block and ends with one or with the last point",
            std::to_string(size)));
  return project::BlockRange{a / size, b / size + 1};
}

}  // namespace loadpath::cli
