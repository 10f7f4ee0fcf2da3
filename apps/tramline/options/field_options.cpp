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

namespace {

/// --where and --id.
void add_feature_options(CommandOptions& command, FieldOptions& options) {
  command.add_option("--where", options.where, "Read only features that match, such as \"crop='wheat'\".")
      .takes("FILTER")
      .shows_default("all features");
  command
      .add_option("--id", options.id, "Read only the field of this id or key, as 'tramline info' lists them.")
      .takes("ID")
      .shows_default("the only field");
}

}  // namespace

void add_field_options(CommandOptions& command, FieldOptions& options) {
  command
      .add_option("FIELD", options.file,
                  "The field: any vector file (GeoPackage, GeoJSON, Shapefile, KML …), a .zip of one, or a "
                  "database string such as PG:dbname=farm.")
      .required();
  command.begin_group("Field");
  command.add_option("--layer", options.layer, "Read this layer.")
      .takes("NAME")
      .shows_default("the only layer with polygons");
  add_feature_options(command, options);
  command.add_flag("--all", options.all, "Read every field of the file rather than one.");
  add_crs_option(command, options);
  command.begin_group("Obstacles");
  add_obstacle_options(command, options);
}

void add_field_choice(CommandOptions& command, FieldOptions& options) {
  command.begin_group("Field");
  const Option field =
      command
          .add_option("--field", options.file,
                      "The field that was to be worked: any vector file, or an ISOXML task set.")
          .takes("FILE")
          .shows_default("none");
  command.add_option("--layer", options.layer, "Read this layer of the field's file.")
      .takes("NAME")
      .shows_default("the only layer with polygons");
  add_feature_options(command, options);
  add_crs_option(command, options);
  add_obstacle_options(command, options);
  for (const char* option :
       {"--layer", "--where", "--id", "--crs", "--obstacles", "--obstacle-size", "--passable"})
    command.option(option).needs(field);
}

void add_crs_option(CommandOptions& command, FieldOptions& options) {
  command
      .add_option(
          "--crs", options.crs,
          "Take the field's coordinates to be in this coordinate reference system, such as EPSG:25832, "
          "whatever its file says; 'none' for plain metres.")
      .takes("CRS")
      .shows_default("as the file says");
}

void add_obstacle_options(CommandOptions& command, FieldOptions& options) {
  command
      .add_option("--obstacles", options.obstacles_file,
                  "A vector file of obstacles, in addition to the holes of the field: polygons, or lines and "
                  "points, which are given a width.")
      .takes("FILE")
      .shows_default("none");
  command
      .add_option("--obstacle-size", options.obstacle_size_m,
                  "Width of lines and side of points among the obstacles, in metres.")
      .takes("M")
      .check(sensible_size)
      .shows_default();
  command
      .add_option("--passable", options.passable_file,
                  "A vector file of strips that the machine may cross with the work interrupted, such as "
                  "grassed waterways.")
      .takes("FILE")
      .shows_default("none");
}

}  // namespace tramline::app
