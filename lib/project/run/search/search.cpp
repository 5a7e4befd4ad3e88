#include "lib/project/run/search/search.hpp"

#include "lib/project/run/search/candidates.hpp"
#include "lib/project/run/search/joint_search.hpp"
#include "lib/project/run/search/largest_search.hpp"
#include "lib/project/run/search/nested_search.hpp"
#include "lib/project/run/search/passing.hpp"
#include "lib/project/run/search/size_search.hpp"

#include <cmath>
#include <cstddef>

namespace loadpath::project {

namespace {

/// The first size that is searched for and leaves the area of the part as it is, because that is given in another way;
/// null if there is none. Of a calculator without an amount none is known.
const Search* first_without_effect(Evaluation& evaluation) {
  const Sizing& sizing = evaluation.calculator().sizing;
  if (*sizing.list != '\0' || sizing.cost == nullptr) return nullptr;
  for (const Search& wanted : evaluation.step().searches()) {
    const Candidates candidates = candidates_of(evaluation, wanted);
    if (!wanted.leaf || wanted.stock.empty() || candidates.count() < 2) continue;
    const auto amount_with = [&](std::size_t i) {
      candidates.take(evaluation.inputs(), i);
      evaluation.settle_sizes();
      return sizing.cost(evaluation.inputs().record().data.get());
    };
    const double least = amount_with(0), most = amount_with(candidates.count() - 1);
    candidates.leaf.set(std::nan(""));
    if (least == most) return &wanted;
  }
  return nullptr;
}

/// Whether a value of another step that does not exist is needed at every position: then no size is tried, and the
/// sizes wait for it.
bool waits_for_input(Evaluation& evaluation) {
  Inputs& inputs = evaluation.inputs();
  for (std::size_t i = 0; i < evaluation.positions(); ++i) {
    if (inputs.set_position(i)) return false;
  }
  const Message missing = inputs.missing();
  if (missing.empty()) return false;
  for (const Search& wanted : evaluation.step().searches())
    candidates_of(evaluation, wanted).leave_open(inputs, missing, {});
  return true;
}

}  // namespace

bool run_search(Evaluation& evaluation, bool in_words, std::vector<Issue>& issues, const JointRow* together) {
  const PreparedStep& step = evaluation.step();
  if (step.searches().empty() || waits_for_input(evaluation)) return true;
  const Search& wanted = step.searches().front();
  if (const Search* const idle = first_without_effect(evaluation)) {
    issues.push_back(issue_at(step.input(), idle->path,
                              say("'{1}' cannot be searched for: the section is given without it", idle->path),
                              say("leave out A, I and the row of the section, or give {1}", idle->path)));
    return false;
  }
  if (step.sizes_together())
    JointSearch(evaluation, in_words).run(issues);
  else if (step.searches().size() > 1)
    NestedSearch(evaluation, in_words).run(issues);
  else if (wanted.leaf && wanted.stock.empty())
    LargestSearch(evaluation, wanted).run(in_words, issues);
  else
    SizeSearch(evaluation, wanted, in_words, together).run(issues);
  return !has_errors(issues);
}

std::vector<std::size_t> first_rows_that_pass(Evaluation& evaluation, std::span<const std::size_t> alike) {
  std::vector<std::size_t> first(alike.size(), alike.size());
  if (waits_for_input(evaluation)) return first;
  const Candidates candidates = candidates_of(evaluation, evaluation.step().searches().front());
  Passing passing(evaluation);
  passing.excuse_sizeless();
  for (std::size_t i = 0; i < alike.size(); ++i) {
    if (first[alike[i]] < alike.size()) continue;
    candidates.take(evaluation.inputs(), i);
    if (passing.passes()) first[alike[i]] = i;
  }
  return first;
}

}  // namespace loadpath::project
