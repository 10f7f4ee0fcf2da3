#pragma once
// Protection against files from others, for a program that serves others.

#include <cstddef>
#include <filesystem>

namespace tramline::io {

/// From now on, in the whole process, GDAL opens only formats that are files by themselves: none that leads
/// to other files, databases or the network (VRT, WFS, schemas of GML, URLs …). To be called before other
/// threads read.
void open_plain_files_only();

/// Checks an archive (zip, KMZ, gzip; also archives within) by reading all of it, without keeping anything.
/// Throws bad_input where it holds more than `most_files` files or expands to more than `most_bytes`, before
/// it has expanded more than that; and where it cannot be read. Other files are accepted. O(expanded size).
void require_bounded_archive(const std::filesystem::path& file, std::size_t most_bytes, int most_files);

}  // namespace tramline::io
