// A plan as a file to take away.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "report/line_card_pages.h"
#include "server/http/download.h"
#include "server/routes/routes.h"
#include "tramline/geometry/error.h"
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

/// Files for the machine: guidance terminals, autopilots, robots, drones, and cards to print.
constexpr std::array<FileFormat, 9> kMachineFiles = {{{"isoxml4", ".zip", "application/zip"},
                                                      {"isoxml3", ".zip", "application/zip"},
                                                      {"agopengps", ".zip", "application/zip"},
                                                      {"gpx", ".gpx", "application/gpx+xml"},
                                                      {"mission", ".plan", "application/json"},
                                                      {"waypoints", ".waypoints", "text/plain"},
                                                      {"dji", ".kmz", "application/vnd.google-earth.kmz"},
                                                      {"ros-yaml", ".yaml", "application/yaml"},
                                                      {"ros-json", ".json", "application/json"}}};
constexpr FileFormat kCard{"card", ".pdf", "application/pdf"};

io::LineChoice lines_in(const Call& call) {
  const std::string word = call.query("lines");
  if (word.empty() || word == "subfield") return io::LineChoice::kSubfields;
  if (word == "all") return io::LineChoice::kAll;
  throw bad_input(fmt::format("lines is '{}', but has to be subfield or all", word));
}

io::ObstacleStyle obstacles_in(const Call& call) {
  const std::string word = call.query("obstacles");
  if (word.empty() || word == "holes") return io::ObstacleStyle::kHoles;
  if (word == "polygons") return io::ObstacleStyle::kPolygons;
  throw bad_input(fmt::format("obstacles is '{}', but has to be holes or polygons", word));
}

/// As of machine files.
constexpr double kLowest_m = 0.5, kHighest_m = 1500;

/// A machine file that says how high a drone flies, beside the file to write; none where it stays on the
/// ground.
std::filesystem::path flight_file(const Call& call, const KeptPlan& plan, const std::filesystem::path& file) {
  const double altitude_m = call.query_number("flight_altitude_m");
  if (std::isnan(altitude_m)) return {};
  if (altitude_m < kLowest_m || altitude_m > kHighest_m)
    throw bad_input(fmt::format("flight_altitude_m is {}, but has to lie between {} and {} m", altitude_m,
                                kLowest_m, kHighest_m));
  std::filesystem::path out = file;
  out.replace_filename("machine.toml");
  std::ofstream written(out);
  written << fmt::format("width_m = {}\nflight_altitude_m = {}\n", plan.width_m, altitude_m);
  if (!written.flush()) throw failure("the altitude could not be written: the disk may be full");
  return out;
}

/// As `tramline export` writes it.
void write_for_machine(const Call& call, const KeptPlan& plan, const std::filesystem::path& plan_file,
                       const FileFormat& format, const std::filesystem::path& file) {
  if (format.name == "isoxml4" || format.name == "isoxml3") {
    io::TaskSetRequest request;
    request.plans = {plan_file};
    request.target = file;
    request.version = format.name == "isoxml3" ? io::TaskDataVersion::k3 : io::TaskDataVersion::k4;
    request.lines = lines_in(call);
    request.obstacles = obstacles_in(call);
    io::export_task_set(request);
  } else if (format.name == "agopengps") {
    io::export_agopengps({{plan_file}, file, lines_in(call)});
  } else {
    io::export_route({plan_file, file, io::route_format_of(file).value(), flight_file(call, plan, file)});
  }
}

/// A message with the name of the plan in the place of the path of its file.
std::string in_its_name(std::string text, const std::string& path, const std::string& name) {
  if (const std::size_t at = text.find(path); at != std::string::npos)
    text.replace(at, path.size(), "'" + name + "'");
  return text;
}

void send_plan(App& app, const Call& call, httplib::Response& response) {
  // What somebody has taken away, or looked at beside another, is wanted.
  const KeptPlan plan = app.plans.keep(call.part("plan"));
  const std::filesystem::path file = app.plans.file(plan.id);
  const std::string& word = call.part("format");
  const auto written = [&](const FileFormat& format,
                           const std::function<void(const std::filesystem::path&)>& write) {
    try {
      send_written(response, app.folder, plan.name, format.extension, format.type, write);
    } catch (const Error& error) {
      throw Error(error.kind(), in_its_name(error.what(), file.string(), plan.name));
    }
  };
  if (word == kPlanFile.name)
    return send_file(response, file, plan.name, kPlanFile.extension, kPlanFile.type);
  if (const FileFormat* format = named(kExports, word))
    return written(*format, [&](const std::filesystem::path& path) {
      io::ExportRequest request{file, path, call.query("crs"), {}};
      if (!call.query("layer").empty()) request.layers.push_back(call.query("layer"));
      io::export_plan(request);
    });
  if (const FileFormat* format = named(kMachineFiles, word))
    return written(*format, [&](const std::filesystem::path& path) {
      write_for_machine(call, plan, file, *format, path);
    });
  if (word == kCard.name)
    return written(kCard, [&](const std::filesystem::path& path) {
      app::write_line_cards({file}, "", io::ExportRequest{}.tolerance_m, path);
    });
  if (const FileFormat* format = named(kPictures, word))
    return written(*format, [&](const std::filesystem::path& path) {
      render::draw_plan(app.plans.open(plan.id)->plan, path);
    });
  throw HttpError(
      Fault::kNotFound,
      fmt::format("there is no format '{}'; there are gpkg, geojson, flatgeobuf, kml, shapefile, "
                  "isoxml4, isoxml3, agopengps, gpx, mission, waypoints, dji, ros-yaml, ros-json, "
                  "card, png, svg and pdf",
                  word));
}

/// Twice as wide as lists show it, for sharp screens.
constexpr int kThumbnail_px = 144;

/// A draft that is listed stays a draft. What a plan looks like never changes.
void send_thumbnail(App& app, const Call& call, httplib::Response& response) {
  const KeptPlan plan = app.plans.get(call.part("plan"));
  send_written(response, app.folder, plan.name, ".png", "image/png", [&](const std::filesystem::path& path) {
    render::draw_thumbnail(app.plans.open(plan.id)->plan, path, kThumbnail_px);
  });
  response.set_header("Cache-Control", "private, max-age=31536000, immutable");
}

}  // namespace

void add_plan_file_routes(Router& router, App& app) {
  router.get(api("/plans/{plan}/files/{format}"), [&app](const Call& call, httplib::Response& response) {
    while_kept([&] { app.plans.get(call.part("plan")); }, [&] { send_plan(app, call, response); });
  });
  router.get(api("/plans/{plan}/thumbnail"), [&app](const Call& call, httplib::Response& response) {
    while_kept([&] { app.plans.get(call.part("plan")); }, [&] { send_thumbnail(app, call, response); });
  });
}

}  // namespace tramline::server
