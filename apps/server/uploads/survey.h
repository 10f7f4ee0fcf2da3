#pragma once
// Determines the contents of an uploaded file.

#include <nlohmann/json.hpp>

#include "server/uploads/uploads.h"

namespace tramline::server {

/// Settles the kind of the upload and gives what the API says of it beside id, name, bytes and kind. Files of
/// no known kind get a message; throws bad_input for a file that is nothing at all, such as an empty one.
nlohmann::ordered_json survey(Upload& upload);

/// The fields of a file: {features, features_total}. Throws bad_input where it has none.
nlohmann::ordered_json survey_fields_of(const Upload& upload);

/// The logs of a file: {logs}. Throws bad_input where it is not a log.
nlohmann::ordered_json survey_logs_of(const Upload& upload);

}  // namespace tramline::server
