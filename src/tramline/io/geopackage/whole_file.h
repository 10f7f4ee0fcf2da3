#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace tramline::io {

/// Writes a file whole or not at all: into a temporary beside it, renamed over it once complete. An
/// older file of that name survives a failure. Throws Error(kFailure) naming the file and the cause.
void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace tramline::io
