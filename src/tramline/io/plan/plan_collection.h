#pragma once
// The mark of a file of many plans (write_plans.h).

#include <filesystem>
#include <optional>
#include <string>

#include "tramline/io/geopackage/rows.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// The key of metadata that holds the plane of the shapes of all fields.
inline constexpr const char* kCollectionKey = "collection";

/// The common frame as JSON.
std::string collection_text(const LocalFrame& common);

/// The plane of the shapes in a file of many plans; nullopt in a file of one. Throws Error(kBadInput) where
/// its text is malformed.
std::optional<LocalFrame> collection_frame(Rows& file, const std::filesystem::path& path);

}  // namespace tramline::io
