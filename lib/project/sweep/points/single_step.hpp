// A step that is solved point by point, between steps that go by columns: a mechanism, a list of another step.
#pragma once

#include "lib/project/step.hpp"
#include "lib/project/sweep/points/point_step.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace loadpath::project {

class SingleStep final : public PointStep {
 public:
  /// For a step that was solved at one point; null if it takes more from others than numbers. `wanted`: for all
  /// steps, valid as long as this object lives. `referred`: full paths of values that expressions refer to.
  static std::unique_ptr<SingleStep> of(Step& step, const Wanted& wanted, const std::set<std::string>& referred,
                                        const PointColumns& points);
  /// The same of a step of a body; values of its other steps are read where they are, at each point.
  static std::unique_ptr<SingleStep> of_body(Step& step, const std::vector<Step*>& body, const Wanted& wanted,
                                             const std::set<std::string>& referred, const PointColumns& points);

  void evaluate(PointColumns& points, std::vector<account::ModeColumns>& modes) override;
  /// The parts of that: before all points, at a point, where false hands it over, and what is taken of its solution.
  void start(PointColumns& points, std::vector<account::ModeColumns>& modes);
  bool solve_at(PointColumns& points, std::size_t point);
  bool take(PointColumns& points, std::size_t point, std::vector<account::ModeColumns>& modes);
  [[nodiscard]] Step& step() const { return step_; }
  [[nodiscard]] bool reads_axes() const override;

 private:
  SingleStep(Step& step, const Wanted& wanted);
  void refer_to(const std::string& path, const PointColumns& points);
  [[nodiscard]] Known known() const;
  [[nodiscard]] const Step* in_body(const std::string& path) const;
  bool set_inputs(const PointColumns& points, std::size_t point);
  bool solve(PointColumns& points, std::size_t point);
  bool take_values(PointColumns& points, std::size_t point);
  [[nodiscard]] bool keeps_axes(bool with_speed);
  bool take_modes(std::size_t point, std::vector<account::ModeColumns>& modes) const;

  /// A value that others refer to.
  struct Written {
    std::string within, path;  // path within the step, and full path
    Signature signature;
  };

  Step& step_;
  const Wanted& wanted_;
  std::vector<Step*> body_;                // other steps of its body
  std::map<std::string, Value> referred_;  // values of all others, at the point
  std::vector<Written> written_;
  std::map<const Axis*, Axis> axes_;  // axes of the published values, as they were at the first point
};

}  // namespace loadpath::project
