#include "server/uploads/survey.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "server/http/page_words.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/remarks.h"
#include "tramline/io/log/log_format.h"
#include "tramline/io/plan/plan_layers.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

bool is_plan(const Upload& upload) {
  try {
    const io::Metadata metadata = io::read_metadata(upload.path, io::kPlanFile);
    const auto format = metadata.find("format");
    return format != metadata.end() && format->second == "tramline plan";
  } catch (const Error&) {
    return false;
  }
}

/// A log by its own words: positions in a vector file are told from fields by there being no polygons.
bool is_log_by_format(const Upload& upload) {
  try {
    return io::log_format(upload.path.string()) != io::LogFormat::kVector;
  } catch (const Error&) {
    return false;
  }
}

/// Points and lines are no fields, but may be a log.
bool none_accepted(const ordered_json& found) {
  const ordered_json& features = found.at("features");
  return std::all_of(features.begin(), features.end(),
                     [](const ordered_json& feature) { return !feature.at("refused").is_null(); });
}

/// Either of two attempts, the more likely one first.
class Attempts {
 public:
  explicit Attempts(Upload& upload) : upload_(upload) {}

  template <class Function>
  bool attempt(UploadKind kind, const char* as, Function&& function) {
    try {
      found = function(upload_);
      upload_.kind = kind;
      return true;
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      tried_ += fmt::format("{}{}: {}", tried_.empty() ? "" : "; ", as,
                            upload_.in_its_name(in_page_words(error.what())));
      return false;
    }
  }

  std::string tried() const { return fmt::format("'{}' cannot be used ({})", upload_.name, tried_); }

  ordered_json found;

 private:
  Upload& upload_;
  std::string tried_;
};

}  // namespace

ordered_json survey(Upload& upload) {
  if (upload.bytes == 0) throw bad_input(fmt::format("'{}' is empty; choose another file", upload.name));
  if (is_plan(upload)) {
    upload.kind = UploadKind::kPlan;
    return ordered_json::object();
  }
  Attempts attempts(upload);
  const bool log_first = is_log_by_format(upload);
  const auto as_fields = [&] {
    return attempts.attempt(UploadKind::kFields, "as a field", survey_fields_of);
  };
  const auto as_log = [&] { return attempts.attempt(UploadKind::kLog, "as a log", survey_logs_of); };
  if (log_first ? as_log() || as_fields() : as_fields() || as_log()) {
    if (upload.kind == UploadKind::kLog && log_first) {
      // A task set may hold the fields as well.
      try {
        attempts.found["partfields"] = survey_fields_of(upload)["features"];
      } catch (const Error&) {
        attempts.found["partfields"] = ordered_json::array();
      }
    }
    if (upload.kind == UploadKind::kFields && !log_first && none_accepted(attempts.found)) as_log();
    return attempts.found;
  }
  upload.kind = UploadKind::kUnknown;
  return {{"message", attempts.tried()}};
}

}  // namespace tramline::server
