#pragma once
// The file of a picture: its format follows from its extension, and it is written whole or not at all.

#include <filesystem>
#include <string>

namespace tramline::render {

enum class PictureFormat { kPng, kSvg, kPdf };

/// The format by the extension, in any case. Throws bad_input for any other extension.
PictureFormat format_of(const std::filesystem::path& path);

/// Writes to a temporary file beside the target, then renames it: a failed run leaves neither a partial file
/// nor a changed one. Throws Error(kFailure).
void write_whole(const std::filesystem::path& path, const std::string& bytes);

/// The moment written into files, ISO 8601: SOURCE_DATE_EPOCH, else the start of 1970.
std::string picture_date();

}  // namespace tramline::render
