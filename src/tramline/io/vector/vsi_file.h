#pragma once
// A file as GDAL opens it, also within an archive ("/vsizip/…").

#include <cpl_vsi.h>

#include <memory>
#include <string>

namespace tramline::io {

using VsiFile = std::unique_ptr<VSILFILE, int (*)(VSILFILE*)>;

/// To be read; null where it cannot be opened.
inline VsiFile opened_to_read(const std::string& name) { return {VSIFOpenL(name.c_str(), "rb"), VSIFCloseL}; }

}  // namespace tramline::io
