#include "calculators/catalogue.hpp"
#include "cli/catalogue/not_included.hpp"
#include "cli/catalogue/search.hpp"
#include "cli/commands.hpp"
#include "lib/export/json_catalogue.hpp"
#include "lib/report/terminal/terminal.hpp"
#include "lib/text/search.hpp"

#include <algorithm>
#include <iostream>

namespace loadpath::cli {

namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t screen_width = 80;
constexpr int in_one_text = 6;  // ranks below: one name holds all words

Hit hit_of(const Calculator& c, const char* where) { return {&c, c.id, c.title, "", where}; }

/// The calculators of the element that the word names, in the order of the catalogue.
std::vector<Hit> of_element(const std::string& word) {
  const auto searched = search_words(word);
  std::vector<Hit> hits;
  for (const Calculator* c : calculators()) {
    if (word.empty() || search_words(c->element()) == searched) hits.push_back(hit_of(*c, "element"));
  }
  return hits;
}

void erase_those_of(const std::vector<Hit>& shown, std::vector<Hit>& hits) {
  std::erase_if(hits, [&](const Hit& hit) {
    return std::any_of(shown.begin(), shown.end(), [&](const Hit& other) { return other.id == hit.id; });
  });
}

/// The calculators that come nearest to what is not included, and behind them what the words have found.
std::vector<Hit> nearest_hits(const std::vector<const NotIncluded*>& beyond, std::vector<Hit> named) {
  std::vector<Hit> all;
  for (const NotIncluded* one : beyond) {
    for (const std::string& id : listed_keys(one->nearest)) {
      std::vector<Hit> hits{hit_of(*find_calculator(calculators(), id), "nearest")};
      erase_those_of(all, hits);
      all.insert(all.end(), hits.begin(), hits.end());
    }
  }
  erase_those_of(all, named);
  all.insert(all.end(), named.begin(), named.end());
  return all;
}

/// "  shaft      torsion overhung design": every element with the names of its calculators.
void show_elements() {
  Rows rows;
  for (const Calculator* c : calculators()) {
    const std::string element(c->element()), name = std::string(c->id).substr(element.size() + 1);
    if (rows.empty() || rows.back()[0] != "  " + element)
      rows.push_back({"  " + element, name});
    else
      rows.back()[1] += " " + name;
  }
  std::cout << calculators().size() << " calculators of " << rows.size()
            << " elements; `loadpath list WORD` searches, e.g. buckling, S-N\n\n"
            << terminal::columns(rows, screen_width)
            << "\nMore: loadpath list shaft (titles), loadpath describe shaft.torsion\n";
}

void show(const std::vector<Hit>& hits) {
  Rows rows;
  rows.reserve(hits.size());
  for (const Hit& hit : hits) {
    rows.push_back({hit.id, hit.title});
    if (!hit.why.empty()) rows.back().push_back(hit.why);
  }
  std::cout << terminal::columns(rows, screen_width);
}

/// "13 more mention it, e.g. vessel.shell, section.thin_walled: --all"
void count(const std::vector<Hit>& hits) {
  if (hits.empty()) return;
  std::string some;
  for (std::size_t i = 0; i < std::min<std::size_t>(hits.size(), 2); ++i) some += (i == 0 ? "" : ", ") + hits[i].id;
  std::cout << terminal::paragraph(
      std::to_string(hits.size()) + " more by failure mode or scope, e.g. " + some + ": --all", 0, screen_width);
}

/// All that a word has found, in the order in which it is shown.
struct Answer {
  std::vector<Hit> element, named, mentioned;
  std::vector<const NotIncluded*> beyond;
};

Answer answer_to(const std::string& word) {
  Answer answer;
  answer.element = of_element(word);
  if (word.empty()) return answer;
  Found found = search(word);
  const bool has_name = !answer.element.empty() || (!found.named.empty() && found.named[0].rank < in_one_text);
  answer.beyond = not_included(word, has_name);
  answer.named = std::move(found.named);
  answer.mentioned = std::move(found.mentioned);
  erase_those_of(answer.element, answer.named);
  erase_those_of(answer.element, answer.mentioned);
  if (!answer.beyond.empty()) answer.named = nearest_hits(answer.beyond, std::move(answer.named));
  return answer;
}

/// The calculators of an element; with `all`, also those that the word finds elsewhere.
void print_json(const Answer& answer, bool all) {
  std::vector<exports::Listed> listed;
  for (const auto* hits : {&answer.element, &answer.named, &answer.mentioned}) {
    const bool is_asked = hits == &answer.element || answer.element.empty() || all;
    for (const Hit& hit : is_asked ? *hits : std::vector<Hit>{})
      listed.push_back({hit.calculator, hit.id, hit.title, hit.where, hit.why});
  }
  std::vector<exports::Beyond> beyond;
  for (const NotIncluded* one : answer.beyond) beyond.push_back({one->what, listed_keys(one->nearest)});
  std::cout << exports::json_of(listed, beyond);
}

int refuse(const std::string& word) {
  const std::string near = nearest_term(word);
  std::cerr << "loadpath: no calculator matches '" << word
            << "'\n  = help: " << (near.empty() ? "`loadpath list` shows all" : "did you mean '" + near + "'?") << "\n";
  return wrong_input;
}

void print(const Answer& answer, const std::string& searched, bool lists_all) {
  for (const NotIncluded* one : answer.beyond)
    std::cout << terminal::paragraph("Not included: " + std::string(one->what) + ".", 0, screen_width);
  if (!answer.beyond.empty() && !answer.named.empty()) std::cout << "\nNearest:\n";
  show(answer.element);
  if (!answer.element.empty() && !answer.named.empty()) std::cout << "\nOthers that match '" << searched << "':\n";
  show(answer.named);
  const bool alone = answer.element.empty() && answer.named.empty();
  const bool all = lists_all || (alone && answer.beyond.empty());
  all ? show(answer.mentioned) : count(answer.mentioned);
  std::cout << "\n`loadpath describe ID` shows one calculator, with a runnable example.\n";
}

}  // namespace

int list(const ListOptions& options) {
  std::string searched;
  for (const std::string& word : options.words) searched += (searched.empty() ? "" : " ") + word;
  if (searched.empty() && !options.json) {
    show_elements();
    return passed;
  }
  const Answer answer = answer_to(searched);
  if (answer.element.empty() && answer.named.empty() && answer.mentioned.empty() && answer.beyond.empty())
    return refuse(searched);
  options.json ? print_json(answer, options.all) : print(answer, searched, options.all);
  return passed;
}

}  // namespace loadpath::cli
