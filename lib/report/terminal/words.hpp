// Words for how things came out, coloured where someone looks.
#pragma once

#include "lib/account/account.hpp"

#include <string>

namespace loadpath::terminal {

/// Whether text on this stream may be coloured: a terminal, and NO_COLOR is not set.
enum class Stream { out, error };
bool colours(Stream stream);

/// One coloured word for a state: "pass", "FAIL".
std::string state_word(account::State state);
/// The same of a mode: "outside the scope" where no calculator assesses it.
std::string mode_word(const account::Mode& mode);
/// The verdict in one line of at most `width` characters; `subject`: what the modes of the only step cover.
std::string headline(const account::Modes& modes, const std::string& subject, std::size_t width);
/// A text in a colour of ECMA-48, "33;1", where someone looks.
std::string in_colour(const std::string& text, const char* code);

}  // namespace loadpath::terminal
