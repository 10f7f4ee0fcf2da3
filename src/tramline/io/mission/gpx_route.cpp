#include <fmt/format.h>

#include <pugixml.hpp>
#include <sstream>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/mission/route_texts.h"

namespace tramline::io {

std::string gpx_text(const Plan& plan, const std::vector<WayPoint>& route) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("gpx");
  root.append_attribute("version") = "1.1";
  root.append_attribute("creator") = "tramline";
  root.append_attribute("xmlns") = "http://www.topografix.com/GPX/1/1";
  pugi::xml_node track = root.append_child("trk");
  track.append_child("name").text() = plan.field.id.c_str();
  pugi::xml_node segment = track.append_child("trkseg");
  const FrameProjection projection(plan.field.frame);
  for (const WayPoint& point : route) {
    const Point lonlat = projection.to_lonlat(point.at);
    pugi::xml_node node = segment.append_child("trkpt");
    node.append_attribute("lat") = fmt::format("{:.9f}", lonlat.y).c_str();
    node.append_attribute("lon") = fmt::format("{:.9f}", lonlat.x).c_str();
  }
  std::ostringstream text;
  document.save(text, " ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace tramline::io
