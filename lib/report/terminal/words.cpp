#include "lib/report/terminal/words.hpp"

#include "lib/account/conclusion.hpp"

#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace loadpath::terminal {

bool colours(Stream stream) {
  static const bool wanted = [] {
    const char* const term = std::getenv("TERM");
    return std::getenv("NO_COLOR") == nullptr && (term == nullptr || std::string_view(term) != "dumb");
  }();
  return wanted && isatty(stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO) != 0;
}

std::string in_colour(const std::string& text, const char* code) {
  return colours(Stream::out) ? "\033[" + std::string(code) + "m" + text + "\033[0m" : text;
}

namespace {

std::string coloured(account::State state, const std::string& words) {
  if (state == account::State::fail) return in_colour("FAIL", "31;1");
  return in_colour(words, state == account::State::pass ? "32" : "33");
}

const char* colour_of(account::Headline headline) {
  switch (headline) {
    case account::Headline::pass:
      return "32;1";
    case account::Headline::incomplete:
      return "33;1";
    default:
      return "31;1";
  }
}

}  // namespace

std::string state_word(account::State state) { return coloured(state, account::shown(state).text()); }

std::string mode_word(const account::Mode& mode) { return coloured(mode.state, account::shown(mode).text()); }

std::string headline(const account::Modes& modes, const std::string& subject, std::size_t width) {
  const auto headline = account::conclude(modes).headline;
  const std::string word = account::word(headline);
  const bool passes = headline == account::Headline::pass;
  const std::size_t used = word.size() + (passes ? 3 : 2);
  const std::string words = account::explanation(modes, {.room = width - used, .subject = subject}).text();
  return in_colour(word, colour_of(headline)) + (passes ? " (" + words + ")" : "  " + words) + "\n";
}

}  // namespace loadpath::terminal
