#pragma once

#include <string>

namespace loadpath::cli {

/// Has the desktop open a page, by the first of its programs for that; false if there is none.
bool open_page(const std::string& address);

}  // namespace loadpath::cli
