#include "lib/project/sweep/points/column_step.hpp"

#include "lib/project/sweep/points/column_parts.hpp"

#include <utility>

namespace loadpath::project {

ColumnStep::ColumnStep(std::unique_ptr<ColumnParts> parts) : parts_(std::move(parts)) {}
ColumnStep::~ColumnStep() = default;

std::unique_ptr<ColumnStep> ColumnStep::of(CalculatorStep& step, const std::set<std::string>& wanted,
                                           const PointColumns& points) {
  auto plan = plan_columns(step, wanted, points);
  if (!plan) return nullptr;
  return std::unique_ptr<ColumnStep>(new ColumnStep(std::make_unique<ColumnParts>(std::move(*plan))));
}

void ColumnStep::evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) {
  parts_->feed(points);
  parts_->leave_other_components(points);
  parts_->check_inputs(points);
  parts_->leave_bolder(points);
  parts_->report_found(points);
  parts_->run(points);
  parts_->judge(points, modes);
}

bool ColumnStep::seeks(const std::string& path) const {
  return parts_->sought && parts_->step.searches().front().path == path;
}

void ColumnStep::keep_to(std::vector<double> least) { parts_->sought->least_of_body = std::move(least); }

}  // namespace loadpath::project
