#include "tests/browser/browser.hpp"

#include "tests/cli/process.hpp"
#include "tests/waiting.hpp"

#include <doctest/doctest.h>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace loadpath::test {

namespace json = boost::json;
namespace fs = std::filesystem;

namespace {

/// The ends at which the browser reads commands and writes answers.
constexpr int reads_at = 3, writes_at = 4;

/// In the child; nothing comes back from here. Both pipes are moved out of the way first: they may be at 3 and 4.
[[noreturn]] void become(const std::vector<std::string>& words, int commands, int answers) {
  const int in = fcntl(commands, F_DUPFD, 10), out = fcntl(answers, F_DUPFD, 10);
  const int nothing = ::open("/dev/null", O_RDWR);
  if (dup2(in, reads_at) < 0 || dup2(out, writes_at) < 0) _exit(126);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

std::vector<std::string> words_of(const fs::path& profile) {
  std::vector<std::string> words{browser_there(),
                                 "--headless",
                                 "--remote-debugging-pipe",
                                 "--disable-gpu",
                                 "--disable-quic",
                                 "--no-first-run",
                                 "--disable-background-networking",
                                 "--disable-component-update",
                                 "--disable-sync",
                                 "--hide-scrollbars",
                                 "--user-data-dir=" + profile.string()};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // its sandbox refuses root
  return words;
}

}  // namespace

std::string browser_there() {
  const Ran found = Desk().shell("command -v chromium || command -v chromium-browser || command -v google-chrome");
  return found.out.substr(0, found.out.find('\n'));
}

Browser::Browser() {
  std::string pattern = (fs::temp_directory_path() / "loadpath-browser-XXXXXX").string();
  REQUIRE(mkdtemp(pattern.data()) != nullptr);
  profile_ = pattern;
  std::array<int, 2> commands{}, answers{};
  REQUIRE(pipe2(commands.data(), O_CLOEXEC) == 0);
  REQUIRE(pipe2(answers.data(), O_CLOEXEC) == 0);
  const auto words = words_of(profile_);
  child_ = fork();
  REQUIRE(child_ >= 0);
  if (child_ == 0) become(words, commands[0], answers[1]);
  close(commands[0]);
  close(answers[1]);
  to_ = commands[1];
  from_ = answers[0];
  const auto made = ask("Target.createTarget", {{"url", "about:blank"}}, false);
  const auto attached = ask("Target.attachToTarget", {{"targetId", made.at("targetId")}, {"flatten", true}}, false);
  session_ = attached.at("sessionId").as_string().c_str();
}

Browser::~Browser() {
  close(to_);
  close(from_);
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  std::error_code ignored;
  becomes([&] {  // its children may write for a moment more
    fs::remove_all(profile_, ignored);
    return !fs::exists(profile_, ignored);
  });
}

std::string Browser::read_message() {
  std::array<char, 65536> part{};
  std::size_t end = pending_.find('\0');
  while (end == std::string::npos) {
    const ssize_t got = read(from_, part.data(), part.size());
    REQUIRE_MESSAGE(got > 0, "the browser has ended");
    pending_.append(part.data(), static_cast<std::size_t>(got));
    end = pending_.find('\0');
  }
  const std::string message = pending_.substr(0, end);
  pending_.erase(0, end + 1);
  return message;
}

json::value Browser::ask(std::string_view method, json::object parameters, bool of_page) {
  json::object message{{"id", ++last_}, {"method", method}, {"params", std::move(parameters)}};
  if (of_page) message["sessionId"] = session_;
  const std::string text = json::serialize(message) + '\0';
  REQUIRE(write(to_, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  for (;;) {
    const json::value answer = json::parse(read_message());
    const json::value* const id = answer.as_object().if_contains("id");  // events have none
    if (id == nullptr || id->as_int64() != last_) continue;
    REQUIRE_MESSAGE(!answer.as_object().contains("error"), json::serialize(answer));
    return answer.at("result");
  }
}

void Browser::look(int width, int height, bool dark) {
  ask("Emulation.setDeviceMetricsOverride",
      {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < 600}});
  json::object scheme{{"name", "prefers-color-scheme"}, {"value", dark ? "dark" : "light"}};
  ask("Emulation.setEmulatedMedia", {{"media", "screen"}, {"features", json::array{scheme}}});
}

void Browser::look_as_print(int width) {
  look(width, 1000);
  ask("Emulation.setEmulatedMedia", {{"media", "print"}});
}

void Browser::open(const std::string& address) {
  ask("Page.navigate", {{"url", address}});
  REQUIRE(becomes_true("document.readyState === 'complete' && location.href !== 'about:blank'"));
  value("document.fonts.ready.then(() => 0)");
}

json::value Browser::value(const std::string& expression) {
  const auto answer =
      ask("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  REQUIRE_MESSAGE(!answer.as_object().contains("exceptionDetails"), json::serialize(answer));
  const json::value* const value = answer.at("result").as_object().if_contains("value");
  return value == nullptr ? json::value() : *value;
}

bool Browser::becomes_true(const std::string& expression) {
  return becomes([&] {
    const json::value now = value(expression);
    return now.is_bool() && now.as_bool();
  });
}

}  // namespace loadpath::test
