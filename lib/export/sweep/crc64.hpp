// CRC-64 of ECMA-182: generator 42F0E1EBA9EA3693, not reflected, starting at zero.
#pragma once

#include <cstdint>
#include <string_view>

namespace loadpath::exports {

/// Continues the checksum of the bytes before these.
std::uint64_t crc64(std::uint64_t before, std::string_view bytes);

}  // namespace loadpath::exports
