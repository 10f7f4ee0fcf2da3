// Files that are sent.

#include <fmt/format.h>

#include <fstream>
#include <mutex>
#include <string>
#include <utility>

#include "server/routes/routes.h"
#include "server/uploads/survey.h"
#include "tramline/geometry/error.h"
#include "tramline/io/vector/foreign_files.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// The bytes go to the disk as they come in.
void receive(const Call& call, Upload& upload) {
  std::ofstream file(upload.path, std::ios::binary);
  call.read_body([&](const char* data, std::size_t size) {
    file.write(data, static_cast<std::streamsize>(size));
    upload.bytes += size;
    return true;
  });
  file.close();
  if (!file) throw failure("the file could not be kept; is the disk full?");
}

/// What small files may expand to, so that nobody fills the memory with them.
void require_bounded(const Upload& upload) {
  constexpr std::size_t kMostExpanded = std::size_t{256} << 20;
  constexpr int kMostFiles = 10'000;
  try {
    io::require_bounded_archive(upload.path, kMostExpanded, kMostFiles);
  } catch (const Error& error) {
    throw Error(error.kind(), upload.in_its_name(error.what()));
  }
}

ordered_json accept(App& app, const Call& call) {
  app.uploads.forget_old();
  Upload upload = app.uploads.begin(call.query("name"));
  ordered_json found;
  try {
    receive(call, upload);
    require_bounded(upload);
    // One after the other: the memory it takes to read the largest file is taken once.
    const std::lock_guard reading(app.uploads.reading());
    found = survey(upload);
  } catch (...) {
    app.uploads.discard(upload);
    throw;
  }
  app.uploads.keep(upload);
  ordered_json out{
      {"id", upload.id}, {"name", upload.name}, {"bytes", upload.bytes}, {"kind", name(upload.kind)}};
  out.update(found);
  return out;
}

}  // namespace

void add_upload_routes(Router& router, App& app) {
  router.add(
      {"POST", api("/uploads"),
       [&app](const Call& call, httplib::Response& response) { answer(response, accept(app, call), 201); },
       app.settings.limits.upload_bytes});
  router.remove(api("/uploads/{upload}"), [&app](const Call& call, httplib::Response& response) {
    app.uploads.remove(call.part("upload"));
    answer(response, {{"deleted", call.part("upload")}});
  });
}

}  // namespace tramline::server
