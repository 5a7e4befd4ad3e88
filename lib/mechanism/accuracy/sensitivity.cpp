#include "lib/mechanism/accuracy/sensitivity.hpp"

#include "lib/mechanism/accuracy/differential.hpp"
#include "lib/mechanism/proof/instant.hpp"

#include <algorithm>
#include <vector>

namespace loadpath::mechanism {

struct Sensitivity::Work {
  explicit Work(const Model& given)
      : model(given),
        instant(model),
        differential(instant),
        parameters(parameters_of(given)),
        derivatives(parameters.size(), blank_position(given)) {}

  void find(std::size_t first);

  static constexpr std::size_t lanes = std::tuple_size_v<decltype(Dual::d)>;

  Model model;
  Instant instant;
  Differential differential;
  std::vector<Parameter> parameters;
  std::vector<Position> derivatives;
};

Sensitivity::Sensitivity(const Model& model) : work_(std::make_unique<Work>(model)) {}
Sensitivity::~Sensitivity() = default;
Sensitivity::Sensitivity(Sensitivity&&) noexcept = default;

std::span<const Parameter> Sensitivity::parameters() const { return work_->parameters; }

Status Sensitivity::find(const Position& at, bool statics) {
  Work& w = *work_;
  w.instant.take(at, statics);
  if (!(w.instant.condition() <= most_condition)) return Status::singular;
  if (!w.differential.start(statics)) return Status::jams;
  for (std::size_t first = 0; first < w.parameters.size(); first += Work::lanes) w.find(first);
  return Status::closed;
}

void Sensitivity::Work::find(std::size_t first) {
  const std::size_t count = std::min(lanes, parameters.size() - first);
  const auto seed = [&](double amount) {
    for (std::size_t l = 0; l < count; ++l) number(differential.model(), parameters[first + l]).d[l] = amount;
  };
  seed(1.0);
  differential.find();
  seed(0.0);
  for (std::size_t l = 0; l < count; ++l) differential.store(l, derivatives[first + l]);
}

const Position& Sensitivity::by(std::size_t parameter) const { return work_->derivatives[parameter]; }

std::size_t Sensitivity::find_parameter(const Parameter& parameter) const {
  const auto& list = work_->parameters;
  return static_cast<std::size_t>(std::ranges::find(list, parameter) - list.begin());
}

}  // namespace loadpath::mechanism
