#pragma once
// Recognises the format of a log file.

#include <cstddef>
#include <string>

namespace tramline::io {

/// The number of bytes at the start of a file from which its format is recognised.
inline constexpr std::size_t kFirstBytes = 8192;

enum class LogFormat { kCsv, kNmea, kGpx, kIsoxml, kVector, kAgOpenGps };

/// The format, recognised from the first bytes of the file, and from its name where those are not sufficient.
/// A folder or a zip is a field
/// of AgOpenGPS or a task set if it contains one, else vector files. Throws bad_input for a missing file
/// and for one of another format.
LogFormat log_format(const std::string& path);

}  // namespace tramline::io
