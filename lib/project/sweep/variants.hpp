// A project as one function of its point: every input that takes many values in, every result that is asked for out,
// through the whole path of the loads. A point gives the same bits wherever it is solved: `loadpath run --point` takes
// the same way.
#pragma once

#include "lib/project/sweep/axes.hpp"
#include "lib/project/sweep/columns.hpp"
#include "lib/project/sweep/points/point_step.hpp"
#include "lib/sweep/function.hpp"

#include <memory>
#include <vector>

namespace loadpath::project {

/// A point that was not solved, and why.
struct Refusal {
  std::size_t row;  // of the block
  Issue issue;
};

class Variants final : public sweep::Function {
 public:
  /// `results`: columns as they were asked for, which have been read without a fault; then come the verdicts, see
  /// verdict_columns().
  Variants(Project project, const std::vector<std::string>& results);
  Variants(const Variants&) = delete;
  Variants& operator=(const Variants&) = delete;

  [[nodiscard]] const std::vector<SweptInput>& axes() const { return axes_; }
  [[nodiscard]] const std::vector<SweptResult>& columns() const { return columns_; }
  [[nodiscard]] const Project& project() const { return project_; }
  [[nodiscard]] std::size_t inputs() const override { return axes_.size(); }
  [[nodiscard]] std::size_t outputs() const override { return columns_.size(); }
  void evaluate(std::span<const double* const> in, std::span<double* const> out, std::size_t n) override;
  /// Of the points that were evaluated last, in their order.
  [[nodiscard]] const std::vector<Refusal>& refusals() const { return refusals_; }
  /// How many of all points so far were solved as machines of their own.
  [[nodiscard]] std::size_t solved_alone() const { return alone_; }

 private:
  /// Points that are solved together.
  void solve_batch(std::span<const double* const> in, std::span<double* const> out, std::size_t start,
                   std::size_t count);
  /// The ordinary points of a batch, column by column; which are not ordinary stays marked.
  void solve_columns(std::span<const double* const> in, std::span<double* const> out, std::size_t n);
  bool solve_first(std::span<const double* const> in, std::size_t n);
  void find_way(std::span<const double* const> in, std::size_t n);
  bool find_kernels();
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
  std::vector<const double*> from_;  // of a batch
  std::vector<double*> to_;
  std::vector<std::vector<account::ModeColumns>> modes_;             // of each step in order of evaluation
  std::vector<std::vector<const account::ModeColumns*>> of_column_;  // that a column speaks of
  std::vector<Refusal> refusals_;
  std::size_t alone_ = 0;
};

}  // namespace loadpath::project
