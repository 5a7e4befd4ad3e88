// Templates of project files: commented, with their main numbers in [values], each with a comment that prompts for
// it.
#pragma once

#include "lib/text/issue.hpp"

#include <string>
#include <vector>

namespace loadpath::cli {

/// A number to begin with: "torque" "T" "120 N*m".
struct MainValue {
  std::string key;
  std::string question;
  std::string text;
};

struct Starter {
  std::string name;   // "shaft"
  std::string title;  // "Shaft on two bearings"
  std::string text;
  std::vector<MainValue> values;
};

/// The built-in ones, by their names.
const std::vector<Starter>& starters();
/// Null if there is none of this name.
const Starter* find_starter(const std::string& name);

/// Its text with these fields in place of its own, "T=80 N*m" for "values.T=80 N*m". Unknown fields, and a project
/// that does not solve, are issues.
std::string filled(const Starter& starter, const std::string& file, std::vector<std::string> settings,
                   std::vector<Issue>& issues);

/// The settings as `filled` understands them: the text that issues point into.
std::vector<std::string> with_table(std::vector<std::string> settings);

}  // namespace loadpath::cli
