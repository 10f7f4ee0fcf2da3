#pragma once
// How a file of many plans says so (write_plans.h).

#include <filesystem>
#include <optional>
#include <string>

#include "tramline/io/geopackage/rows.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// The key of metadata that says in which plane the shapes of all fields are.
inline constexpr const char* kCollectionKey = "collection";

/// As text: JSON.
std::string collection_text(const LocalFrame& common);

/// The plane of the shapes in a file of many; nullopt in one of one plan. Throws Error(kBadInput) where its
/// text is of another form.
std::optional<LocalFrame> collection_frame(Rows& file, const std::filesystem::path& path);

}  // namespace tramline::io
