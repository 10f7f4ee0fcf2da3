// A plan as a file to take away.

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "server/http/download.h"
#include "server/routes/routes.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::server {
namespace {

struct FileFormat {
  std::string_view name;
  const char* extension;
  const char* type;
};

constexpr FileFormat kPlanFile{"gpkg", ".gpkg", "application/geopackage+sqlite3"};
constexpr std::array<FileFormat, 4> kExports = {{{"geojson", ".geojson", "application/geo+json"},
                                                 {"flatgeobuf", ".fgb", "application/octet-stream"},
                                                 {"kml", ".kml", "application/vnd.google-earth.kml+xml"},
                                                 {"shapefile", ".zip", "application/zip"}}};
constexpr std::array<FileFormat, 3> kPictures = {
    {{"png", ".png", "image/png"}, {"svg", ".svg", "image/svg+xml"}, {"pdf", ".pdf", "application/pdf"}}};

template <std::size_t size>
const FileFormat* named(const std::array<FileFormat, size>& formats, std::string_view word) {
  for (const FileFormat& format : formats)
    if (format.name == word) return &format;
  return nullptr;
}

void send_plan(App& app, const Call& call, httplib::Response& response) {
  // What somebody has taken away, or looked at beside another, is wanted.
  const KeptPlan plan = app.plans.keep(call.part("plan"));
  const std::filesystem::path file = app.plans.file(plan.id);
  const std::string& word = call.part("format");
  if (word == kPlanFile.name)
    return send_file(response, file, plan.name, kPlanFile.extension, kPlanFile.type);
  if (const FileFormat* format = named(kExports, word))
    return send_written(response, app.folder, plan.name, format->extension, format->type,
                        [&](const std::filesystem::path& path) {
                          io::ExportRequest request{file, path, call.query("crs"), {}};
                          if (!call.query("layer").empty()) request.layers.push_back(call.query("layer"));
                          io::export_plan(request);
                        });
  if (const FileFormat* format = named(kPictures, word))
    return send_written(response, app.folder, plan.name, format->extension, format->type,
                        [&](const std::filesystem::path& path) {
                          render::draw_plan(app.plans.open(plan.id).file.plan, path);
                        });
  throw HttpError(
      Fault::kNotFound,
      fmt::format("there is no format '{}'; there are gpkg, geojson, flatgeobuf, kml, shapefile, png, "
                  "svg and pdf",
                  word));
}

}  // namespace

void add_plan_file_routes(Router& router, App& app) {
  router.get(api("/plans/{plan}/files/{format}"), [&app](const Call& call, httplib::Response& response) {
    while_kept([&] { app.plans.get(call.part("plan")); }, [&] { send_plan(app, call, response); });
  });
}

}  // namespace tramline::server
