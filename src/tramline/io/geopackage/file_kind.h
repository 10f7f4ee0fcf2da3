#pragma once
// The kind of a tramline GeoPackage, for messages.

namespace tramline::io {

struct FileKind {
  const char* what;    ///< "plan"
  const char* writer;  ///< the command that writes it: "tramline plan"
};

}  // namespace tramline::io
