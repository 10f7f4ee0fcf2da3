#pragma once
// The files of the repository that these tests belong to.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::architecture {

std::filesystem::path source_root();

/// Paths relative to the root of all files that git tracks or would track; without git, of all
/// files outside the folders for results. Sorted.
std::vector<std::string> repository_files();

/// The bytes of a file, its path relative to the root.
std::string read(const std::string& path);

}  // namespace tramline::architecture
