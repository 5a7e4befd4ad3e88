#include "lib/project/run/search/search.hpp"

#include "lib/project/run/search/joint_search.hpp"
#include "lib/project/run/search/largest_search.hpp"
#include "lib/project/run/search/nested_search.hpp"
#include "lib/project/run/search/size_search.hpp"

namespace loadpath::project {

bool run_search(Evaluation& evaluation, bool in_words, std::vector<Issue>& issues) {
  const PreparedStep& step = evaluation.step();
  if (step.searches().empty()) return true;
  const Search& wanted = step.searches().front();
  if (step.sizes_together())
    JointSearch(evaluation, in_words).run(issues);
  else if (step.searches().size() > 1)
    NestedSearch(evaluation, in_words).run(issues);
  else if (wanted.leaf && wanted.stock.empty())
    LargestSearch(evaluation, wanted).run(in_words, issues);
  else
    SizeSearch(evaluation, wanted, in_words).run(issues);
  return !has_errors(issues);
}

}  // namespace loadpath::project
