#include "cli/parts/parts.hpp"

namespace loadpath::cli {

std::string solve_parts(const project::SweepWork& work, const SharedSweep&, const Listener& listener) {
  project::solve(work, listener.take);
  return {};
}

int run_program(const std::function<int()>& run) { return run(); }

bool is_waited_for() { return true; }

const std::string* helped_text() { return nullptr; }

int help_parts(const project::SweepWork&, const std::string&, const std::string&) { return 0; }

}  // namespace loadpath::cli
