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

/// Is it a source of the library or of a program, rather than of a test, a benchmark or the page?
bool is_product_source(const std::string& path);

/// Is it a file of this room of the library, private or public?
bool is_in_room(const std::string& path, const std::string& room);

/// The bytes of a file, its path relative to the root.
std::string read(const std::string& path);

}  // namespace tramline::architecture
