// The contents of the program; filled by calculators/catalogue.cpp, passed to all readers of a project.
#pragma once

#include "lib/project/step.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::project {

/// A calculator and the step that runs it in a project.
struct CatalogueEntry {
  const Calculator* calculator;
  std::unique_ptr<Step> (*make_step)(StepInput&& input);
};
using Catalogue = std::span<const CatalogueEntry>;

/// The entry of a calculator, by its id; null if there is none.
const CatalogueEntry* find_entry(Catalogue catalogue, std::string_view id);

/// The calculator that may be meant by an unknown id: of an element that exists, the nearest one of this element.
Message calculator_meant(const std::string& id, const std::vector<std::string>& ids);

}  // namespace loadpath::project
