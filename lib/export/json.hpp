// A solved project as one JSON object: numbers in SI, each with its unit, null with a reason if there is none.
#pragma once

#include "lib/calculator/calculator.hpp"
#include "lib/project/project.hpp"
#include "lib/project/series_choice.hpp"

#include <string>

namespace loadpath::exports {

/// Series that are not chosen are left out.
std::string json_of(const project::Project& project, std::string_view program,
                    const project::SeriesChoice& choice = {});

/// The schema of a project file (JSON Schema, draft 2020-12), for editors.
std::string project_schema(Calculators calculators);

/// Issues as JSON, for programs that read `run --json`.
std::string json_of(const std::vector<Issue>& issues);

}  // namespace loadpath::exports
