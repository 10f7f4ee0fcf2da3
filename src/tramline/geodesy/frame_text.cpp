#include "tramline/geodesy/frame_text.h"

#include <fmt/format.h>

#include "tramline/geodesy/proj_handle.h"
#include "tramline/geometry/error.h"

namespace tramline {

std::string proj_string(const LocalFrame& frame) {
  if (!frame.geodetic) return {};
  return fmt::format(
      "+proj=tmerc +lat_0={:.7f} +lon_0={:.7f} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
      frame.origin_lat_deg, frame.origin_lon_deg);
}

std::string wkt(const LocalFrame& frame) {
  if (!frame.geodetic)
    return "ENGCRS[\"tramline field\",EDATUM[\"field\"],CS[Cartesian,2],AXIS[\"x\",east,ORDER[1]],"
           "AXIS[\"y\",north,ORDER[2]],LENGTHUNIT[\"metre\",1]]";
  const proj::Context context = proj::make_context();
  const std::string definition = proj_string(frame) + " +type=crs";
  const proj::Object crs(proj_create(context.get(), definition.c_str()));
  const char* const options[] = {"MULTILINE=NO", nullptr};
  const char* text = crs != nullptr ? proj_as_wkt(context.get(), crs.get(), PJ_WKT2_2019, options) : nullptr;
  if (text == nullptr)
    throw failure("PROJ could not describe the field's frame: " + proj::last_error(context.get()));
  return text;
}

}  // namespace tramline
