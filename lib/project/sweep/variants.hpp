// A project as one function of its point: all varied inputs in, all requested results out, through the complete load
// path. A point gives the same bits wherever it is solved: `loadpath run --point` uses the same function.
#pragma once

#include "lib/project/sweep/axes.hpp"
#include "lib/project/sweep/body_columns.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/project/sweep/points/point_step.hpp"
#include "lib/project/sweep/points/single_body.hpp"
#include "lib/sweep/function.hpp"

#include <memory>
#include <vector>

namespace loadpath::project {

/// A point that was not solved, and why.
struct Refusal {
  std::size_t row;  // row within the block
  Issue issue;
};

class Variants final : public sweep::Function {
 public:
  /// `results`: columns as requested, already read without a fault; the verdicts follow, see verdict_columns().
  Variants(Project project, const std::vector<std::string>& results);
  Variants(const Variants&) = delete;
  Variants& operator=(const Variants&) = delete;

  [[nodiscard]] const std::vector<SweptInput>& axes() const { return axes_; }
  [[nodiscard]] const std::vector<SweptResult>& columns() const { return columns_; }
  [[nodiscard]] const Project& project() const { return project_; }
  [[nodiscard]] std::size_t inputs() const override { return axes_.size(); }
  [[nodiscard]] std::size_t outputs() const override { return columns_.size(); }
  void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) override;
  /// The refusals of the points evaluated last, in their order.
  [[nodiscard]] const std::vector<Refusal>& refusals() const { return refusals_; }
  /// The number of points so far that were solved as separate designs.
  [[nodiscard]] std::size_t solved_alone() const { return alone_; }

 private:
  /// Points that are solved together.
  void solve_batch(std::span<const double* const> in, std::span<double* const> out, std::size_t start,
                   std::size_t count);
  /// The ordinary points of a batch, column by column; which are not ordinary stays marked.
  void solve_columns(std::span<const double* const> in, std::span<double* const> out, std::size_t n);
  bool run_kernels();
  bool solve_first(std::span<const double* const> in, std::size_t n);
  void find_way(std::span<const double* const> in, std::size_t n);
  bool find_kernels(bool by_bodies);
  bool find_referred();
  bool add_body_step(Step& step);
  SingleBody::Handed hand_out_in_bodies();
  [[nodiscard]] std::size_t batch() const;
  void read_verdicts(std::span<double* const> out, std::size_t n);
  void find_modes_of_columns();
  void read_verdict(const SweptResult& column, std::span<double> out) const;
  void solve_alone(std::span<const double* const> in, std::span<double* const> out, std::size_t row);
  bool solve_point(std::span<const double* const> in, std::size_t row);
  [[nodiscard]] double read(const SweptResult& column) const;
  [[nodiscard]] double state_of(const SweptResult& column) const;
  [[nodiscard]] double utilisation_of(const SweptResult& column) const;

  Project project_;
  std::vector<SweptInput> axes_;
  std::vector<SweptResult> columns_;
  Wanted wanted_;
  account::VerdictColumns together_;
  enum class Way { unknown, columns, alone };
  Way way_ = Way::unknown;
  std::vector<std::unique_ptr<PointStep>> kernels_;  // in order of evaluation
  PointColumns points_;
  BodyColumns bodies_;
  Bodies solved_together_;           // bodies that are solved point by point
  std::set<std::string> referred_;   // full paths of values that are read
  std::vector<const double*> from_;  // columns of a batch
  std::vector<double*> to_;
  std::vector<std::vector<account::ModeColumns>> modes_;             // modes of each step in order of evaluation
  std::vector<PointExpression> expressions_;                         // of each column
  std::vector<std::vector<const account::ModeColumns*>> of_column_;  // modes of each column
  std::vector<Refusal> refusals_;
  std::size_t alone_ = 0;
};

}  // namespace loadpath::project
