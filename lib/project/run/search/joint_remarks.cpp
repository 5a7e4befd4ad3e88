// What a search for several sizes of one part reports: why each is not smaller, or why there are none.
#include "lib/project/run/search/joint_search.hpp"
#include "lib/project/run/search/shortfall.hpp"
#include "lib/quantity/format.hpp"

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loadpath::project {

/// No sizes satisfy the input rules: the rule that is broken at all of them, if there is one. Where the arrangement
/// takes no sizes at all, the rules are only those of the sizes.
Issue JointSearch::no_sizes() {
  const Message none = say("no combination of sizes satisfies the input rules");
  const std::string& first = sizes_.search(0).path;
  std::optional<std::set<std::size_t>> always;
  bool is_arranged = false;
  for (const double level : sizes_.levels()) {
    const SizeIndices sizes = sizes_.first_from(level);
    const bool are_set = sizes_.set(sizes);
    if (!are_set) sizes_.set_alone(sizes);
    is_arranged = is_arranged || are_set;
    const std::set<std::size_t> broken = passing_.broken_rules();
    if (!always) always = broken;
    std::erase_if(*always, [&](std::size_t rule) { return !broken.contains(rule); });
  }
  if (always && !always->empty()) {
    Issue issue = evaluation_.broken_rule(*always->begin());
    if (!is_arranged) issue.message = say("{1}: {2}", none, issue.message);
    return issue;
  }
  return issue_at(evaluation_.step().input(), first, none, say("give '{1}' a value, or search for more sizes", first));
}

/// The check that fails if one of them is a size smaller, with the others unchanged; nothing if no smaller one is
/// possible with them.
std::optional<account::TriedSize> JointSearch::next_of(const SizeIndices& laid, std::size_t which) {
  if (!sizes_.shrink(laid, which)) return std::nullopt;
  const double size = sizes_.at(which).size();
  const std::string less = format_quantity(size, sizes_.search(which).leaf.field->unit);
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    if (sizes_.at(i).like != sizes_.at(which).like) continue;
    const Message unsound = sizes_.fault(i);
    if (!unsound.empty()) return tried_size(evaluation_.calculator(), less, size, {unsound});
  }
  if (!sizes_.set_smaller(laid, which)) return std::nullopt;
  last_.reset();
  return tried_size(evaluation_.calculator(), less, size, fault_of_candidate(evaluation_, passing_));
}

/// No sizes pass together: none has a value. Reports the failures of the nearest ones, all alike unless their
/// neighbours require otherwise.
void JointSearch::leave_open(SizeIndices nearest) {
  if (!in_words_) return leave_all(say("no sizes pass together"));  // a point of a sweep: the nearest are only words
  sizes_.cap();
  Shortfall least;
  bool is_first = true;
  std::set<SizeIndices> tried;
  last_.reset();
  for (const double level : sizes_.levels()) {
    if (!sizes_.set(sizes_.first_from(level)) || !tried.insert(sizes_.now()).second) continue;
    if (!passing_.settles_within_rules()) continue;
    const Shortfall here = shortfall_of_candidate(evaluation_, passing_);
    if (!is_first && !here.is_less_than(least)) continue;
    is_first = false;
    least = here;
    nearest = sizes_.now();
  }
  sizes_.set(nearest);
  settle();
  Message fault;  // of the part as a whole, before that of a check
  for (std::size_t i = 0; i < sizes_.count() && fault.empty(); ++i) fault = sizes_.fault(i);
  if (fault.empty()) fault = fault_of_candidate(evaluation_, passing_).text;
  leave_all(say("no sizes pass together, nearest are {1}: {2}", named_sizes(), fault));
}

/// All sizes fail the same check, as that of a segment with a given diameter: none has a value. Reports this check, and
/// the sizes that pass all others.
void JointSearch::leave_unfit(const SizeIndices& others) {
  sizes_.set(others);
  settle();
  Passing whole(evaluation_);
  whole.excuse_sizeless();
  const CandidateFault fault = fault_of_candidate(evaluation_, whole);
  const Message place = given_place(fault.row);
  Message why = say("no sizes pass together: {1} with all of them", fault_in_full(evaluation_, fault));
  if (!place.empty()) why = say("{1}, {2}", std::move(why), place);
  leave_all(say("{1}; {2} pass all other checks", std::move(why), named_sizes()));
}

/// "pieces[1].d = 50 mm, pieces[2].d = 40 mm": the current sizes.
std::string JointSearch::named_sizes() const {
  std::string sizes;
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    const std::string size = format_quantity(sizes_.at(i).size(), sizes_.search(i).leaf.field->unit);
    sizes += (i == 0 ? "" : ", ") + sizes_.search(i).path + " = " + size;
  }
  return sizes;
}

/// "for pieces[1].d is given as 20 mm", of a row "sections[2].u_v" that depends on this size; empty if on none.
Message JointSearch::given_place(const std::string& row) const {
  const auto& results = evaluation_.calculator().result->fields;
  const FieldInfo& size = *sizes_.search(0).leaf.field;
  const FieldInfo* const list = find_field(results, row.substr(0, row.find_first_of(".[")));
  if (list == nullptr || list->type != FieldInfo::Type::list) return {};
  void* const result = evaluation_.result().data.get();
  for (std::size_t k = 0; k < list->size(result); ++k) {
    if (!row.starts_with(list->key + element_path(*list, result, k) + ".")) continue;
    const std::string path = sizes_.given_place_of(*list, list->element(result, k));
    if (path.empty()) return {};
    return say("because {1}.{2} is given as {3}", path, size.key,
               format_quantity(evaluation_.inputs().leaf(path + "." + size.key).get(), size.unit));
  }
  return {};
}

/// None has a value.
void JointSearch::leave_all(const Message& why) {
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    const std::string& path = sizes_.search(i).path;
    evaluation_.inputs().leaf(path).set(std::nan(""));
    evaluation_.inputs().set_origin(path, {.text = why, .sources = {}, .searched = true});
  }
  evaluation_.inputs().set_unavailable(why, account::Subject::search);
}

/// Reports for each the result, and the reason why it is not smaller.
void JointSearch::report(const SizeIndices& least) {
  for (std::size_t i = 0; i < sizes_.count(); ++i) {
    Message text =
        say("smallest of {1} with which no assessed mode fails, in combination with the other sizes", sizes_.stock(i));
    std::optional<account::TriedSize> next;
    if (sizes_.at(i).at > 0) {
      next = next_of(least, i);
      text = next ? say("{1}; {2}: {3}", text, next->name, next->reason)
                  : say("{1}; no smaller one passes with the others", text);
    }
    sizes_.set(least);
    Origin origin = stock_origin(*evaluation_.step().input().tables, sizes_.stock(i), std::move(text));
    origin.searched = true;
    origin.next = std::move(next);
    evaluation_.inputs().set_origin(sizes_.search(i).path, std::move(origin));
  }
  settle();
}

}  // namespace loadpath::project
