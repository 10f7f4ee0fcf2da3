#include "options/field_options.h"

#include <fmt/format.h>

#include <cstdlib>

namespace tramline::app {
namespace {

/// The message, empty for a size that makes sense; CLI11's own range lets nan through.
std::string sensible_size(const std::string& text) {
  char* end = nullptr;
  const double size_m = std::strtod(text.c_str(), &end);
  const bool sensible = !text.empty() && *end == '\0' && size_m >= 0.01 && size_m <= 1000;
  return sensible ? "" : fmt::format("'{}' is not a size between 0.01 and 1000 m", text);
}

}  // namespace

void add_field_options(Verb& verb, FieldOptions& options) {
  verb.add_option(
          "FIELD", options.file,
          "the field: any vector file (GeoPackage, GeoJSON, Shapefile, KML …), a .zip of one, or a database "
          "string such as PG:dbname=farm")
      .required();
  verb.add_option("--layer", options.layer, "the layer to read, where there are several");
  verb.add_option("--where", options.where, "only features that match, for example \"crop='wheat'\"");
  verb.add_option("--id", options.id, "only the field of this id or key, as 'tramline info' lists them");
  verb.add_flag("--all", options.all, "take every feature, not just one");
  add_obstacle_options(verb, options);
}

void add_field_choice(Verb& verb, FieldOptions& options) {
  const Option field = verb.add_option(
      "--field", options.file, "the field that was to be worked: any vector file, or an ISOXML task set");
  verb.add_option("--layer", options.layer, "the layer of the field's file, where there are several");
  verb.add_option("--where", options.where, "which of its features, for example \"crop='wheat'\"");
  verb.add_option("--id", options.id, "which of its fields, by id or key, as 'tramline info' lists them");
  add_obstacle_options(verb, options);
  for (const char* option :
       {"--layer", "--where", "--id", "--crs", "--obstacles", "--obstacle-size", "--passable"})
    verb.option(option).needs(field);
}

void add_obstacle_options(Verb& verb, FieldOptions& options) {
  verb.add_option("--crs", options.crs,
                  "the coordinate reference system of FIELD, such as EPSG:25832, whatever the file says; "
                  "'none' for plain "
                  "metres");
  verb.add_option("--obstacles", options.obstacles_file,
                  "a vector file of obstacles: polygons, or lines and points that get a width");
  verb.add_option("--obstacle-size", options.obstacle_size_m,
                  "width of lines and side of points among the obstacles, m")
      .check(sensible_size)
      .shows_default();
  verb.add_option("--passable", options.passable_file,
                  "a vector file of strips the machine may cross with the work interrupted");
}

}  // namespace tramline::app
