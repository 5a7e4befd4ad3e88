// Conversion of the library's internal types to those of the API.
#pragma once

#include "lib/project/project.hpp"
#include "lib/project/sweep/plan.hpp"

#include <loadpath/solution.hpp>
#include <loadpath/sweep.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace loadpath::api {

/// Texts that issues point into, by the names of their files.
using Sources = std::map<std::string, std::string>;

/// The project's own text, and the other files that it was read from.
Sources sources_of(const project::Project& project, Sources own);

std::vector<Issue> issues_of(const std::vector<loadpath::Issue>& issues);
/// Throws an Error if one of them is an error.
void refuse_errors(const std::vector<loadpath::Issue>& issues, const Sources& sources);
[[noreturn]] void refuse(const Message& message, const Message& hint = {});
/// Throws the Error for an unknown name: "there is no result '{1}'".
[[noreturn]] void refuse_name(std::string_view id, std::string_view name, const std::vector<std::string>& known);

/// Solves a project that was read without an error. `step`: the step whose name is omitted in names of quantities.
Solution solution_of(project::Project& project, std::vector<loadpath::Issue> issues, const Sources& sources,
                     const std::string& step = {});

Role role_of(loadpath::Role role);
/// "stress", "moment", "energy", "number"
std::string kind_of(const Dimension& dimension, Kind kind);
std::string si_name(const Dimension& dimension);

Column column_of(const project::SweptInput& input);
Column column_of(const project::SweptResult& result);
/// Sorted by their first points.
std::vector<Refused> in_order(std::vector<Refused> all);

unsigned threads_for(unsigned jobs);

}  // namespace loadpath::api
