#include "cli/sweep/progress.hpp"

#include "lib/quantity/format.hpp"
#include "lib/report/terminal/terminal.hpp"

#include <iostream>
#include <string>
#include <unistd.h>

namespace loadpath::cli {

namespace {

/// The remaining time: "42 s", "3 min", "2.5 h".
std::string in_words(double seconds) {
  if (seconds < 120.0) return format_number(seconds, 2) + " s";
  if (seconds < 7200.0) return format_number(seconds / 60.0, 2) + " min";
  return format_number(seconds / 3600.0, 3) + " h";
}

}  // namespace

Progress::Progress(std::uint64_t total, bool wanted)
    : total_(total),
      wanted_(wanted),
      shown_(wanted && ::isatty(STDERR_FILENO) != 0),
      begun_(Clock::now()),
      last_(begun_) {}

void Progress::show(std::uint64_t done) {
  constexpr std::chrono::milliseconds between{200};
  const auto now = Clock::now();
  if (!shown_ || now - last_ < between || done == 0) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - begun_).count();
  const std::string rate = format_number(static_cast<double>(done) / seconds, 3) + " points a second";
  if (total_ == 0) {
    std::cerr << "\r" << done << " points, " << rate << "\033[K" << std::flush;
    return;
  }
  const double share = static_cast<double>(done) / static_cast<double>(total_);
  std::cerr << "\r" << format_number(100.0 * share, 3) << " %, " << rate << ", "
            << in_words(seconds * (1.0 - share) / share) << " left\033[K" << std::flush;
}

void Progress::wait_for(const std::string& late) {
  if (shown_)
    std::cerr << "\rwaits for " << late << "\033[K" << std::flush;
  else if (wanted_)
    std::cerr << "loadpath: waits for " << late << std::endl;
}

void Progress::end() {
  if (shown_) std::cerr << "\r\033[K" << std::flush;
}

}  // namespace loadpath::cli
