// The contents of the folder of a sweep, and their names in messages.
#pragma once

#include "lib/project/sweep/blocks.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace loadpath::exports {

constexpr const char* state_name = "state";
constexpr const char* manifest_name = "manifest.json";

/// The temporary name of a file before it is moved into place.
std::string aside_of(const std::string& name);

/// CRC-64 of ECMA-182, taken up where it stopped.
std::uint64_t checked(std::uint64_t before, std::string_view bytes);
std::uint64_t checked(std::uint64_t before, std::span<const double> values);

/// Whether a folder is empty, or has only remains of a process killed before its first state.
bool is_unbegun(const std::filesystem::path& folder);

Fault refused(const std::filesystem::path& folder, Message message, Message hint = {});
Message not_what_was_written(const std::filesystem::path& column);
/// "512-1023" for so many points, as --shard takes it.
std::string points_of(project::BlockRange blocks, std::uint64_t points);

}  // namespace loadpath::exports
