#include "output/run_record.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "report/report_parts.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

Error unusable(const fs::path& file, const std::string& cause) {
  return failure(fmt::format("the record of finished fields '{}' cannot be used: {}", file.string(), cause));
}

Error unusable(const fs::path& file, int cause) {
  return unusable(file, std::generic_category().message(cause));
}

/// In one write: a reader finds the whole line or a piece without its end.
void append(const fs::path& file, std::string_view text) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) throw unusable(file, errno);
  int cause = 0;
  while (!text.empty() && cause == 0) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written >= 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      cause = errno;
  }
  if (close(descriptor) != 0 && cause == 0) cause = errno;
  if (cause != 0) throw unusable(file, cause);
}

}  // namespace

RunRecord::RunRecord(fs::path file, Start start) : file_(std::move(file)) {
  std::error_code error;
  if (start == Start::kResume)
    read();
  else if (fs::remove(file_, error); error)
    throw unusable(file_, error.message());
}

void RunRecord::read() {
  std::error_code error;
  if (!fs::exists(file_, error)) return;
  std::ifstream stream(file_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw unusable(file_, "it cannot be read");
  const std::size_t end = text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1;
  for (std::size_t from = 0; from < end;) {
    const std::size_t to = text.find('\n', from);
    const auto line = ordered_json::parse(text.substr(from, to - from), nullptr, false);
    from = to + 1;
    try {
      FieldResult result{line.at("result"), line.at("text"), line.at("files"), line.at("refused")};
      entries_[line.at("key")] = {line.at("made_from"), std::move(result)};
    } catch (const ordered_json::exception&) {
      continue;  // of an older program, or damaged: the field is worked on again
    }
  }
  // What comes next must not hang on to half a line.
  if (end < text.size()) fs::resize_file(file_, end, error);
  if (error) throw unusable(file_, error.message());
}

const FieldResult* RunRecord::finished(const std::string& key, const std::string& made_from) const {
  const auto found = entries_.find(key);
  if (found == entries_.end() || found->second.made_from != made_from) return nullptr;
  const FieldResult& result = found->second.result;
  const bool complete = std::all_of(result.files.begin(), result.files.end(), [](const std::string& file) {
    std::error_code error;
    return fs::exists(file, error);
  });
  return complete ? &result : nullptr;
}

void RunRecord::forget_those_in(const std::string& file) {
  std::erase_if(entries_, [&](const auto& entry) {
    const std::vector<std::string>& files = entry.second.result.files;
    return std::find(files.begin(), files.end(), file) != files.end();
  });
}

void RunRecord::add(const std::string& key, const std::string& made_from, const FieldResult& result) {
  append(file_, json_line({{"key", key},
                           {"made_from", made_from},
                           {"refused", result.refused},
                           {"files", result.files},
                           {"text", result.text},
                           {"result", result.json}}) +
                    '\n');
  entries_[key] = {made_from, result};
}

}  // namespace tramline::app
