// The step of a planar mechanism in a project: its paths come from the names in its model.
#pragma once

#include "calculators/mechanism/ordinary.hpp"
#include "calculators/mechanism/results/output.hpp"
#include "calculators/mechanism/results/solved.hpp"
#include "lib/mechanism/structure/structure.hpp"
#include "lib/project/step.hpp"

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace loadpath::planar {

class MechanismStep : public project::Step {
 public:
  using Step::Step;

  void prepare(const project::Declared& declared, const project::Companions& companion,
               std::vector<Issue>& issues) override;
  [[nodiscard]] Outcome<Signature> signature(const std::string& path) const override;
  /// All that a link, a joint, the drive gives; of the drive the torque as shafts call it, with the force of its joint.
  [[nodiscard]] std::vector<project::Member> members(const std::string& path) const override;
  /// With the moment or power of a drive comes the force of its joint.
  [[nodiscard]] std::vector<std::string> companions_of(const std::string& path) const override;
  void solve(const project::Known& known, const project::Wanted& wanted, std::vector<Issue>& issues) override;

  /// Whether other numbers would be solved without what people read: see Ordinary.
  [[nodiscard]] bool is_ordinary() const { return ordinary_ != nullptr; }

 private:
  [[nodiscard]] Mechanism::Input& data() { return *static_cast<Mechanism::Input*>(own().reading.record.data.get()); }
  [[nodiscard]] const Mechanism::Input& data() const {
    return *static_cast<const Mechanism::Input*>(input().reading.record.data.get());
  }
  /// A number that is given, or that the template brings; no leaf where there is none at the path.
  [[nodiscard]] Leaf given_at(const std::string& path) const;
  [[nodiscard]] std::vector<FieldFault> faults_of_names(const std::vector<Issue>& issues) const;
  [[nodiscard]] std::vector<FieldFault> faults_of_values(const std::vector<Issue>& issues) const;
  std::vector<FieldFault> faults_whatever_comes(const std::vector<Issue>& issues);
  bool check_values(const mechanism::Model& model, std::vector<Issue>& issues) const;
  bool diagnose_model(const mechanism::Model& model, std::vector<Issue>& issues);
  void add_faults(const std::vector<FieldFault>& faults, std::vector<Issue>& issues) const;
  /// Puts the template's values, if there is one, into the input; false where they do not fit together.
  bool expand_template(bool in_words, std::vector<Issue>& issues);
  [[nodiscard]] bool is_typed(const std::string& path) const { return input().reading.typed.count(path) != 0; }
  /// Whether every value is known before the project is solved.
  [[nodiscard]] bool is_known() const;
  void restore();
  /// Completes the given input for the solution: with the inertia and middles of bars, and the parts of cylinders.
  void complete();
  [[nodiscard]] account::Origin origin_of(const Record* laid, const std::string& path, const Leaf& leaf) const;
  void fill_inputs();
  void set_axis_speed();
  /// Solves a mechanism like the previous one, if only numbers are wanted; false if it needs a full solution.
  bool solve_ordinary(const mechanism::Model& model, const project::Wanted& wanted);
  [[nodiscard]] std::set<std::string> asked(const project::Wanted& wanted) const;
  /// Verdicts, results, inputs; tables and figures where they are wanted.
  void write_account(const Solved& solved, const project::Wanted& wanted);
  void illustrate(const Solved& solved);

  Record as_read_;       // before it was solved for the first time
  Mechanism::Input in_;  // as it is solved
  std::vector<Output> outputs_;
  mechanism::Structure structure_;
  std::unique_ptr<Axis> axis_;          // null: one position
  std::unique_ptr<Ordinary> ordinary_;  // from the last mechanism solved in full for numbers only; null: none
  project::Wanted ordinary_for_;        // the results wanted then
};

std::unique_ptr<project::Step> make_step(project::StepInput&& input);

}  // namespace loadpath::planar
