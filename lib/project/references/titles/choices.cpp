// Supports, kinds of loading and axes that the title of a step states otherwise than its inputs.
#include "lib/project/references/origins.hpp"
#include "lib/project/references/titles/titles.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

namespace loadpath::project {

namespace {

/// Words of a title, and what a choice cannot be with them.
struct Statement {
  const char* input;   // "ends"
  const char* choice;  // "fixed_fixed"
  std::array<const char*, 8> words;
  std::array<const char*, 4> unless = {};  // words with which the choice may be right
};

constexpr std::array statements{
    Statement{"ends",
              "fixed_fixed",
              {"pin", "pins", "pinned", "hinge", "hinges", "hinged", "eyes"},
              {"fixed", "clamped", "welded", "built-in"}},
    Statement{"ends", "fixed_fixed", {"sway", "cantilever", "free end", "free head", "head free", "end free"}},
    Statement{"ends", "fixed_pinned", {"sway", "cantilever", "free end", "free head", "head free", "end free"}},
    Statement{"ends", "pinned_pinned", {"sway", "cantilever", "free end", "free head", "head free", "end free"}},
    Statement{"held", "in_fork", {"one side", "single shear", "overhung", "cantilever"}},
    Statement{"held", "in_eye", {"one side", "single shear", "overhung", "cantilever"}},
    Statement{"loading",
              "steady",
              {"a day", "per day", "an hour", "per hour", "a minute", "per minute", "strokes", "pulsating"},
              {"day shift"}},
    Statement{"loading", "steady", {"alternating", "reversing", "reversed", "cyclic", "fluctuating", "every stroke"}},
    Statement{"loading", "pulsating", {"alternating", "reversing", "reversed"}}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Whether the words occur in a text in small letters, between characters that are no letters.
bool has_words(std::string_view text, std::string_view words) {
  for (std::size_t at = text.find(words); at != std::string_view::npos; at = text.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end]))) return true;
  }
  return false;
}

template <std::size_t most>
const char* first_of(const std::array<const char*, most>& all, std::string_view text) {
  for (const char* const words : all)
    if (words != nullptr && has_words(text, words)) return words;
  return nullptr;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::vector<ReducedLoad> titles_of_other_choices(const Step& step, const Project& project) {
  std::vector<ReducedLoad> found;
  const std::string title = in_small_letters(step.input().title);
  const auto& typed = step.input().reading.typed;
  for (const Statement& one : statements) {
    const auto input = typed.find(one.input);
    if (input == typed.end() || input->second.text != one.choice) continue;
    const char* const words = first_of(one.words, title);
    if (words == nullptr || first_of(one.unless, title) != nullptr) continue;
    found.push_back({one.input, say("its title says \"{1}\", and {2} is {3}: correct one of them, or justify it: "
                                    "because.{2} = \"...\"",
                                    words, one.input, one.choice)});
  }
  const bool is_about_weak = has_words(title, "weak axis") || has_words(title, "minor axis");
  if (is_about_weak && find_field(step.input().calculator->input->fields, "M_z") != nullptr &&
      std::abs(own_value(step, project, "M_y")) > 0.0 && !(std::abs(own_value(step, project, "M_z")) > 0.0))
    found.push_back({"M_y", say("its title says that it bends about the weak axis, z, and M_y is about the strong one: "
                                "give M_z, or justify it: because.M_y = \"...\"")});
  return found;
}

}  // namespace loadpath::project
