// However the program is ended while it writes, every output is the old file or a complete new one.
#include "tests/cli/process.hpp"
#include "tests/parts.hpp"
#include "tests/program.hpp"
#include "tests/tries.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <map>
#include <poll.h>
#include <random>
#include <spawn.h>
#include <string>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace loadpath::test;

namespace {

const std::string press =
    "[press]\ncalculator = \"mechanism.planar\"\ntemplate = \"slider_crank\"\nr = \"50 mm\"\nl = \"200 mm\"\n"
    "crank = { speed = \"300 rpm\", positions = 12 }\n";
const std::string old_text = "what stood here before\n";
const std::map<std::string, std::string> endings{{"a.html", "</html>\n"}, {"a.csv", "\n"}};

/// Detects when a file comes into being in the folder.
class Watch {
 public:
  explicit Watch(const std::filesystem::path& folder) : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    REQUIRE(inotify_add_watch(queue_, folder.c_str(), IN_CREATE) >= 0);
  }
  ~Watch() { close(queue_); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  void wait(int milliseconds) const {
    pollfd event{queue_, POLLIN, 0};
    poll(&event, 1, milliseconds);
  }

 private:
  int queue_;
};

pid_t start_writing(const Desk& desk) {
  const auto in_folder = [&](const char* name) { return (desk.folder() / name).string(); };
  const std::string project = in_folder("a.toml"), html = in_folder("a.html"), csv = in_folder("a.csv");
  const std::array words{program,   "run",       project.c_str(),
                         "--quiet", "--report",  html.c_str(),
                         "--csv",   csv.c_str(), static_cast<const char*>(nullptr)};
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, words[0], nullptr, nullptr, const_cast<char**>(words.data()), environ) == 0);
  return child;
}

/// Starts the program over old outputs and ends it at a moment between its first byte written and its last.
void end_while_writing(const Desk& desk, int signal, std::chrono::microseconds after) {
  for (const auto& output : endings) desk.put(output.first, old_text);
  const Watch watch(desk.folder());
  const pid_t child = start_writing(desk);
  watch.wait(2000);
  std::this_thread::sleep_for(after);
  kill(child, signal);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  const bool finished = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  REQUIRE((finished || WIFSIGNALED(status) || WEXITSTATUS(status) == 130));
}

void check_outputs(const Desk& desk) {
  for (const auto& output : endings) {
    const std::string text = desk.get(output.first);
    CAPTURE(output.first);
    CHECK((text == old_text || (text.size() > old_text.size() && text.ends_with(output.second))));
  }
}

/// Whether there is an incomplete file.
bool has_parts(const Desk& desk) {
  const std::vector<std::string> files = desk.files();
  return std::any_of(files.begin(), files.end(), [](const std::string& name) { return name.ends_with(".part"); });
}

using Clock = std::chrono::steady_clock;

/// How many outputs are new.
std::size_t renewed(const Desk& desk) {
  return static_cast<std::size_t>(std::count_if(
      endings.begin(), endings.end(), [&](const auto& output) { return desk.get(output.first) != old_text; }));
}

/// How long a run writes, from its first file to the last output: the shortest of a few, and some more. What the
/// program does before it ends, and a sanitizer takes longest for, is not writing.
std::chrono::microseconds writing_time(const Desk& desk) {
  Clock::duration shortest = std::chrono::seconds(1);
  for (int k = 0; k < 5; ++k) {
    for (const auto& output : endings) desk.put(output.first, old_text);
    const Watch watch(desk.folder());
    const pid_t child = start_writing(desk);
    watch.wait(2000);
    const Clock::time_point started = Clock::now();
    int status = 0;
    pid_t ended = 0;
    while (renewed(desk) < endings.size() && ended == 0) ended = waitpid(child, &status, WNOHANG);
    shortest = std::min(shortest, Clock::now() - started);
    if (ended == 0) ended = waitpid(child, &status, 0);
    REQUIRE(ended == child);
  }
  return std::chrono::duration_cast<std::chrono::microseconds>(shortest * 5 / 4);
}

}  // namespace

TEST_SUITE("cli crashes" * by_case * takes_share) {
  TEST_CASE("kills during writing lose no old file, and the next run removes what they left") {
    const Desk desk;
    std::mt19937 random(11);
    desk.put("a.toml", press);
    std::chrono::microseconds whole = writing_time(desk);
    std::array<int, 3> ended{};  // with so many new outputs
    const int kills = tries(500, sanitized ? 50 : 10);
    for (int k = 0; k < kills; ++k) {
      end_while_writing(desk, SIGKILL, whole * (random() % 1000) / 1000);
      check_outputs(desk);
      const std::size_t new_outputs = renewed(desk);
      ++ended.at(new_outputs);
      // The moments follow the load of the machine: later where nothing was written yet, earlier where everything was.
      whole = whole * (new_outputs == 0 ? 11 : new_outputs + 1 == ended.size() ? 9 : 10) / 10;
    }
    CHECK(ended.front() < kills);  // the moments are those of writing: some before the first output, some after
    CHECK(ended.back() < kills);
    int status = 0;
    waitpid(start_writing(desk), &status, 0);
    CHECK_FALSE(has_parts(desk));
  }

  TEST_CASE("interrupts during writing lose no old file and leave no other files") {
    const Desk desk;
    std::mt19937 random(12);
    desk.put("a.toml", press);
    const std::chrono::microseconds whole = writing_time(desk);
    constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
    for (std::size_t k = 0; k < static_cast<std::size_t>(tries(300, sanitized ? 30 : 10)); ++k) {
      end_while_writing(desk, signals.at(k % signals.size()), whole * (random() % 1000) / 1000);
      check_outputs(desk);
      REQUIRE_FALSE(has_parts(desk));
    }
  }
}
