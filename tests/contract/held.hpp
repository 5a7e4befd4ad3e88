// A solved step once more as a project of its own: every input typed with its value, including searched sizes and
// strengths from tables, and its loads times a factor.
#pragma once

#include "lib/project/project.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::test {

/// The inputs of a step as they were found, of a series those of the position where a load is largest.
Record found_input(const project::Step& step);
/// A project that types them all.
std::string held(const project::Step& step, double load_factor);

/// A project of the catalogue's examples, the shipped examples or the reference cases.
struct Known {
  std::string name;
  std::string text;
  std::string file;  // file next to its histories
};
std::vector<Known> known_projects();
/// Every step of them whose element this run covers, solved.
void for_each_step(const std::function<void(const project::Step& step, const std::string& where)>& visit);

}  // namespace loadpath::test
