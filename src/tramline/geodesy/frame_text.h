#pragma once
// A local frame as text that other programs understand.

#include <string>

#include "tramline/model/local_frame.h"

namespace tramline {

/// "+proj=tmerc +lat_0=… +lon_0=… +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
/// empty for a plain frame. The origin is written with 7 decimals, which frame_centred_on keeps exact.
std::string proj_string(const LocalFrame& frame);

/// The frame's CRS as WKT2 (2019), on one line; for a plain frame an engineering CRS in metres.
std::string wkt(const LocalFrame& frame);

}  // namespace tramline
