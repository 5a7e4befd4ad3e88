#include "lib/report/terminal/words.hpp"

#include "lib/account/conclusion.hpp"

#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace loadpath::terminal {

bool colours(Stream stream) {
  static const bool wanted = std::getenv("NO_COLOR") == nullptr;
  return wanted && isatty(stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO) != 0;
}

namespace {

std::string in_colour(const std::string& text, const char* code) {
  return colours(Stream::out) ? "\033[" + std::string(code) + "m" + text + "\033[0m" : text;
}

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

void show_headline(const account::Modes& modes) {
  const auto headline = account::conclude(modes).headline;
  const std::string words = account::explanation(modes).text();
  std::cout << in_colour(account::word(headline), colour_of(headline))
            << (headline == account::Headline::pass ? " (" + words + ")" : "  " + words) << "\n";
}

}  // namespace loadpath::terminal
