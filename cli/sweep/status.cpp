#include "cli/sweep/status.hpp"

#include "lib/export/sweep/status.hpp"

#include <iostream>

namespace loadpath::cli {

namespace {

using exports::FolderStatus;

/// "3 to 17", "3", "none".
std::string range_of(std::uint64_t from, std::uint64_t end) {
  if (from == end) return "none";
  return std::to_string(from) + (end - from == 1 ? "" : " to " + std::to_string(end - 1));
}

void show(const FolderStatus& status, const SweepOptions& options) {
  const std::uint64_t solved = status.first + status.solved;
  std::cout << "project  " << status.project << "\n"
            << "points   " << range_of(status.first, status.end) << " of " << status.points << "\n"
            << "solved   " << range_of(status.first, solved) << "\n"
            << "missing  " << range_of(solved, status.end) << "\n";
  if (!status.at_work.empty()) {
    std::cout << "at work  " << status.at_work.text() << "\n";
  } else if (!status.is_done()) {
    const std::string shard =
        status.is_share() ? " --shard " + std::to_string(status.first) + "-" + std::to_string(status.end - 1) : "";
    std::cout << "go on    loadpath sweep " << status.project << " --out " << options.status << shard
              << " --resume, with the same options\n";
  }
}

}  // namespace

int print_status(const SweepOptions& options) {
  const auto status = exports::status_of(options.status);
  if (!status) {
    std::cerr << "loadpath: " << status.fault().message.text() << "\n";
    if (!status.fault().hint.empty()) std::cerr << "  = help: " << status.fault().hint.text() << "\n";
    return wrong_input;
  }
  if (options.json)
    std::cout << exports::json_of(*status);
  else if (!options.quiet)
    show(*status, options);
  return status->is_done() ? passed : not_passed;
}

}  // namespace loadpath::cli
