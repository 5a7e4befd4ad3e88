#pragma once
#include "lib/calculator.hpp"
namespace loadpath::project { class Step { public: virtual ~Step() = default; }; struct StepInput {}; std::unique_ptr<Step> make_calculator_step(StepInput&&); }
