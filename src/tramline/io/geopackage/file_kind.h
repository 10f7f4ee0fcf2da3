#pragma once
// What a GeoPackage of ours holds, for messages.

namespace tramline::io {

struct FileKind {
  const char* what;    ///< "plan"
  const char* writer;  ///< the command that writes it: "tramline plan"
};

}  // namespace tramline::io
