// Whether a step passes in its current state: the question of a search about every candidate.
#pragma once

#include "lib/project/run/evaluation/evaluation.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace loadpath::project {

/// A check or a limit of the result; `element`: of the list that it is in.
struct Row {
  static constexpr std::size_t of_part = static_cast<std::size_t>(-1), of_all = of_part - 1;

  const FieldInfo* field;
  std::size_t element = of_part;
  friend bool operator<(const Row& a, const Row& b) {
    return a.field != b.field ? std::less<>()(a.field, b.field) : a.element < b.element;
  }
};

class Passing {
 public:
  explicit Passing(Evaluation& evaluation) : evaluation_(evaluation) {}

  /// Whether no rule about the searched inputs, no check, criterion or limit of a method fails, apart from the
  /// excused ones. A candidate outside the validity of its formulas is not acceptable.
  bool passes();
  /// The same from the size that was found last, and of a part without positions from one evaluation.
  bool passes_again();
  /// Whether element k of a list passes its checks, and keeps its criteria and the limits of its methods.
  [[nodiscard]] bool element_passes(const FieldInfo& list, std::size_t k) const;
  /// Whether the rules about the searched inputs hold at the settled sizes.
  bool keeps_rules() { return evaluation_.is_settled() && !first_broken_rule(); }
  /// The first of them that is broken at a position.
  std::optional<std::size_t> first_broken_rule();
  /// All of them at the current sizes, with values of tables settled if one of them takes such a value.
  std::set<std::size_t> broken_rules();
  /// Whether they hold at the current sizes and the values of tables converge. Rules without such a value come first:
  /// convergence needs an evaluation of the part.
  bool settles_within_rules();
  /// Whether one without such a value is broken.
  bool breaks_rule_without_table();
  /// Whether a check is active: otherwise any candidate would pass.
  [[nodiscard]] bool is_any_asked() const;

  /// Leaves a check or a limit out of account that no candidate improves.
  void excuse(const Row& row) { excused_.insert(row); }
  void count_again(const Row& row) { excused_.erase(row); }
  /// Excuses all that depend only on the loads.
  void excuse_sizeless();
  [[nodiscard]] std::size_t count_of_excused() const { return excused_.size(); }
  /// Whether a check or a limit of the result, or of an element of a list, is assessed, and not excused.
  [[nodiscard]] bool counts(const Row& row) const;
  /// The first value of a limit that is outside of it, or that is missing; nothing if it is kept.
  std::optional<double> first_outside(const FieldInfo& limit);

 private:
  /// For every rule whether a search must satisfy it.
  const std::vector<bool>& concerned();
  /// Whether a rule takes a value of a row that depends on the size.
  [[nodiscard]] bool takes_sized_value(std::size_t rule) const;
  [[nodiscard]] bool has_rule_with_table();

  [[nodiscard]] bool holds_here() const;
  [[nodiscard]] bool is_held_against(const FieldInfo& field, bool criteria) const;
  [[nodiscard]] bool keeps(const FieldInfo& field, const void* owner, bool criteria) const;
  [[nodiscard]] bool element_keeps(const FieldInfo& list, std::size_t k, bool criteria) const;

  Evaluation& evaluation_;
  std::set<Row> excused_;
  std::size_t failed_at_ = 0;    // the last position at which a candidate failed
  std::vector<bool> concerned_;  // once determined
};

}  // namespace loadpath::project
