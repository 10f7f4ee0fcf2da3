#pragma once
// The fields of a plan file.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tramline/io/geopackage/field_names.h"
#include "tramline/model/local_frame.h"

namespace tramline::io {

/// The plane of the shapes in a plan file whose field has the frame `field`.
LocalFrame frame_of_layers(const std::filesystem::path& path, const LocalFrame& field);

/// Whether a file is a plan file, of one plan or of many; false where there is no such file, or none that can
/// be read.
bool is_plan_file(const std::filesystem::path& path);

/// The fields of a file of many plans, in its order; empty for a file of one plan. Throws Error(kBadInput)
/// where it is not a plan file.
std::vector<FieldNames> fields_in(const std::filesystem::path& path);

/// The field's own frame by its key; by "" in a file of one plan. Throws Error(kBadInput) where it is not a
/// plan file, and where one of them is malformed.
std::map<std::string, LocalFrame, std::less<>> frames_in(const std::filesystem::path& path);

/// The field that `asked` names, by key or id; the only one where `asked` is empty. Throws Error(kBadInput),
/// naming those there are (the first 20), where it names none or several.
FieldNames chosen_field(const std::vector<FieldNames>& fields, const std::string& asked,
                        const std::filesystem::path& path);

}  // namespace tramline::io
