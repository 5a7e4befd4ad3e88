// The step of a calculator before it is solved: the origins of its inputs, its searches, its rules.
#pragma once

#include "lib/project/run/evaluation/providers.hpp"
#include "lib/project/step.hpp"

namespace loadpath::project {

/// A load component that acts with one that an input takes.
struct LoadComponent {
  std::string path;   // of the component: "gears.gear_1.F_z"
  std::string input;  // that takes the other one: "seats[1].T"
};

class PreparedStep : public Step {
 public:
  using Step::Step;

  void prepare(const Declared& declared, const Companions& companions, std::vector<Issue>& issues) override;
  [[nodiscard]] Outcome<Signature> signature(const std::string& path) const override;
  /// Load components of this step's own inputs are passed on to the users of its results.
  [[nodiscard]] std::vector<std::string> companions_of(const std::string& path) const override;
  [[nodiscard]] std::optional<Value> value_beforehand(const std::string& path, bool settled,
                                                      const Beforehand& of) const override;

  [[nodiscard]] const Axis* axis() const { return axis_; }
  [[nodiscard]] const std::vector<Provided>& provided() const { return provided_; }
  [[nodiscard]] const std::vector<Search>& searches() const { return searches_; }
  /// Whether a search is for a name: one of the kinds of the rows of a group.
  [[nodiscard]] bool seeks_name(const Search& search) const;
  /// Whether they are sizes that the calculator finds jointly.
  [[nodiscard]] bool sizes_together() const;
  /// The origins of the elements of lists that a row has filled, by leaf.
  [[nodiscard]] const std::map<std::string, Origin>& origins() const { return origins_; }
  /// The issue of a violated rule: at the rule's own path, else at the first of its fields that was typed.
  [[nodiscard]] Issue broken_rule(std::size_t rule, const Record& record, const std::vector<Provided>& provided) const;
  /// Whether a table is to fill the input, even if the row does not exist.
  [[nodiscard]] bool names_row_for(const std::string& field) const;
  /// Whether a check or a limit is active: through an input that has a value, or that a row is to give.
  [[nodiscard]] bool is_asked(const FieldInfo& check, const Record& record) const;
  /// Components of its loads that it does not include; none may act (lib/project/run/evaluation/left_loads.hpp).
  [[nodiscard]] const std::vector<LoadComponent>& components_not_included() const { return rest_; }
  /// Whether a rule of the calculator concerns an input, or the list that it is in.
  [[nodiscard]] bool is_about(std::size_t rule, const std::string& path) const;

 private:
  void find_searches(std::vector<Issue>& issues);
  void search_each_instead(const FieldInfo& common);
  void check_stock(const Search& search, std::vector<Issue>& issues) const;
  void check_rules_of_literals(std::vector<Issue>& issues);
  [[nodiscard]] bool is_open(const std::string& field) const;
  [[nodiscard]] std::optional<Value> row_beforehand(const FieldInfo& field, const Beforehand& of) const;

  const Axis* axis_ = nullptr;    // axis of the series among the inputs; null: one position
  std::set<std::string> series_;  // inputs whose expression is a series
  std::vector<Provided> provided_;
  std::vector<LoadComponent> rest_;  // load components not included
  std::vector<Search> searches_;
  std::map<std::string, Origin> origins_;
};

}  // namespace loadpath::project
