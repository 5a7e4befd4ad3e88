// The search for several sizes of one part at once: from sizes that pass, all alike unless their neighbours require
// otherwise, each is lowered as far as all checks pass, the largest first, until none can be; at first together with
// dependent sizes, finally one at a time, so that in the end no single one can be a size smaller.
//
// Then sizes are traded as long as the part gets cheaper: some decrease while others increase. The calculator may
// have several arrangements of the sizes; each is searched, and the cheapest is taken.
#pragma once

#include "lib/project/run/search/joint_sizes.hpp"
#include "lib/project/run/search/passing.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

class JointSearch {
 public:
  /// `in_words`: the result explains why it is not smaller.
  JointSearch(Evaluation& evaluation, bool in_words)
      : evaluation_(evaluation),
        passing_(evaluation),
        sizes_(evaluation.step(), evaluation.inputs()),
        in_words_(in_words) {}
  void run(std::vector<Issue>& issues);

 private:
  struct Branching;

  [[nodiscard]] bool has_check() const;
  /// Whether the sizes as they are pass. A search comes back to the same sizes again and again, in other ways: one
  /// evaluation for all, as long as there is no other in between; sizes that have failed are not evaluated again.
  bool passes();
  /// Evaluates sizes for something else than `passes`.
  void settle() { last_.reset(), evaluation_.settle_sizes_again(); }
  bool keeps_rules() { return last_.reset(), passing_.settles_within_rules(); }
  bool passes_with(const SizeIndices& least) { return sizes_.set(least) && passes(); }
  bool find_start(SizeIndices& least);
  bool find_alike(SizeIndices& least);
  void lower(SizeIndices& least);
  bool lower_one(SizeIndices& least, std::size_t which);
  void lower_alone(SizeIndices& least);
  void exchange(SizeIndices& least);
  bool exchange_once(SizeIndices& least, const SizeIndices& floors, std::size_t reach);
  bool takes_with_one_lowered(const SizeIndices& raised, std::size_t first, std::size_t floor, SizeIndices& least,
                              double& lowest);
  bool exchange_pairs(SizeIndices& least, const SizeIndices& floors);
  [[nodiscard]] SizeIndices with_group(SizeIndices indices, std::size_t first, std::size_t at) const;
  bool is_cheaper(const SizeIndices& tried, double lowest);
  bool takes_cheaper(const SizeIndices& tried, SizeIndices& least, double& lowest);
  bool takes_with_one_raised(const SizeIndices& tried, std::size_t first, SizeIndices& least, double& lowest);
  bool find_cheapest(SizeIndices& least);
  [[nodiscard]] bool may_be(std::size_t first, std::size_t at);
  SizeIndices floors_below(const SizeIndices& found);
  SizeIndices floors_from_least();
  bool find_from(SizeIndices floors, double lowest, int trials, SizeIndices& least);
  bool find_cheaper(double lowest, SizeIndices& least);
  void branch(Branching& at, std::size_t depth);
  bool places_pass(std::size_t first);
  [[nodiscard]] bool places_pass_now(std::size_t first);
  [[nodiscard]] bool elements_pass(std::size_t first) const;
  bool set_largest(SizeIndices& least);
  void forget() { failed_.clear(), places_.clear(), barred_.clear(); }
  [[nodiscard]] Issue no_sizes();
  [[nodiscard]] std::optional<account::TriedSize> next_of(const SizeIndices& laid, std::size_t which);
  [[nodiscard]] std::set<Row> failed_at_given_places();
  [[nodiscard]] std::vector<SizeIndices> alternating();
  [[nodiscard]] bool find_barred();
  void leave_barred(std::vector<Issue>& issues);
  bool excuse_unmoved();
  bool fails_unmoved(const SizeIndices& least);
  void leave_open(SizeIndices nearest);
  void leave_unfit(const SizeIndices& others);
  void leave_all(const Message& why);
  [[nodiscard]] std::string named_sizes() const;
  [[nodiscard]] Message given_place(const std::string& row) const;
  void report(const SizeIndices& least);

  Evaluation& evaluation_;
  Passing passing_;
  JointSizes sizes_;
  bool in_words_;
  struct Evaluated {
    SizeIndices sizes;
    bool pass;
  };
  std::optional<Evaluated> last_;
  // As long as the same checks are excused. Whether they pass depends only on the sizes, in all arrangements.
  std::set<SizeIndices> failed_;
  std::map<SizeIndices, bool> places_;  // of sizes, followed by the first of those whose places are checked
  std::set<Row> barred_;                // of elements with given sizes: they fail with all sizes of their neighbours
};

}  // namespace loadpath::project
