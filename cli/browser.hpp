// PDF by a headless browser, where one is installed.
#pragma once

#include "cli/staged.hpp"

#include <filesystem>
#include <string>

namespace loadpath::cli {

/// The path of a Chromium or Chrome, or an empty text.
std::string find_browser();

/// Prints a page to a PDF file; false if the browser fails. `scratch` keeps its temporary files.
bool print_to_pdf(const std::string& html, const std::filesystem::path& path, Scratch& scratch);

}  // namespace loadpath::cli
