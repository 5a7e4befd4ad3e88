// Solving of the parts of a sweep: by the threads of one process (threads.cpp), or by the ranks of MPI in the program
// loadpath-mpi (cli/mpi). The commands are the same in both; linking decides between the two.
#pragma once

#include "lib/project/sweep/sweep.hpp"

#include <functional>
#include <string>

namespace loadpath::cli {

/// The data common to all ranks.
struct SharedSweep {
  std::string text;      // text of the project file, which one rank has read
  std::string identity;  // everything that the numbers follow from
};

struct Listener {
  std::function<bool(project::SweptPart&& part)> take;         // in the order of the points; false ends the work
  std::function<void(const std::string& late)> wait_for_late;  // all is done but for these points, of this rank
};

/// Solves the blocks. Empty, or why that is not possible.
std::string solve_parts(const project::SweepWork& work, const SharedSweep& shared, const Listener& listener);

/// The body of main(): `run` gives the exit code. A helping rank runs it for every sweep that it helps with, others
/// not.
int run_program(const std::function<int()>& run);

/// Whether the sender of SIGTERM gives time to end; mpirun kills immediately after it.
bool is_waited_for();

/// The sweep that this rank helps with; null for the one that reads, writes and prints.
const std::string* helped_text();

/// On a helping rank: solves parts until there are no more. `wrong`: the reason why it cannot.
int help_parts(const project::SweepWork& work, const std::string& identity, const std::string& wrong);

}  // namespace loadpath::cli
