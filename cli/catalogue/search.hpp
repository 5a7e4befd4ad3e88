// Calculators by the words of their field: in ids, titles, synonyms, machines, scopes and failure modes, in any case,
// in English, German and Russian.
#pragma once

#include "lib/calculator/calculator.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::cli {

/// A calculator or a template that a search has found.
struct Hit {
  const Calculator* calculator = nullptr;
  std::string id;  // id of the template, if it is one
  std::string title;
  std::string why;           // "Keilriemen", "failure mode: flexural buckling"; empty where the title or the id says it
  const char* where;         // "id", "title", "synonym", "scope", "failure mode"
  int rank = 0;              // the best first, from 0
  std::size_t position = 0;  // of the synonym that was found; those of one rank in this order
};

/// The results of a search, the best first.
struct Found {
  std::vector<Hit> named;      // by id, title or synonym
  std::vector<Hit> mentioned;  // by scope or failure mode only
};

/// All that hold every word of the text.
Found search(std::string_view text);

/// The words without those for work on a subject, "design", "calculation"; all of them if nothing else remains.
std::vector<std::u32string> subject_of(std::vector<std::u32string> words);

/// The word of the catalogue that the text is nearest to; empty where none is near.
std::string nearest_term(std::string_view text);

}  // namespace loadpath::cli
