#include "lib/project/references/agreement/stated_names.hpp"

#include "lib/project/references/origins.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>

namespace loadpath::project {

namespace {

bool is_same_word(std::string_view word, std::string_view small) {
  return std::ranges::equal(
      word, small, {}, [](char c) { return std::tolower(static_cast<unsigned char>(c)); },
      [](char c) { return static_cast<int>(static_cast<unsigned char>(c)); });
}

bool is_same_word_in_any_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, {}, [](char c) { return std::tolower(static_cast<unsigned char>(c)); },
      [](char c) { return std::tolower(static_cast<unsigned char>(c)); });
}

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view other) { return is_same_word(word, other); });
}

/// How many words a name has between its underscores, and how many of them are among these, in either case.
struct Words {
  std::size_t all = 0, known = 0;
};

Words count_words(std::string_view name, std::initializer_list<std::string_view> words) {
  Words count;
  while (true) {
    const std::size_t end = name.find('_');
    ++count.all;
    if (is_among(name.substr(0, end), words)) ++count.known;
    if (end == std::string_view::npos) return count;
    name.remove_prefix(end + 1);
  }
}

}  // namespace

bool has_word(std::string_view name, std::initializer_list<std::string_view> words) {
  return count_words(name, words).known > 0;
}

bool has_only_words(std::string_view name, std::initializer_list<std::string_view> words) {
  const Words count = count_words(name, words);
  return count.known == count.all;
}

bool is_of_peak(std::string_view name) {
  return has_word(
      name, {"start", "starting", "max", "peak", "jam", "stall", "shock", "impact", "brake", "braking", "overload"});
}

namespace {

/// Whether the word occurs in a text between characters that are not letters.
bool has_text_word(std::string_view text, std::string_view word) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (is_same_word_in_any_case(text.substr(at, end - at), word)) return true;
    at = end + 1;
  }
  return false;
}

/// Whether an element of a list has this name: a seat, a pulley, a wheel.
bool names_row(const Step& step, std::string_view word) {
  const Record& record = step.input().reading.record;
  for (const FieldInfo& list : record.type->fields) {
    if (list.type != FieldInfo::Type::list) continue;
    for (std::size_t i = 0; i < list.size(record.data.get()); ++i) {
      if (has_text_word(element_path(list, record.data.get(), i), word)) return true;
    }
  }
  return false;
}

}  // namespace

bool is_named(const Step& step, std::string_view word) {
  return has_text_word(step.name(), word) || has_text_word(step.input().title, word) || names_row(step, word);
}

bool is_named(const Project& project, std::string_view word) {
  return has_text_word(project.title, word) ||
         std::ranges::any_of(project.steps, [&](const auto& step) { return is_named(*step, word); });
}

bool is_of_other_state(std::string_view name) {
  return has_word(
      name, {"idle",     "motor",  "mot",      "engine",   "adm",   "zul",     "allow",   "allowable", "perm",
             "lim",      "limit",  "capacity", "cap",      "rated", "rating",  "break",   "breaking",  "buckling",
             "cr",       "crit",   "critical", "fatigue",  "min",   "least",   "empty",   "own",       "dead",
             "ultimate", "u",      "rd",       "strength", "clamp", "frame",   "screws",  "bolts",     "foundation",
             "slip",     "clutch", "hold",     "holding",  "nom",   "nominal", "preload", "available", "main"});
}

bool is_of_machine(std::string_view name, const Project& project) {
  constexpr std::size_t fewest_letters = 3;  // of the word of a title
  if (name.find('_') == std::string_view::npos || is_of_other_state(name)) return false;
  const std::string_view last = name.substr(name.rfind('_') + 1);
  if (has_word(last,
               {"ed",      "sd",      "design", "total",     "tot",   "load", "machine",    "driven",   "work",
                "working", "service", "duty",   "operating", "blow",  "out",  "output",     "drum",     "fan",
                "pump",    "blower",  "mixer",  "winch",     "hoist", "saw",  "compressor", "conveyor", "spindle"}))
    return true;
  if (last.size() < fewest_letters) return false;
  return is_named(project, last);
}

double factors_included(std::string_view name, const Step& step, const Project& project) {
  if (!has_word(name, {"ed", "sd", "design"})) return 1.0;
  const double K_A = own_value(step, project, "K_A"), gamma_F = own_value(step, project, "gamma_F");
  return std::fmax(1.0, K_A) * std::fmax(1.0, gamma_F);
}

bool is_of_overspeed(std::string_view name) {
  return has_word(name, {"over", "overspeed", "trip", "runaway", "burst", "spin", "top", "fast"});
}

bool is_of_vacuum(std::string_view name) {
  if (has_word(name, {"vacuum", "vac"})) return true;
  return name.starts_with("p_") && has_word(name, {"ext", "external", "outside", "jacket"});
}

bool is_of_life(std::string_view name) {
  return has_word(name, {"life", "lifetime", "l", "hours"}) &&
         has_only_words(name, {"life",    "lifetime", "l",        "h",     "10h",     "hours", "service", "operating",
                               "running", "design",   "required", "req",   "target",  "total", "gear",    "gears",
                               "gearbox", "bearing",  "bearings", "drive", "machine", "min"});
}

ReducedLoad not_taken(const std::string& name, const std::string& stated, const std::string& key,
                      const std::string& here) {
  return {key, say("values.{1} = {2} acts on no step, and {3} is {4} here: refer to it, delete it, or justify it: "
                   "because.{3} = \"...\"",
                   name, stated, key, here)};
}

}  // namespace loadpath::project
