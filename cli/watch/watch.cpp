#include "calculators/catalogue.hpp"
#include "cli/commands.hpp"
#include "cli/inputs/missing_file.hpp"
#include "cli/solving.hpp"
#include "cli/watch/opening.hpp"
#include "cli/watch/server.hpp"
#include "cli/watch/watched.hpp"
#include "lib/project/solving/read_project.hpp"
#include "lib/project/solving/solve.hpp"
#include "lib/report/build/build.hpp"
#include "lib/report/conclusion.hpp"

#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>

#include <chrono>
#include <csignal>
#include <iostream>

namespace loadpath::cli {

namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds between_looks{100};

/// A project that is solved whenever it is saved.
class Watch {
 public:
  explicit Watch(const WatchOptions& options) : options_(options), server_(context_, options.port) {}

  int run() {
    asio::signal_set ends(context_, SIGINT, SIGTERM, SIGHUP);
    ends.async_wait([this](const boost::system::error_code&, int) { context_.stop(); });
    std::cout << "report: " << server_.address() << "\n" << std::flush;
    solve();
    if (options_.open && !open_page(server_.address()))
      std::cerr << "loadpath: no program is there that opens a page: open the address above\n";
    look_later();
    context_.run();
    return passed;
  }

 private:
  void look_later() {
    timer_.expires_after(between_looks);
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error) return;
      if (files_.have_changed()) solve();
      look_later();
    });
  }

  void solve() {
    ++revision_.number;
    revision_.problem.clear();
    const ReadFile file = read_watched(options_.file);
    if (file.is_there) {
      solve(file);
    } else {
      files_.watch({file});
      revision_.problem = "cannot read '" + options_.file + "'\n";
      std::cerr << "loadpath: " << revision_.problem << std::flush;
      print_unsolved();
    }
    server_.publish(revision_);
  }

  void solve(const ReadFile& file) {
    std::vector<Issue> issues;
    project::Project project = project::read_project(file.text, file.path, catalogue(), issues);
    project.strict = options_.strict;
    if (!has_errors(issues)) project::solve(project, issues);
    const auto sources = with_files_of(project, {{file.path, file.text}});
    terminal::show_issues(issues, sources);
    watch_files(file, project);
    if (has_errors(issues)) {
      revision_.problem = terminal::issues_text(issues, sources);
      return print_unsolved();
    }
    const report::Document document = report::build(project, program(), report::Detail::normal, file.text);
    revision_.page = report::html(document);
    std::cout << revision_.number << ": " << report::tally(document.summary).text() << "\n" << std::flush;
  }

  void print_unsolved() const {
    std::cout << revision_.number << ": cannot be solved; the page shows the last that could\n" << std::flush;
  }

  void watch_files(const ReadFile& file, const project::Project& project) {
    std::vector<ReadFile> files{file};
    for (const project::NamedFile& named : project.files) files.push_back({named.name, named.text, true});
    files_.watch(std::move(files));
  }

  const WatchOptions& options_;
  asio::io_context context_{1};
  asio::steady_timer timer_{context_};
  Server server_;
  WatchedFiles files_;
  Revision revision_;
};

int refuse(const std::string& what, const std::string& help) {
  std::cerr << "loadpath: " << what << "\n  = help: " << help << "\n";
  return wrong_input;
}

}  // namespace

int watch(const WatchOptions& options) {
  if (options.file == "-") return refuse("standard input cannot be watched", "name a file");
  if (!read_watched(options.file).is_there)
    return refuse("cannot read '" + options.file + "'", help_for_file(options.file));
  try {
    return Watch(options).run();
  } catch (const boost::system::system_error& error) {
    return refuse("cannot listen at port " + std::to_string(options.port) + ": " + error.code().message(),
                  "leave out --port: then a free one is taken");
  }
}

}  // namespace loadpath::cli
