// Drives that are kept: what they worked, their files, and their replay.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "server/drives/work_drive.h"
#include "server/drives/work_stream.h"
#include "server/http/download.h"
#include "server/http/page_words.h"
#include "server/input/json_input.h"
#include "server/routes/job_kinds.h"
#include "server/routes/routes.h"
#include "server/work/replay.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/coverage_layers.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/export/layer_geojson.h"
#include "tramline/render/coverage/draw_coverage.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;
using std::chrono::milliseconds;

ordered_json listed(const KeptDrive& drive) {
  ordered_json out;
  for (const char* key : {"id", "name", "field", "plan", "created", "fixes", "from_s", "to_s", "clock",
                          "covered_m2", "missed_m2"})
    out[key] = drive.shown.value(key, ordered_json());
  return out;
}

void replay(App& app, const Call& call, httplib::Response& response) {
  const KeptDrive drive = app.drives->store.get(call.part("drive"));
  const double from_s = call.query_number("from_s");
  double speed = call.query_number("speed");
  if (std::isnan(speed)) speed = 1;
  if (!(speed >= kSlowest && speed <= kFastest))
    throw bad_input(
        fmt::format("speed has to be between {:g} and {:g}, not {:g}", kSlowest, kFastest, speed));
  stream_work(app.streams, response, std::make_shared<Replay>(ready_to_replay(app, drive), from_s, speed),
              detail_in(call, kCoarsestWork_m));
}

bool is_layer(const std::string& name) {
  namespace layers = io::coverage_layers;
  for (const char* known : {layers::kField, layers::kCovered, layers::kRepeated, layers::kMissed,
                            layers::kNotRecorded, layers::kMultiplicity, layers::kGaps, layers::kTrack})
    if (name == known) return true;
  return false;
}

void send_layer(App& app, const Call& call, httplib::Response& response) {
  const KeptDrive drive = app.drives->store.get(call.part("drive"));
  const std::string& name = call.part("layer");
  if (!is_layer(name))
    throw HttpError(
        Fault::kNotFound,
        fmt::format("a drive has no layer '{}'; there are covered, repeated, missed, not_recorded, "
                    "multiplicity, track, gaps and field",
                    name));
  response.set_content(io::layer_geojson(app.drives->store.coverage_file(drive.id), drive.frame, name),
                       "application/geo+json");
}

void answer_file(App& app, const Call& call, httplib::Response& response) {
  const KeptDrive drive = app.drives->store.get(call.part("drive"));
  const std::filesystem::path worked = app.drives->store.coverage_file(drive.id);
  const std::string& format = call.part("format");
  if (format == "gpkg")
    return send_file(response, worked, drive.name, ".gpkg", "application/geopackage+sqlite3");
  if (format == "log")
    return send_file(response, app.drives->store.log_file(drive.id, drive.source), drive.name,
                     drive.source.extension, "application/octet-stream");
  const char* type = format == "png" ? "image/png" : format == "svg" ? "image/svg+xml" : "application/pdf";
  if (format != "png" && format != "svg" && format != "pdf")
    throw HttpError(Fault::kNotFound,
                    fmt::format("a drive is no '{}'; there are gpkg, png, svg, pdf and log", format));
  send_written(response, app.folder, drive.name, "." + format, type,
               [&](const std::filesystem::path& picture) {
                 render::draw_coverage(io::read_coverage(worked), picture);
               });
}

/// Answers from the files of a drive, which may be deleted meanwhile.
template <void (*answer_from)(App&, const Call&, httplib::Response&)>
Handler from_files(App& app) {
  return [&app](const Call& call, httplib::Response& response) {
    while_kept([&] { app.drives->store.get(call.part("drive")); }, [&] { answer_from(app, call, response); });
  };
}

}  // namespace

void add_drive_routes(Router& router, App& app) {
  finish_half_replaced(app);
  router.get(api("/drives"), [&app](const Call&, httplib::Response& response) {
    ordered_json out = ordered_json::array();
    for (const KeptDrive& drive : app.drives->store.list()) out.push_back(listed(drive));
    answer(response, out);
  });
  router.post(api("/drives"), [&app](const Call& call, httplib::Response& response) {
    answer(response, job_json(begin_drive(app, call.json())), 202);
  });
  router.get(api("/drives/{drive}"), [&app](const Call& call, httplib::Response& response) {
    ordered_json shown = app.drives->store.get(call.part("drive")).shown;
    if (shown.contains("summary")) shown["summary"] = summary_in_page_words(std::move(shown["summary"]));
    answer(response, shown);
  });
  router.patch(api("/drives/{drive}"), [&app](const Call& call, httplib::Response& response) {
    const ordered_json json = call.json();
    const std::string name = name_of(JsonInput(json, "", {"name"}), "name");
    if (name.empty()) throw bad_input("give the drive a name");
    answer(response, listed(app.drives->store.rename(call.part("drive"), name)));
  });
  router.remove(api("/drives/{drive}"), [&app](const Call& call, httplib::Response& response) {
    app.drives->store.remove(call.part("drive"));
    app.drives->replays.forget(call.part("drive"));
    answer(response, {{"deleted", call.part("drive")}});
  });
  router.get(api("/drives/{drive}/layers/{layer}"), from_files<send_layer>(app));
  router.get(api("/drives/{drive}/files/{format}"), from_files<answer_file>(app));
  router.get(api("/drives/{drive}/replay"), from_files<replay>(app));
}

}  // namespace tramline::server
