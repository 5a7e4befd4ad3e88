// The account of the first step of a solved project.
#pragma once

#include "lib/project/project.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <variant>

namespace loadpath::test {

/// The table whose caption starts so; nullptr if there is none.
inline const account::Table* table_of(const project::Project& project, const std::string& start) {
  for (const account::Block& block : project.steps[0]->account().blocks) {
    const auto* table = std::get_if<account::Table>(&block);
    if (table != nullptr && table->caption.text().starts_with(start)) return table;
  }
  return nullptr;
}

inline std::string text_of(const account::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return std::get<Message>(cell).text();
}

/// nullptr if it is not said.
inline const account::Verdict* find_verdict(const project::Project& project, const std::string& symbol) {
  const auto& verdicts = project.steps[0]->account().verdicts;
  const auto found = std::find_if(verdicts.begin(), verdicts.end(), [&](const auto& v) { return v.symbol == symbol; });
  return found == verdicts.end() ? nullptr : &*found;
}

inline const account::Verdict& verdict_of(const project::Project& project, const std::string& symbol) {
  const auto* verdict = find_verdict(project, symbol);
  INFO(symbol);
  REQUIRE(verdict != nullptr);
  return *verdict;
}

inline const account::Entry& entry_of(const project::Project& project, const std::string& path) {
  const auto& results = project.steps[0]->account().results;
  const auto found = std::find_if(results.begin(), results.end(), [&](const auto& e) { return e.path == path; });
  INFO(path);
  REQUIRE(found != results.end());
  return *found;
}

}  // namespace loadpath::test
