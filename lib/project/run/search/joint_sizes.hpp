// Several sizes of one part that are searched for together, in the calculator's arrangements.
#pragma once

#include "lib/project/run/evaluation/inputs.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace loadpath::project {

/// The index in its stock for each of the sizes.
using SizeIndices = std::vector<std::size_t>;

/// Each size has a lower bound, which is set; the calculator raises it as its neighbours require (a shoulder, one
/// diameter without a step). Any set of lower bounds thus gives one part, the lightest that satisfies them.
class JointSizes {
 public:
  JointSizes(const PreparedStep& step, const Inputs& inputs);
  JointSizes(const JointSizes&) = delete;  // expressions of the searched inputs refer to the sizes
  JointSizes& operator=(const JointSizes&) = delete;

  [[nodiscard]] std::size_t count() const { return sought_.size(); }
  [[nodiscard]] const Search& search(std::size_t i) const { return *searches_[i]; }
  [[nodiscard]] const std::string& stock(std::size_t i) const { return stocks_[i]; }
  /// All that one may be, ascending.
  [[nodiscard]] const std::vector<double>& sizes(std::size_t i) const { return sizes_[i]; }
  [[nodiscard]] const OpenSize& at(std::size_t i) const { return sought_[i]; }
  [[nodiscard]] SizeIndices now() const;
  [[nodiscard]] SizeIndices largest_first() const;
  /// The first of each group of those that are of one size.
  [[nodiscard]] SizeIndices firsts() const;
  [[nodiscard]] bool is_first(std::size_t i) const { return sought_[i].like == i; }
  /// All sizes of all stocks, each once, ascending.
  [[nodiscard]] std::vector<double> levels() const;
  /// The first size of each stock that is not below `size`, within the caps.
  [[nodiscard]] SizeIndices first_from(double size) const;

  /// Limits `first_from` to the largest size that each may have next to what is given: a collar, one cylinder with it.
  /// Sizes that are possible separately are possible together, because each requires only more of its neighbours.
  /// Returns whether one of them is limited.
  bool cap();

  /// Selects one of the calculator's arrangements of the sizes, without caps; false if there are no more.
  bool arrange(std::size_t way);
  /// Sets sizes that go together, none of which is below its least; false if there are none.
  bool set(const SizeIndices& least);
  /// Sets these, even if they do not fit one another.
  void set_alone(const SizeIndices& least);
  /// Makes one of them, with those that are of one size with it, a size smaller than `laid`, in no record yet; false
  /// if there is none.
  bool shrink(const SizeIndices& laid, std::size_t which);
  /// Sets a smaller size with the others unchanged; false if they prevent it.
  bool set_smaller(const SizeIndices& laid, std::size_t which);
  /// The calculator's fault in one of the current sizes; empty if there is none.
  [[nodiscard]] Message fault(std::size_t i) const;
  [[nodiscard]] bool is_sound() const;
  /// The objective to minimise, at the current sizes.
  [[nodiscard]] double cost() const;
  /// Whether an element of a result's list is about one of the sizes that are like `first`.
  [[nodiscard]] bool is_place_of(std::size_t first, const FieldInfo& list, const void* element) const;
  /// Whether an element of a result's list is about an element whose size is given.
  [[nodiscard]] bool is_given_place(const FieldInfo& list, const void* element) const;
  /// All as large as `size`, or as the largest of their stocks.
  [[nodiscard]] SizeIndices alike(double size) const;
  /// The element with a given size that an element of a result's list is about, "pieces[1]"; empty if its size is
  /// searched for.
  [[nodiscard]] std::string given_place_of(const FieldInfo& list, const void* element) const;

 private:
  const Inputs& inputs_;
  const Sizing& sizing_;
  std::vector<const Search*> searches_;
  std::vector<std::string> stocks_;
  std::vector<std::vector<double>> sizes_;
  std::vector<OpenSize> sought_;
  SizeIndices caps_;  // empty: none
};

}  // namespace loadpath::project
