// The contents of the program; filled by calculators/catalogue.cpp, passed to all readers of a project.
#pragma once

#include "lib/project/step.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace loadpath::project {

/// A calculator and the step that runs it in a project.
struct CatalogueEntry {
  const Calculator* calculator;
  std::unique_ptr<Step> (*make_step)(StepInput&& input);
};
using Catalogue = std::span<const CatalogueEntry>;

/// The entry of a calculator, by its id; null if there is none.
const CatalogueEntry* find_entry(Catalogue catalogue, std::string_view id);

}  // namespace loadpath::project
