// The page in the browser while a project is edited.
#pragma once

#include <cstdint>
#include <string>

namespace loadpath::cli {

/// The project as it was last read.
struct Revision {
  std::uint64_t number = 0;
  std::string page;     // the report of the last one that could be solved; empty before
  std::string problem;  // issues with their places; empty if it was solved
};

/// The page of a revision, with the script that keeps it up to date.
std::string live_page(const Revision& revision);

/// The event for the script about a revision: "7 solved", "8 problem".
std::string news_of(const Revision& revision);

}  // namespace loadpath::cli
