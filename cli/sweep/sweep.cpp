#include "lib/report/sweep/sweep.hpp"

#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/parts/parts.hpp"
#include "cli/points.hpp"
#include "cli/settings/settings.hpp"
#include "cli/solving.hpp"
#include "cli/staged.hpp"
#include "cli/sweep/contradictions.hpp"
#include "cli/sweep/point_files.hpp"
#include "cli/sweep/progress.hpp"
#include "cli/sweep/status.hpp"
#include "lib/export/sweep/csv.hpp"
#include "lib/export/sweep/hdf5.hpp"
#include "lib/export/sweep/json.hpp"
#include "lib/export/sweep/searches.hpp"
#include "lib/export/sweep/store.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/quantity/format.hpp"
#include "lib/report/sweep/best.hpp"
#include "lib/report/sweep/designs.hpp"
#include "lib/report/sweep/influence.hpp"
#include "lib/toml/tree.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <thread>

namespace loadpath::cli {

namespace {

namespace fs = std::filesystem;
using exports::SweepStore;

std::atomic<bool> interrupted_by_user = false;

int refuse(const std::string& message, const std::string& hint = {}) {
  std::cerr << "loadpath: " << message << "\n";
  if (!hint.empty()) std::cerr << "  = help: " << hint << "\n";
  return wrong_input;
}

/// Reports a sweep of a project in which nothing varies.
void tell_nothing_varies(const std::string& file) {
  std::cerr << "loadpath: nothing to vary in '" << file << "': this sweep has one point, that of `loadpath run`\n"
            << "  = help: give an input a range or a list: d = { from = \"20 mm\", to = \"40 mm\", count = 11 }, or "
               "d = [\"20 mm\", \"25 mm\"]\n";
}

/// One command at work.
class Sweeping {
 public:
  explicit Sweeping(const SweepOptions& options) : options_(options) {}
  int run();
  /// On a rank that helps another with its sweep.
  int help(const std::string& text);

 private:
  [[nodiscard]] project::Project read(std::vector<Issue>& issues) const;
  void plan(std::vector<Issue>& issues);
  bool prepare();
  bool read_aims(std::vector<Issue>& issues);
  bool read_shard();
  [[nodiscard]] std::string identity() const;
  [[nodiscard]] exports::StoredSweep stored() const;
  [[nodiscard]] Outcome<SweepStore> open_store() const;
  [[nodiscard]] std::string what_is_left(const SweepStore& store) const;
  [[nodiscard]] bool solve(SweepStore* store, project::SweepStatistics& found);
  [[nodiscard]] int tell(const project::SweepStatistics& found) const;
  template <class Found>
  [[nodiscard]] int tell_found(const char* title, const Found& found, std::vector<report::Block> blocks) const;
  [[nodiscard]] int refuse_all(const std::vector<Issue>& issues) const;
  [[nodiscard]] int choose() const;
  [[nodiscard]] int seek() const;
  [[nodiscard]] int ask_influence() const;
  [[nodiscard]] project::ReadAgain reading() const;
  [[nodiscard]] unsigned jobs() const;
  template <class Search>
  [[nodiscard]] auto searched(const Search& search) const;

  const SweepOptions& options_;
  std::string text_;
  project::Project project_;
  project::SweepPlan plan_;
  project::Keep keep_;
  project::BlockRange blocks_;
};

project::Project Sweeping::read(std::vector<Issue>& issues) const {
  project::Project project = read_set(text_, options_.file, options_.settings, issues, project::Ranges::taken);
  project.strict = options_.strict;
  return project;
}

/// "m:min,u:max": names of results, each with an aim.
bool Sweeping::read_aims(std::vector<Issue>& issues) {
  for (std::size_t from = 0; !options_.pareto.empty() && from <= options_.pareto.size();) {
    const std::size_t to = std::min(options_.pareto.find(',', from), options_.pareto.size());
    const std::string part = options_.pareto.substr(from, to - from);
    const std::size_t colon = part.rfind(':');
    const std::string name = part.substr(0, colon);
    const std::string aim = colon == std::string::npos ? "min" : part.substr(colon + 1);
    const auto column =
        std::find_if(plan_.columns.begin(), plan_.columns.end(), [&](const auto& c) { return c.name == name; });
    if (column == plan_.columns.end() || (aim != "min" && aim != "max")) {
      std::vector<std::string> names;
      for (const auto& c : plan_.columns) names.push_back(c.name);
      issues.push_back({{"--pareto", 0, 0, 1},
                        "",
                        aim == "min" || aim == "max" ? say("'{1}' is not one of the results", name)
                                                     : say("'{1}' is not an objective: min or max", aim),
                        names.empty() ? say("add it to the results: --results {1}", name) : there_is(names),
                        Severity::error});
      return false;
    }
    keep_.objectives.push_back(
        {static_cast<std::size_t>(column - plan_.columns.begin()), aim == "min" ? sweep::Aim::min : sweep::Aim::max});
    from = to + 1;
  }
  return true;
}

bool Sweeping::read_shard() {
  blocks_ = project::all_blocks(plan_);
  if (options_.shard.empty()) return true;
  const auto share = read_share(options_.shard, plan_);
  if (!share) return refuse(share.fault().message.text(), share.fault().hint.text()), false;
  blocks_ = *share;
  return true;
}

void Sweeping::plan(std::vector<Issue>& issues) {
  project_ = read(issues);
  take_points(options_.points, project_.sweep);
  for (const std::string& result : options_.results) project_.sweep.results.push_back({result, {"--results", 1, 1, 1}});
  if (!has_errors(issues)) plan_ = project::plan_sweep(project_, project_.sweep, issues);
  keep_.worst = options_.worst;
  if (options_.quantile > 0.0) keep_.quantile = options_.quantile;
  if (!has_errors(issues)) read_aims(issues);
}

bool Sweeping::prepare() {
  std::vector<Issue> issues;
  plan(issues);
  if (!options_.quiet || has_errors(issues)) {
    std::vector<terminal::SourceText> sources{
        {options_.file, text_}, {"--pareto", options_.pareto}, source_of(options_.settings)};
    for (const std::string& result : options_.results) sources.push_back({"--results", result});
    terminal::show_issues(issues, with_files_of(project_, sources));
  }
  return !has_errors(issues) && read_shard();
}

/// Everything that the numbers follow from, line by line, so that a difference can be located.
std::string Sweeping::identity() const {
  const project::SweepSettings& s = project_.sweep;
  std::string all = program() + "\n";
  const auto add = [&](const char* name, std::uint64_t number) {
    all += std::string(name) + " = " + std::to_string(number) + "\n";
  };
  add("samples", s.samples), add("seed", s.seed), add("latin", std::uint64_t{s.latin}), add("worst", keep_.worst);
  add("strict", std::uint64_t{options_.strict}), add("no-columns", std::uint64_t{options_.no_columns});
  all += "pareto = " + options_.pareto + "\n";
  all += "quantile = " + format_number(keep_.quantile, 17) + "\n";
  for (const auto& zip : s.zip) {
    all += "zip = ";
    for (const project::Placed& name : zip) all += name.text + ",";
    all += "\n";
  }
  for (const auto& column : plan_.columns) all += column.name + " = " + column.text + "\n";
  for (const std::string& setting : options_.settings) all += "set = " + setting + "\n";
  all += text_ + "\n";
  for (const project::NamedFile& file : project_.files) all += file.name + "\n" + file.text + "\n";
  return all;
}

exports::StoredSweep Sweeping::stored() const {
  return {program(),           fs::path(options_.file).filename().string(), identity(), project_.sweep.seed, blocks_,
          !options_.no_columns};
}

Outcome<SweepStore> Sweeping::open_store() const {
  const exports::StoredSweep stored = this->stored();
  const project::SweepStatistics none = project::nothing_found(plan_, project_, keep_);
  if (!options_.merge.empty())
    return SweepStore::merge({options_.merge.begin(), options_.merge.end()}, options_.out, plan_, stored, none);
  if (options_.resume) return SweepStore::resume(options_.out, plan_, stored, none);
  return SweepStore::create(options_.out, plan_, stored, none);
}

std::string Sweeping::what_is_left(const SweepStore& store) const {
  const std::uint64_t first = store.left().first * project::block_size;
  const std::uint64_t last = std::min(store.left().last * project::block_size, plan_.space.count()) - 1;
  return "stopped at " + std::to_string(store.found().points()) + " points; " + std::to_string(first) + " to " +
         std::to_string(last) + " are missing: loadpath sweep " + options_.file + " --out " + options_.out +
         " --resume goes on, with the same options\n";
}

/// False if an output cannot be written, which is reported, or the user has stopped it.
bool Sweeping::solve(SweepStore* store, project::SweepStatistics& found) {
  const std::chrono::duration<double> between(options_.save_every);
  Scratch scratch(store != nullptr && is_waited_for() ? &interrupted_by_user
                                                      : nullptr);  // a folder keeps solved points
  PointFiles files(options_, plan_, scratch);
  if (!files.open(stored())) return false;
  const project::BlockRange blocks = store != nullptr ? store->left() : blocks_;
  const bool rows = files.any() || (store != nullptr && !options_.no_columns);
  const project::SweepWork work{plan_, reading(), keep_, blocks, jobs(), rows, &interrupted_by_user};
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
  const std::string unsolved =
      solve_parts(work, {text_, identity()}, {take, [&](const std::string& late) { progress.wait_for(late); }});
  progress.end();
  if (!unsolved.empty()) return refuse(unsolved), false;
  if (store != nullptr && whole) {
    if (const Message wrong = store->save(); !wrong.empty()) return refuse(wrong.text()), false;
  }
  return whole && (interrupted_by_user || files.finish());
}

int Sweeping::tell(const project::SweepStatistics& found) const {
  report::DrawnPoints drawn;
  if (!options_.reports.empty()) drawn = report::points_to_draw(plan_, found, blocks_, reading());
  const report::Document document = report::sweep_document(project_, plan_, found, program(), drawn);
  if (!write_reports(document, options_.reports, project_, options_.quiet)) return wrong_input;
  if (options_.json) {
    std::cout << exports::json_of(project_, plan_, found, program());
  } else if (!options_.quiet) {
    const bool compares = plan_.space.count() > plan_.space.samples();
    terminal::show_tables(options_.full || !compares ? document.blocks : report::sweep_answer(project_, plan_, found));
    const std::string file = options_.file == "-" ? "FILE" : options_.file;
    if (!found.worst().empty())
      std::cout << "\none point as a design: loadpath run " << file << " --point " << found.worst().front().index
                << "\n";
  }
  const auto headline = project::headline_of(plan_, found);
  return headline ? exit_for(*headline) : int{passed};
}

project::ReadAgain Sweeping::reading() const {
  return [this] {
    std::vector<Issue> told;
    return read(told);
  };
}

unsigned Sweeping::jobs() const {
  return options_.jobs != 0 ? options_.jobs : std::max(1U, std::thread::hardware_concurrency());
}

/// What a search finds with the threads of this command, while its progress is shown.
template <class Search>
auto Sweeping::searched(const Search& search) const {
  Progress progress(0, !options_.quiet);
  auto found = search(project::Searching{reading(), jobs(), [&](std::uint64_t points) { progress.show(points); }});
  progress.end();
  return found;
}

int Sweeping::refuse_all(const std::vector<Issue>& issues) const {
  std::vector<terminal::SourceText> sources{{options_.file, text_},
                                            source_of(options_.settings),
                                            {"--minimise", options_.minimise},
                                            {"--maximise", options_.maximise},
                                            {"--seek", options_.seek}};
  for (const std::string& demand : options_.such_that) sources.push_back({"--such-that", demand});
  terminal::show_issues(issues, sources);
  return wrong_input;
}

/// Prints what was found other than by a sweep over all points.
template <class Found>
int Sweeping::tell_found(const char* title, const Found& found, std::vector<report::Block> blocks) const {
  if (options_.json)
    std::cout << exports::json_of(project_, found);
  else if (!options_.quiet)
    terminal::show_tables(blocks);
  if (options_.reports.empty()) return passed;
  report::Document document;
  document.title = project_.title.empty() ? project_.file : project_.title;
  document.meta.emplace_back(say("Project file"), project_.file);
  if (!options_.settings.empty()) document.meta.emplace_back(say("set"), told(options_.settings));
  document.program = program();
  document.meta.emplace_back(say("Program"), document.program);
  blocks.insert(blocks.begin(), report::Heading{2, title, "sweep"});
  document.blocks = std::move(blocks);
  return write_reports(document, options_.reports, project_, options_.quiet) ? passed : wrong_input;
}

int Sweeping::choose() const {
  const bool most = !options_.maximise.empty();
  project::BestAsked asked;
  asked.objective = {most ? options_.maximise : options_.minimise, {most ? "--maximise" : "--minimise", 1, 1, 1}};
  asked.maximise = most;
  for (const std::string& demand : options_.such_that) asked.such_that.push_back({demand, {"--such-that", 1, 1, 1}});
  if (options_.quantile > 0.0) asked.quantile = options_.quantile;
  for (const project::SweptResult& column : plan_.columns) asked.results.emplace_back(column.name, column.text);
  std::vector<Issue> issues;
  const auto best = searched([&](const auto& how) {
    return project::find_best(how, asked, project_.sweep.samples, project_.sweep.seed, issues);
  });
  if (!best) return refuse_all(issues);
  const int code = tell_found("The best design", *best, report::best_blocks(*best));
  return code == passed && !best->optimum.allowed ? int{not_passed} : code;
}

int Sweeping::seek() const {
  std::vector<Issue> issues;
  const auto sought = searched([&](const auto& how) {
    return project::seek_value(how, {options_.seek, {"--seek", 1, 1, 1}}, issues);
  });
  if (!sought) return refuse_all(issues);
  const int code = tell_found("The value sought", *sought, report::seek_blocks(*sought));
  return code == passed && sought->sought.meetings.empty() ? int{not_passed} : code;
}

int Sweeping::ask_influence() const {
  std::vector<Issue> issues;
  const auto influence = searched(
      [&](const auto& how) { return project::find_influence(how, plan_, project_.sweep, options_.sobol, issues); });
  if (!influence) return refuse_all(issues);
  return tell_found("Sensitivity of the results", *influence, report::influence_blocks(*influence));
}

int Sweeping::help(const std::string& text) {
  text_ = text;
  std::vector<Issue> issues;
  plan(issues);
  const project::SweepWork work{plan_, reading(), keep_, {}, std::max(1U, options_.jobs)};
  const bool read = !has_errors(issues);
  return help_parts(work, read ? identity() : "", read ? "" : "finds errors in what the first rank has read without");
}

int Sweeping::run() {
  if (const std::string wrong = contradiction(options_); !wrong.empty()) return refuse(wrong);
  if (!options_.status.empty()) return tell_status(options_);
  OutputOptions reports;
  reports.reports = options_.reports;
  if (!can_write(reports) || !can_place(options_.csv) || !can_place(options_.hdf5)) return wrong_input;
  if (!options_.hdf5.empty() && fs::is_other(options_.hdf5))
    return refuse("'" + options_.hdf5 + "' is a device or a pipe, and HDF5 needs a file",
                  "name a file, or use --csv, which writes through pipes");
  if (takes_standard_output(reports)) return refuse("a report of a sweep is a file: --report FILE.html");
  if (!toml::read_file(options_.file, text_)) return refuse("cannot read '" + options_.file + "'");
  if (!prepare()) return wrong_input;
  std::vector<fs::path> outputs(options_.reports.begin(), options_.reports.end());
  if (!options_.csv.empty()) outputs.emplace_back(options_.csv);
  if (!options_.hdf5.empty()) outputs.emplace_back(options_.hdf5);
  if (overwrites(outputs, project_)) return wrong_input;
  if (!options_.minimise.empty() || !options_.maximise.empty()) return choose();
  if (!options_.seek.empty()) return seek();
  if (options_.influence || options_.sobol != 0) return ask_influence();
  std::vector<Issue> open;
  project::refuse_open_ranges(plan_, open);
  if (has_errors(open)) return refuse_all(open);
  if (plan_.inputs.empty() && !options_.quiet) tell_nothing_varies(options_.file);
  project::SweepStatistics found = project::nothing_found(plan_, project_, keep_);
  if (options_.out.empty()) {
    if (!solve(nullptr, found)) return wrong_input;
    return interrupted_by_user ? int{interrupted} : tell(found);
  }
  auto store = open_store();
  if (!store) return refuse(store.fault().message.text(), store.fault().hint.text());
  for (const fs::path& folder : store->left_out())
    if (!options_.quiet) std::cerr << "loadpath: left out, the points are in others: '" << folder.string() << "'\n";
  if (store->left().count() != 0) {
    if (!solve(&*store, found)) return wrong_input;
  } else if (const Message wrong = store->save(); !wrong.empty()) {  // written after the last state by a killed process
    return refuse(wrong.text());
  }
  if (store->left().count() == 0) return tell(store->found());
  std::cerr << what_is_left(*store);
  return interrupted;
}

}  // namespace

int sweep(const SweepOptions& options) {
  const std::string* const text = helped_text();
  return text != nullptr ? Sweeping(options).help(*text) : Sweeping(options).run();
}

}  // namespace loadpath::cli
