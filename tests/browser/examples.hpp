// The reports of the examples, as a reader gets them.
#pragma once

#include "tests/browser/browser.hpp"
#include "tests/cli/process.hpp"

#include <string>
#include <vector>

namespace loadpath::test {

/// The folders of examples that `run` solves, in order.
std::vector<std::string> examples();

/// Writes the report of an example as the file; false if it has none, being a sweep.
bool write_report(const Desk& desk, const std::string& example, const std::string& file);

std::string address_of(const Desk& desk, const std::string& file);

/// The text that an expression has in the page.
std::string text_of(Browser& browser, const std::string& expression);

}  // namespace loadpath::test
