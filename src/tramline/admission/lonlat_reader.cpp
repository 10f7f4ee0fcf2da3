#include "tramline/admission/lonlat_reader.h"

#include <fmt/format.h>

#include "tramline/admission/project_rings.h"
#include "tramline/geometry/error.h"

namespace tramline {

std::string file_name(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

Point LonlatReader::operator()(Point input) {
  ++vertex_;
  const std::string fault = coordinate_fault(input, crs_);
  if (!fault.empty()) throw bad_input(fmt::format("{}: vertex {} {}", subject_, vertex_, fault));
  if (crs_.plain()) return input;
  const std::optional<Point> lonlat = crs_.to_lonlat(input);
  if (!lonlat)
    throw bad_input(fmt::format("{}: vertex {} ({:.10g}, {:.10g}) lies outside {}; correct the file's CRS",
                                subject_, vertex_, input.x, input.y, crs_.name()));
  return *lonlat;
}

}  // namespace tramline
