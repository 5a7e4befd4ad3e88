// Writes a JSON value as text: indented, keys in the order they were added, numbers the shortest that read back.
#pragma once

#include <boost/json/fwd.hpp>

#include <string>

namespace loadpath::exports {

std::string text_of(const boost::json::value& value);

}  // namespace loadpath::exports
