// The ends of the tokens of an expression. Every function takes the text and the byte at which a token may start and
// returns the byte after it; the same byte if no such token starts there.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace loadpath::expression {

/// Bare names that are references, and not units.
using Names = std::span<const std::string_view>;

bool is_among(Names names, std::string_view word);

std::size_t skip_space(std::string_view text, std::size_t at);

/// One character, all its bytes.
std::size_t character_end(std::string_view text, std::size_t at);

std::size_t digits_end(std::string_view text, std::size_t at);

/// `*` or `·`.
std::size_t times_end(std::string_view text, std::size_t at);

/// `-` or the minus sign of typeset text.
std::size_t minus_end(std::string_view text, std::size_t at);

/// A name: [A-Za-z_][A-Za-z0-9_]*.
std::size_t name_end(std::string_view text, std::size_t at);

/// A reference: names joined by dots, each with an index or without: shaft.segments[2].tau. It needs a dot.
std::size_t path_end(std::string_view text, std::size_t at);

/// A word of letters of any script, as units are written: mm, °, об.
std::size_t word_end(std::string_view text, std::size_t at);

/// The longest unit: words with exponents joined by * · /, up to a reference, a call, a number or pi. Several
/// divisors are in parentheses (`W/(m*K)`), a reciprocal may begin with 1 (`1/min`), a `^` after a word belongs to
/// it. `variables`: words that are not units.
std::size_t unit_end(std::string_view text, std::size_t at, Names variables = {});

}  // namespace loadpath::expression
