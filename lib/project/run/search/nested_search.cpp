#include "lib/project/run/search/nested_search.hpp"

#include "lib/project/run/search/remarks.hpp"
#include "lib/project/run/search/shortfall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace loadpath::project {

namespace {

/// The position of a search in the order of the calculator's inputs: for a row that of the first input that it fills.
std::size_t order_of(const Calculator& calculator, const Search& search) {
  const auto& fields = calculator.input->fields;
  const auto is_of_search = [&](const FieldInfo& field) {
    return search.leaf ? search.path == field.key : field.provider.table == search.path;
  };
  return static_cast<std::size_t>(std::find_if(fields.begin(), fields.end(), is_of_search) - fields.begin());
}

/// Whether it says what sizes of the part itself make as small as possible together.
bool has_amount(const Calculator& calculator) {
  return *calculator.sizing.list == '\0' && calculator.sizing.cost != nullptr;
}

}  // namespace

NestedSearch::NestedSearch(Evaluation& evaluation, bool in_words)
    : evaluation_(evaluation), in_words_(in_words), passing_(evaluation) {
  const auto& sizes = evaluation.step().body_sizes();
  for (const Search& search : evaluation.step().searches()) {
    all_.push_back(candidates_of(evaluation, search));
    if (const auto of_body = sizes.find(search.path); of_body != sizes.end()) all_.back().keep_to_body(of_body->second);
  }
  std::vector<std::size_t> order;
  for (const Candidates& candidates : all_) order.push_back(order_of(evaluation.calculator(), candidates.wanted));
  std::vector<Candidates> sorted;
  for (std::size_t k = 0; k < all_.size(); ++k) {
    const auto next = std::min_element(order.begin(), order.end());
    sorted.push_back(all_[static_cast<std::size_t>(next - order.begin())]);
    *next = static_cast<std::size_t>(-1);
  }
  all_.swap(sorted);
}

void NestedSearch::take(const Choice& choice) {
  for (std::size_t k = 0; k < all_.size(); ++k) all_[k].take(evaluation_.inputs(), choice[k]);
}

bool NestedSearch::keeps_rules_with(const Choice& choice) {
  take(choice);
  evaluation_.settle_sizes();
  return passing_.keeps_rules();
}

bool NestedSearch::advance(Choice& choice) const {
  for (std::size_t k = all_.size(); k-- > 0;) {
    if (++choice[k] < all_[k].count()) return true;
    choice[k] = 0;
  }
  return false;
}

bool NestedSearch::find(Choice& choice) {
  if (has_amount(evaluation_.calculator())) return find_least(choice);
  do {
    take(choice);
    if (passing_.passes()) return true;
  } while (advance(choice));
  return false;
}

/// All that are less than the least so far are assessed, so that no other passes with less.
bool NestedSearch::find_least(Choice& choice) {
  const auto amount_of = evaluation_.calculator().sizing.cost;
  Choice at = choice;
  double least = std::numeric_limits<double>::infinity();
  do {
    take(at);
    const double amount = amount_of(evaluation_.inputs().record().data.get());
    if (!(amount < least) || !passing_.passes()) continue;
    least = amount;
    choice = at;
  } while (advance(at));
  return std::isfinite(least);
}

bool NestedSearch::find_nearest(Choice& choice) {
  Choice at(all_.size(), 0);
  Shortfall least;
  bool is_any = false;
  const auto compare = [&] {
    const Shortfall here = shortfall_of_candidate(evaluation_, passing_);
    if (is_any && !here.is_less_than(least)) return;
    is_any = true;
    least = here;
    choice = at;
  };
  do {
    if (keeps_rules_with(at)) compare();
  } while (advance(at));
  return is_any;
}

void NestedSearch::run(std::vector<Issue>& issues) {
  const bool has_candidates =
      std::all_of(all_.begin(), all_.end(), [](const Candidates& candidates) { return candidates.count() > 0; });
  if (!has_candidates) return leave_open();
  if (!passing_.is_any_asked()) return issues.push_back(aimless_search(evaluation_.step(), all_.front().wanted));
  passing_.excuse_sizeless();
  Choice choice(all_.size(), 0);
  if (!find(choice)) return leave_open();
  if (in_words_) report(choice);
  take(choice);
  evaluation_.settle_sizes();
  if (in_words_) warn_of_customs(evaluation_, issues);
  for (const Candidates& candidates : all_) {
    if (in_words_) warn_of_found(evaluation_, candidates.wanted, issues);
  }
}

/// "d = 50 mm, key = 14x9"
Message NestedSearch::name(const Choice& choice) const {
  std::string names;
  for (std::size_t k = 0; k < all_.size(); ++k)
    names += (k == 0 ? "" : ", ") + all_[k].wanted.path + " = " + all_[k].name(choice[k]).text();
  return say("{1}", names);
}

/// Reports for each the result, and the check that the candidate before it fails with the others unchanged.
void NestedSearch::report(const Choice& found) {
  const bool is_least = has_amount(evaluation_.calculator());
  for (std::size_t k = 0; k < all_.size(); ++k) {
    Message text =
        is_least ? say("of the combination with the least material with which no assessed mode fails, sizes of {1}",
                       all_[k].source())
                 : say("smallest of {1} with which no assessed mode fails, in combination with the other sizes",
                       all_[k].source());
    std::optional<account::TriedSize> next;
    if (found[k] > 0) {
      Choice less = found;
      --less[k];
      if (keeps_rules_with(less) && !passing_.passes()) {
        const std::optional<double> si = all_[k].leaf ? std::optional(all_[k].sizes[less[k]]) : std::nullopt;
        next = tried_size(evaluation_.calculator(), all_[k].name(less[k]).text(), si,
                          fault_of_candidate(evaluation_, passing_));
        text = say("{1}; {2} fails: {3}", text, next->name, next->reason);
      }
    }
    Origin origin = all_[k].leaf
                        ? stock_origin(*evaluation_.step().input().tables, all_[k].wanted.stock, std::move(text))
                        : Origin{std::move(text), {}, false};
    origin.searched = true;
    origin.next = std::move(next);
    evaluation_.inputs().set_origin(all_[k].wanted.path, std::move(origin));
  }
}

/// None pass together: none has a value.
void NestedSearch::leave_open() {
  Choice nearest(all_.size(), 0);
  Message why;
  const bool has_candidates =
      std::all_of(all_.begin(), all_.end(), [](const Candidates& candidates) { return candidates.count() > 0; });
  if (!has_candidates) {
    why = say("there is nothing to search in");
  } else if (find_nearest(nearest)) {
    keeps_rules_with(nearest);
    why = say("none pass together, nearest is {1}: {2}", name(nearest),
              fault_in_full(evaluation_, fault_of_candidate(evaluation_, passing_)));
  } else {
    why = say("no combination of sizes satisfies the input rules");
  }
  for (const Candidates& candidates : all_) candidates.leave_open(evaluation_.inputs(), why);
  evaluation_.inputs().set_unavailable(why, account::Subject::search);
}

}  // namespace loadpath::project
