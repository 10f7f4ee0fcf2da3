#pragma once
// Which kind of log a file is.

#include <cstddef>
#include <string>

namespace tramline::io {

/// Bytes at the start of a file that tell what it is.
inline constexpr std::size_t kFirstBytes = 8192;

enum class LogFormat { kCsv, kNmea, kGpx, kIsoxml, kVector };

/// Told by the first bytes of the file, and by its name where those leave it open. A folder or a zip is a
/// task set when it holds one, else vector files. Throws bad_input for a missing file and for one that is
/// none of these.
LogFormat log_format(const std::string& path);

}  // namespace tramline::io
