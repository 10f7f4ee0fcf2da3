#include "tramline/io/geopackage/remarks.h"

#include <string>

#include "tramline/io/geopackage/metadata_table.h"

namespace tramline::io {

void add_remarks(const Metadata& remarks, Metadata& out) {
  for (const auto& [key, value] : remarks) out[kRemarkPrefix + key] = value;
}

Metadata remarks_in(const Metadata& metadata) {
  const std::string prefix = kRemarkPrefix;
  Metadata out;
  for (const auto& [key, value] : metadata)
    if (key.starts_with(prefix)) out[key.substr(prefix.size())] = value;
  return out;
}

Metadata read_metadata(const std::filesystem::path& path, const FileKind& kind) {
  GdalErrors errors;
  Rows file(path, kind, errors);
  return read_metadata_table(file);
}

}  // namespace tramline::io
