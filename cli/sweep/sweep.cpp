#include "lib/report/sweep/sweep.hpp"

#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/output.hpp"
#include "cli/parts/parts.hpp"
#include "cli/solving.hpp"
#include "cli/staged.hpp"
#include "cli/sweep/contradictions.hpp"
#include "cli/sweep/planned.hpp"
#include "cli/sweep/point_files.hpp"
#include "cli/sweep/progress.hpp"
#include "cli/sweep/searches.hpp"
#include "cli/sweep/status.hpp"
#include "lib/export/sweep/csv.hpp"
#include "lib/export/sweep/hdf5.hpp"
#include "lib/export/sweep/json.hpp"
#include "lib/export/sweep/store.hpp"
#include "lib/report/sweep/designs.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>

namespace loadpath::cli {

namespace {

namespace fs = std::filesystem;
using exports::SweepStore;

std::atomic<bool> interrupted_by_user = false;

/// Reports a sweep of a project in which nothing varies.
void warn_nothing_varies(const std::string& file) {
  std::cerr << "loadpath: nothing to vary in '" << file << "': this sweep has one point, that of `loadpath run`\n"
            << "  = help: give an input a range or a list: d = { from = \"20 mm\", to = \"40 mm\", count = 11 }, or "
               "d = [\"20 mm\", \"25 mm\"]\n";
}

/// The sweep over all points, into a folder or not.
class Sweeping {
 public:
  explicit Sweeping(PlannedSweep& sweep) : sweep_(sweep), options_(sweep.options) {}
  int run();

 private:
  [[nodiscard]] exports::StoredSweep stored() const;
  [[nodiscard]] Outcome<SweepStore> open_store() const;
  [[nodiscard]] std::string what_is_left(const SweepStore& store) const;
  [[nodiscard]] bool solve(SweepStore* store, project::SweepStatistics& found);
  [[nodiscard]] int print_results(const project::SweepStatistics& found) const;
  int run_in_folder(project::SweepStatistics& found);

  PlannedSweep& sweep_;
  const SweepOptions& options_;
};

exports::StoredSweep Sweeping::stored() const {
  return {program(),         fs::path(options_.file).filename().string(),
          sweep_.identity(), sweep_.project.sweep.seed,
          sweep_.blocks,     !options_.no_columns};
}

Outcome<SweepStore> Sweeping::open_store() const {
  const exports::StoredSweep stored = this->stored();
  const project::SweepStatistics none = project::nothing_found(sweep_.points, sweep_.project, sweep_.keep);
  if (!options_.merge.empty())
    return SweepStore::merge({options_.merge.begin(), options_.merge.end()}, options_.out, sweep_.points, stored, none);
  if (options_.resume) return SweepStore::resume(options_.out, sweep_.points, stored, none);
  return SweepStore::create(options_.out, sweep_.points, stored, none);
}

std::string Sweeping::what_is_left(const SweepStore& store) const {
  const std::uint64_t first = store.left().first * project::block_size;
  const std::uint64_t last = std::min(store.left().last * project::block_size, sweep_.points.space.count()) - 1;
  return "stopped at " + std::to_string(store.found().points()) + " points; " + std::to_string(first) + " to " +
         std::to_string(last) + " are missing: loadpath sweep " + options_.file + " --out " + options_.out +
         " --resume goes on, with the same options\n";
}

/// False if an output cannot be written, which is reported, or the user has stopped it.
bool Sweeping::solve(SweepStore* store, project::SweepStatistics& found) {
  const std::chrono::duration<double> between(options_.save_every);
  Scratch scratch(store != nullptr && is_waited_for() ? &interrupted_by_user
                                                      : nullptr);  // a folder keeps solved points
  PointFiles files(options_, sweep_.points, scratch);
  if (!files.open(stored())) return false;
  const project::BlockRange blocks = store != nullptr ? store->left() : sweep_.blocks;
  const bool rows = files.any() || (store != nullptr && !options_.no_columns);
  const project::SweepWork work{sweep_.points, sweep_.reading(),    sweep_.keep, blocks, sweep_.jobs(),
                                rows,          &interrupted_by_user};
  Progress progress(blocks.count() * project::block_size, !options_.quiet);
  auto saved = std::chrono::steady_clock::now();
  bool whole = true;
  if (store != nullptr) scratch.leave_word(what_is_left(*store));
  const auto take = [&](project::SweptPart&& part) {
    if (!files.take(part)) return whole = false;
    Message wrong;
    if (store != nullptr)
      wrong = store->take(part);
    else
      whole = found.merge(part.found);
    const auto now = std::chrono::steady_clock::now();
    if (wrong.empty() && store != nullptr && now - saved >= between) {
      wrong = store->save();
      saved = now;
      if (store->left().count() != 0) scratch.leave_word(what_is_left(*store));
    }
    if (!wrong.empty()) {
      refuse(wrong.text());
      return whole = false;
    }
    progress.show((part.blocks.last - blocks.first) * project::block_size);
    return !interrupted_by_user;
  };
  const std::string unsolved = solve_parts(work, {sweep_.text, sweep_.identity()},
                                           {take, [&](const std::string& late) { progress.wait_for(late); }});
  progress.end();
  if (!unsolved.empty()) return refuse(unsolved), false;
  if (store != nullptr && whole) {
    if (const Message wrong = store->save(); !wrong.empty()) return refuse(wrong.text()), false;
  }
  return whole && (interrupted_by_user || files.finish());
}

std::optional<std::uint64_t> worst_point(const project::SweepStatistics& found) {
  const auto worst = found.worst();
  return worst.empty() ? std::nullopt : std::optional(worst.front().index);
}

int Sweeping::print_results(const project::SweepStatistics& found) const {
  report::DrawnPoints drawn;
  if (!options_.reports.empty()) drawn = report::points_to_draw(sweep_.points, found, sweep_.blocks, sweep_.reading());
  const report::Document document = report::sweep_document(sweep_.project, sweep_.points, found, program(), drawn);
  if (!write_reports(document, options_.reports, sweep_.project, options_.quiet)) return wrong_input;
  if (options_.json) {
    std::cout << exports::json_of(sweep_.project, sweep_.points, found, program());
  } else if (!options_.quiet) {
    const bool compares = sweep_.points.space.count() > sweep_.points.space.samples();
    const bool is_short = compares && !options_.full;
    terminal::show_tables(is_short ? report::sweep_answer(sweep_.project, sweep_.points, found) : document.blocks);
    const std::string file = options_.file == "-" ? "FILE" : options_.file;
    const auto point = is_short ? report::point_of_answer(found) : worst_point(found);
    if (point) std::cout << "\none point as a design: loadpath run " << file << " --point " << *point << "\n";
  }
  const bool is_whole = found.points() == sweep_.points.space.count();
  if (is_whole && !sweep_.keep.demands.empty() && found.demands_met().all == 0) return not_passed;
  const auto headline = project::headline_of(sweep_.points, found);
  return headline ? exit_for(*headline) : int{passed};
}

int Sweeping::run() {
  project::SweepStatistics found = project::nothing_found(sweep_.points, sweep_.project, sweep_.keep);
  if (!options_.out.empty()) return run_in_folder(found);
  if (!solve(nullptr, found)) return wrong_input;
  return interrupted_by_user ? int{interrupted} : print_results(found);
}

int Sweeping::run_in_folder(project::SweepStatistics& found) {
  auto store = open_store();
  if (!store) return refuse(store.fault().message.text(), store.fault().hint.text());
  for (const fs::path& folder : store->left_out())
    if (!options_.quiet) std::cerr << "loadpath: left out, the points are in others: '" << folder.string() << "'\n";
  if (store->left().count() != 0) {
    if (!solve(&*store, found)) return wrong_input;
  } else if (const Message wrong = store->save(); !wrong.empty()) {  // written after the last state by a killed process
    return refuse(wrong.text());
  }
  if (store->left().count() == 0) return print_results(store->found());
  std::cerr << what_is_left(*store);
  return interrupted;
}

/// On a rank that helps another with its sweep.
int help(PlannedSweep& sweep) {
  std::vector<Issue> issues;
  sweep.plan(issues);
  const project::SweepWork work{sweep.points, sweep.reading(), sweep.keep, {}, std::max(1U, sweep.options.jobs)};
  const bool read = !has_errors(issues);
  return help_parts(work, read ? sweep.identity() : "",
                    read ? "" : "finds errors in what the first rank has read without");
}

/// The exit code if an output cannot be written as asked.
std::optional<int> refuse_outputs(const SweepOptions& options) {
  OutputOptions reports;
  reports.reports = options.reports;
  if (!can_write(reports) || !can_place(options.csv) || !can_place(options.hdf5)) return wrong_input;
  if (!options.hdf5.empty() && fs::is_other(options.hdf5))
    return refuse("'" + options.hdf5 + "' is a device or a pipe, and HDF5 needs a file",
                  "name a file, or use --csv, which writes through pipes");
  if (takes_standard_output(reports)) return refuse("a report of a sweep is a file: --report FILE.html");
  return {};
}

/// Whether an output has the place of a file that the project is read from, which is reported.
bool overwrites_inputs(const PlannedSweep& sweep) {
  std::vector<fs::path> outputs(sweep.options.reports.begin(), sweep.options.reports.end());
  if (!sweep.options.csv.empty()) outputs.emplace_back(sweep.options.csv);
  if (!sweep.options.hdf5.empty()) outputs.emplace_back(sweep.options.hdf5);
  return overwrites(outputs, sweep.project);
}

int answer(PlannedSweep& sweep) {
  const SweepOptions& options = sweep.options;
  if (!sweep.prepare() || overwrites_inputs(sweep)) return wrong_input;
  if (!options.minimise.empty() || !options.maximise.empty()) return choose(sweep);
  if (!options.seek.empty()) return seek(sweep);
  if (options.influence || options.sobol != 0) return ask_influence(sweep);
  std::vector<Issue> open;
  project::refuse_open_ranges(sweep.points, open);
  if (has_errors(open)) return sweep.refuse_all(open);
  if (sweep.points.inputs.empty() && !options.quiet) warn_nothing_varies(options.file);
  return Sweeping(sweep).run();
}

}  // namespace

int sweep(const SweepOptions& options) {
  if (const std::string* const helped = helped_text()) {
    PlannedSweep sweep(options, *helped);
    return help(sweep);
  }
  if (const std::string wrong = contradiction(options); !wrong.empty()) return refuse(wrong);
  if (!options.status.empty()) return print_status(options);
  if (const auto refused = refuse_outputs(options)) return *refused;
  std::string text;
  if (!toml::read_file(options.file, text))
    return refuse("cannot read '" + options.file + "'", help_for_file(options.file));
  PlannedSweep sweep(options, std::move(text));
  return answer(sweep);
}

}  // namespace loadpath::cli
