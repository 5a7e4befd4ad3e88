// Bytes as text for data: addresses, RFC 4648.
#pragma once

#include <string>
#include <string_view>

namespace loadpath::report {

std::string base64(std::string_view bytes);

}  // namespace loadpath::report
