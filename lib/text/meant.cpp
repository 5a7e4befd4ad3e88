#include "lib/text/meant.hpp"

#include "lib/text/search.hpp"
#include "lib/text/utf8.hpp"

#include <algorithm>

namespace loadpath {

namespace {

constexpr std::size_t most = 3;       // words that are offered
constexpr std::size_t most_told = 6;  // words of a list with their meanings
constexpr std::size_t shortest_clause = 12;
constexpr std::size_t long_meaning = 60;  // characters: longer ones lose what follows their first clause

std::string first_clause(const std::string& meaning) {
  if (code_points(meaning).size() <= long_meaning) return meaning;
  const std::size_t colon = meaning.find(": ", shortest_clause);  // not of "open: the slider is ahead"
  return meaning.substr(0, std::min({colon, meaning.find("; "), meaning.find(" ("), meaning.find(", ")}));
}

std::string with_meaning(const std::string& word, const Known& known) {
  return known.meaning.empty() ? word : word + " (" + first_clause(known.meaning) + ")";
}

bool begins_alike(std::string_view longer, std::string_view word) {
  return !word.empty() && longer.size() > word.size() && longer.starts_with(word) &&
         (word.size() >= 3 || longer[word.size()] == '_');
}

/// Those whose meaning has the word: "diameter".
std::vector<const Known*> by_meaning(std::string_view word, const std::vector<Known>& known) {
  std::vector<const Known*> found;
  const auto searched = search_words(word);
  if (word.size() < 4) return found;
  for (const Known& one : known) {
    if (match(searched, search_words(first_clause(one.meaning))) <= Match::words) found.push_back(&one);
  }
  return found;
}

}  // namespace

Message meant(std::string_view word, const std::vector<Known>& known, Message otherwise, const std::string& prefix) {
  std::vector<std::string> words;
  words.reserve(known.size());
  for (const Known& one : known) words.push_back(one.word);
  const auto near = all_nearest(word, words);
  std::vector<const Known*> found;
  const auto add = [&](const Known& one) {
    if (found.size() < most && std::find(found.begin(), found.end(), &one) == found.end()) found.push_back(&one);
  };
  for (const std::string& name : near)
    add(*std::find_if(known.begin(), known.end(), [&](const Known& one) { return one.word == name; }));
  for (const Known& one : known) {
    if (begins_alike(one.word, word)) add(one);
  }
  if (found.empty()) {
    for (const Known* one : by_meaning(word, known)) add(*one);
  }
  if (found.empty()) return otherwise;
  std::string all;
  for (std::size_t i = 0; i < found.size(); ++i)
    all += (i == 0                  ? ""
            : i + 1 == found.size() ? " or "
                                    : ", ") +
           with_meaning("'" + prefix + found[i]->word + "'", *found[i]);
  return say("did you mean {1}?", all);
}

Message there_is(const std::vector<Known>& known) {
  std::string all;
  const bool with_meanings = known.size() <= most_told;
  for (const Known& one : known)
    all += (all.empty() ? "" : ", ") + (with_meanings ? with_meaning(one.word, one) : one.word);
  return say("available: {1}", all);
}

}  // namespace loadpath
