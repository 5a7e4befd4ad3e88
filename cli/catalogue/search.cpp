#include "cli/catalogue/search.hpp"

#include "calculators/catalogue.hpp"
#include "cli/catalogue/machines.hpp"
#include "lib/text/issue.hpp"
#include "lib/text/search.hpp"

#include <algorithm>
#include <array>

namespace loadpath::cli {

namespace {

using Words = std::vector<std::u32string>;

constexpr int nowhere = 1000, mentioned_from = 20;

/// The rank of a match, by where it is: in the order of Match.
using Ranks = std::array<int, 6>;
constexpr Ranks of_id{0, 1, 3, 6, 10, nowhere}, of_title{0, 2, 4, 7, 11, nowhere}, of_synonym{3, 4, 5, 8, 12, nowhere},
    of_scope{22, 22, 23, 25, nowhere, nowhere}, of_mode{20, 21, 22, 24, nowhere, nowhere};

struct Term {
  std::string text;
  Words words;
  const Ranks* ranks;
  const char* where;
  std::size_t position = 0;  // among the synonyms, of which the first are the closest
};

/// A calculator or a template with the texts that a search reads.
struct Searchable {
  const Calculator* calculator;
  std::string id;
  std::string title;
  std::vector<Term> terms;

  void add(std::string text, const Ranks& ranks, const char* where, std::size_t position = 0) {
    Words words = search_words(text);
    terms.push_back({std::move(text), std::move(words), &ranks, where, position});
  }
  void add_synonyms() {
    std::size_t position = 0;
    for (std::string& synonym : listed_keys(calculator->synonyms))
      add(std::move(synonym), of_synonym, "synonym", position++);
  }
  /// The names of the machines that it is a part of, in the order of the machine's parts.
  void add_machines() {
    for (const MachineWords& machine : machines()) {
      const std::vector<std::string> parts = listed_keys(machine.parts);
      const auto part = std::find(parts.begin(), parts.end(), id);
      if (part == parts.end()) continue;
      for (std::string& name : listed_keys(machine.words))
        add(std::move(name), of_synonym, "synonym", static_cast<std::size_t>(part - parts.begin()));
    }
  }
};

/// The parts of a scope that say what is covered: not those that say what is not.
std::vector<std::string> covered(std::string_view scope) {
  std::vector<std::string> pieces;
  while (!scope.empty()) {
    const std::string_view sentence = scope.substr(0, std::min(scope.find(". "), scope.size()));
    scope.remove_prefix(std::min(sentence.size() + 2, scope.size()));
    for (std::string_view rest = sentence; !rest.empty();) {
      const std::string_view part = rest.substr(0, std::min(rest.find("; "), rest.size()));
      if (part.starts_with("Not covered") || part.starts_with("not covered")) break;
      if (part.find("not covered") == std::string_view::npos && part.find("not included") == std::string_view::npos)
        pieces.emplace_back(part);
      rest.remove_prefix(std::min(part.size() + 2, rest.size()));
    }
  }
  return pieces;
}

std::vector<Searchable> searchables() {
  std::vector<Searchable> found;
  for (const Calculator* c : calculators()) {
    Searchable one{c, c->id, c->title, {}};
    const std::string id = c->id;
    one.add(id, of_id, "id");
    one.add(id.substr(id.find('.') + 1), of_id, "id");
    one.add(c->title, of_title, "title");
    one.add_machines();
    one.add_synonyms();
    for (std::string& part : covered(c->scope)) one.add(std::move(part), of_scope, "scope");
    for (const ModeInfo& mode : c->modes) {
      if (is_assessable(mode)) one.add(mode.title, of_mode, "failure mode");
    }
    found.push_back(std::move(one));
    for (const Template* t : c->templates) {
      Searchable made{c, id + "." + t->id, t->title, {}};
      made.add(t->id, of_id, "id");
      made.add(t->title, of_title, "title");
      found.push_back(std::move(made));
    }
  }
  return found;
}

struct Best {
  int rank = nowhere;
  const Term* term = nullptr;
};

Best best_of(const Words& searched, const Searchable& one) {
  Best best;
  for (const Term& term : one.terms) {
    const int rank = (*term.ranks)[static_cast<std::size_t>(match(searched, term.words))];
    if (rank < best.rank) best = {rank, &term};
  }
  return best;
}

/// By one text that holds all words; else by one for each, of which the worst counts.
Best rank_of(const Words& searched, const Searchable& one) {
  const Best together = best_of(searched, one);
  if (searched.size() < 2) return together;
  Best worst{0, nullptr};
  for (const std::u32string& word : searched) {
    const Best best = best_of({word}, one);
    if (best.term == nullptr) return together;
    if (best.rank >= worst.rank) worst = best;
  }
  const int apart = worst.rank < mentioned_from ? 15 : 30;  // behind those of one text
  if (worst.rank < nowhere) worst.rank = std::max(worst.rank, apart);
  return together.rank <= worst.rank ? together : worst;
}

/// Why it was found, where its id and title do not say so.
std::string reason(const Term& term) {
  const std::string where = term.where;
  if (where == "id" || where == "title") return "";
  return where == "synonym" ? term.text : where == "scope" ? "by its scope" : where + ": " + term.text;
}

/// Words that say nothing of what is searched for.
bool is_filler(const std::u32string& word) {
  static const std::array<std::u32string_view, 8> fillers{U"a", U"an", U"and", U"for", U"in", U"of", U"the", U"und"};
  return std::find(fillers.begin(), fillers.end(), word) != fillers.end();
}

/// Words for the work on a subject: "gearbox design" is about gearboxes.
bool is_of_work(const std::u32string& word) {
  static const std::array<std::u32string_view, 15> work{
      U"design",    U"designing",    U"calculation", U"calculate", U"calculator", U"sizing", U"size", U"sizes",
      U"selection", U"dimensioning", U"berechnung",  U"auslegung", U"расчет",     U"подбор", U"выбор"};
  return std::find(work.begin(), work.end(), word) != work.end();
}

}  // namespace

std::vector<std::u32string> subject_of(std::vector<std::u32string> words) {
  Words subject = words;
  std::erase_if(subject, is_of_work);
  return subject.empty() ? words : subject;
}

Found search(std::string_view text) {
  Words searched = search_words(text);
  if (searched.size() > 1) std::erase_if(searched, is_filler);
  const Words subject = subject_of(searched);
  std::vector<Hit> hits;
  for (const Searchable& one : searchables()) {
    const Best in_full = rank_of(searched, one), by_subject = rank_of(subject, one);
    const Best& best = by_subject.rank < in_full.rank ? by_subject : in_full;
    if (best.term != nullptr)
      hits.push_back(
          {one.calculator, one.id, one.title, reason(*best.term), best.term->where, best.rank, best.term->position});
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.rank != b.rank ? a.rank < b.rank : a.position < b.position;
  });
  Found found;
  for (Hit& hit : hits) (hit.rank < mentioned_from ? found.named : found.mentioned).push_back(std::move(hit));
  return found;
}

std::string nearest_term(std::string_view text) {
  std::vector<std::string> terms;
  const auto add_words = [&](const std::string& phrase) {
    for (std::size_t at = 0; at < phrase.size();) {
      const std::size_t end = std::min(phrase.find_first_of(" .,_-()", at), phrase.size());
      if (end - at > 2) terms.push_back(phrase.substr(at, end - at));
      at = end + 1;
    }
  };
  for (const Searchable& one : searchables()) {
    for (const Term& term : one.terms) {
      if (term.ranks == &of_scope || term.ranks == &of_mode) continue;
      terms.push_back(term.text);
      add_words(term.text);
    }
  }
  return nearest(text, terms);
}

}  // namespace loadpath::cli
