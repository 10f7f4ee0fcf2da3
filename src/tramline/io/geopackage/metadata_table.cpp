#include "tramline/io/geopackage/metadata_table.h"

namespace tramline::io {

void write_metadata_table(const Target& target, const Metadata& metadata) {
  Table table(target, kMetadataTable, wkbNone, {text("key"), text("value")});
  for (const auto& [key, value] : metadata) table.add(nullptr, {key, value});
}

Metadata read_metadata_table(Rows& file) {
  Metadata out;
  file.each(kMetadataTable, [&](const Row& row) { out[row.text("key")] = row.text("value"); });
  return out;
}

}  // namespace tramline::io
