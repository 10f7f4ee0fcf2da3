#pragma once
// Writes small files whole or not at all.

#include <filesystem>
#include <string>

namespace tramline::server {

/// Written beside, brought to the disk, and then renamed. Throws failure.
void write_whole(const std::filesystem::path& path, const std::string& text);

}  // namespace tramline::server
