// The published cases next to the results of the program: the lines of `verify`, and its report.
#pragma once

#include "lib/project/verify.hpp"
#include "lib/report/document.hpp"

#include <span>
#include <string>
#include <vector>

namespace loadpath::report {

/// The comparisons of one solved file, which holds their expectations.
struct VerifiedFile {
  project::Project project;
  std::vector<project::Comparison> values;
};

/// Our value with the digits of the published one, at least six; the published one where they are the same.
std::string computed_text(const project::Comparison& value);
/// A part of the value; where it is zero, or has a tolerance in its own unit, the difference.
std::string deviation_text(const project::Comparison& value);
/// "[Gere] problem 8.2-4; printed 15 N*m: erratum 0.4".
std::string source_text(const project::Comparison& value);

/// A table of the files, then every value of each: published, computed, deviation, source.
Document verification(std::span<const VerifiedFile> files, const std::string& program);

}  // namespace loadpath::report
