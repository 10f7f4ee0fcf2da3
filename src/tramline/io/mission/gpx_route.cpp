#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/mission/route_texts.h"

namespace tramline::io {

namespace {

pugi::xml_node root_of(pugi::xml_document& document) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("gpx");
  root.append_attribute("version") = "1.1";
  root.append_attribute("creator") = "tramline";
  root.append_attribute("xmlns") = "http://www.topografix.com/GPX/1/1";
  return root;
}

pugi::xml_node add_gpx_point(pugi::xml_node parent, const char* element, Point lonlat) {
  pugi::xml_node node = parent.append_child(element);
  node.append_attribute("lat") = fmt::format("{:.9f}", lonlat.y).c_str();
  node.append_attribute("lon") = fmt::format("{:.9f}", lonlat.x).c_str();
  return node;
}

/// XML has no control characters, not even as numbers.
std::string without_controls(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20; }, '_');
  return text;
}

pugi::xml_node add_track(pugi::xml_node root, const std::string& name) {
  pugi::xml_node track = root.append_child("trk");
  track.append_child("name").text() = without_controls(name).c_str();
  return track.append_child("trkseg");
}

std::string text_in(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, " ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace

std::string gpx_text(const Plan& plan, const std::vector<WayPoint>& route) {
  pugi::xml_document document;
  pugi::xml_node segment = add_track(root_of(document), plan.field.id);
  const FrameProjection projection(plan.field.frame);
  for (const WayPoint& point : route) add_gpx_point(segment, "trkpt", projection.to_lonlat(point.at));
  return text_in(document);
}

std::string gaps_gpx_text(const LocalFrame& frame, const std::vector<Gap>& gaps,
                          const std::vector<NamedTrack>& tracks) {
  pugi::xml_document document;
  pugi::xml_node root = root_of(document);
  const FrameProjection projection(frame);
  const auto add = [&](const std::string& name, const std::vector<Point>& line) {
    pugi::xml_node segment = add_track(root, name);
    for (const Point p : line) add_gpx_point(segment, "trkpt", projection.to_lonlat(p));
    return segment;
  };
  // Places come before tracks (GPX 1.1).
  for (const Gap& gap : gaps) {
    pugi::xml_node place = add_gpx_point(root, "wpt", projection.to_lonlat(gap.centre));
    place.append_child("name").text() = fmt::format("Gap {}", gap.number).c_str();
    place.append_child("desc").text() = fmt::format("{:.1f} m²", gap.area_m2).c_str();
  }
  for (const Gap& gap : gaps) {
    pugi::xml_node segment = add(fmt::format("Gap {}", gap.number), gap.shape.outer);
    add_gpx_point(segment, "trkpt", projection.to_lonlat(gap.shape.outer.front()));
  }
  for (const NamedTrack& track : tracks) add(track.name, track.points);
  return text_in(document);
}

}  // namespace tramline::io
