#include "tramline/io/terminal/task_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "tramline/geodesy/field_projection.h"
#include "tramline/io/terminal/designators.h"

namespace tramline::io {
namespace {

// Words of ISO 11783-10, annex D. Version 3 knows the first eight kinds of polygons and five of points only;
// it has no word for a headland, for which the one of version 4 is written all the same, since readers ask
// for that.
namespace polygon_type {
constexpr int kBoundary = 1, kObstacle = 6, kOther = 8, kHeadland = 10;
}
namespace line_type {
constexpr int kExterior = 1, kInterior = 2, kGuidance = 5;
}
namespace point_type {
constexpr int kOther = 2, kA = 6, kB = 7, kGuidance = 9;
}
namespace pattern {
constexpr int kAb = 1, kCurve = 3;               // C
constexpr int kBothSides = 1, kNoParallels = 4;  // E
constexpr int kNotProlonged = 4;                 // F
constexpr int kFromDesktop = 16;                 // I
}  // namespace pattern
constexpr int kPlannedTask = 1, kFromOffice = 1;
constexpr double kMillimetres = 1000, kLargestNumber = 4294967294.0;

/// Writes one field after the other into the root element.
class SetWriter {
 public:
  SetWriter(pugi::xml_node root, const TaskSetStyle& style) : root_(root), style_(style) {}

  void add_owner() {
    pugi::xml_node customer = root_.append_child("CTR");
    customer.append_attribute("A") = "CTR1";
    customer.append_attribute("B") = shown(style_.customer, "Customer").c_str();
    pugi::xml_node farm = root_.append_child("FRM");
    farm.append_attribute("A") = "FRM1";
    farm.append_attribute("B") = shown(style_.farm, "Farm").c_str();
    farm.append_attribute("I") = "CTR1";
  }

  void add_field(const TerminalField& field) {
    const FrameProjection projection(field.frame);
    projection_ = &projection;
    ++fields_;
    const std::string name = field_names_.unique(field.name, fmt::format("Field {}", fields_));
    if (name != field.name) changed_.push_back({field.name, name});
    names_.push_back(name);
    pugi::xml_node partfield = root_.append_child("PFD");
    partfield.append_attribute("A") = fmt::format("PFD{}", fields_).c_str();
    partfield.append_attribute("C") = name.c_str();
    partfield.append_attribute("D") = fmt::format("{:.0f}", std::min(field.area_m2, kLargestNumber)).c_str();
    partfield.append_attribute("E") = "CTR1";
    partfield.append_attribute("F") = "FRM1";
    add_outlines(partfield, field);
    for (const TerminalLine& line : field.lines) add_guidance(partfield, field, line);
    projection_ = nullptr;
  }

  void add_tasks() {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      pugi::xml_node task = root_.append_child("TSK");
      task.append_attribute("A") = fmt::format("TSK{}", i + 1).c_str();
      task.append_attribute("B") = names_[i].c_str();
      task.append_attribute("C") = "CTR1";
      task.append_attribute("D") = "FRM1";
      task.append_attribute("E") = fmt::format("PFD{}", i + 1).c_str();
      task.append_attribute("G") = kPlannedTask;
    }
  }

  std::vector<ChangedName> changed() && { return std::move(changed_); }

 private:
  std::string shown(const std::string& name, const std::string& otherwise) {
    std::string out = Designators().unique(name, otherwise);
    if (out != name) changed_.push_back({name, out});
    return out;
  }

  Point add_point(pugi::xml_node line, int type, Point at) const {
    const Point lonlat = projection_->to_lonlat(at);
    pugi::xml_node point = line.append_child("PNT");
    point.append_attribute("A") = type;
    point.append_attribute("C") = fmt::format("{:.9f}", without_sign_of_zero(lonlat.y)).c_str();
    point.append_attribute("D") = fmt::format("{:.9f}", without_sign_of_zero(lonlat.x)).c_str();
    return lonlat;
  }

  /// What would print as -0.000000000 is zero.
  static double without_sign_of_zero(double degrees) { return std::abs(degrees) < 0.5e-9 ? 0 : degrees; }

  void add_ring(pugi::xml_node polygon, int type, const Ring& ring) const {
    pugi::xml_node line = polygon.append_child("LSG");
    line.append_attribute("A") = type;
    for (const Point corner : ring) add_point(line, point_type::kOther, corner);
    add_point(line, point_type::kOther, ring.front());
  }

  pugi::xml_node add_polygon(pugi::xml_node partfield, int type, const std::string& name,
                             const Polygon& shape) const {
    pugi::xml_node polygon = partfield.append_child("PLN");
    polygon.append_attribute("A") = type;
    if (!name.empty()) polygon.append_attribute("B") = name.c_str();
    add_ring(polygon, line_type::kExterior, shape.outer);
    for (const Ring& hole : shape.holes) add_ring(polygon, line_type::kInterior, hole);
    return polygon;
  }

  void add_outlines(pugi::xml_node partfield, const TerminalField& field) const {
    pugi::xml_node boundary = add_polygon(partfield, polygon_type::kBoundary, "", {field.outer, {}});
    for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
      const Obstacle& obstacle = field.obstacles[i];
      if (style_.obstacles == ObstacleStyle::kHoles) {
        add_ring(boundary, line_type::kInterior, reversed(obstacle.shape.outer));
        continue;
      }
      // No word means land that may be crossed with the work off.
      const bool passable = obstacle.kind == ObstacleKind::kPassable;
      add_polygon(partfield, passable ? polygon_type::kOther : polygon_type::kObstacle,
                  fmt::format("{} {}", passable ? "Passable" : "Obstacle", i + 1), obstacle.shape);
    }
    for (std::size_t i = 0; i < field.headland.size(); ++i)
      add_polygon(partfield, polygon_type::kHeadland, fmt::format("Headland {}", i + 1), field.headland[i]);
    // Treatment zones (2) belong into tasks, not into partfields.
    for (const NumberedGap& gap : field.gaps)
      add_polygon(partfield, polygon_type::kOther, fmt::format("Gap {}", gap.number), gap.shape);
  }

  void add_guidance(pugi::xml_node partfield, const TerminalField& field, const TerminalLine& line) {
    if (style_.version == TaskDataVersion::k3) {
      add_points(partfield, field, line);
      return;
    }
    ++patterns_;
    pugi::xml_node group = partfield.append_child("GGP");
    group.append_attribute("A") = fmt::format("GGP{}", patterns_).c_str();
    group.append_attribute("B") = line.name.c_str();
    pugi::xml_node guidance = group.append_child("GPN");
    guidance.append_attribute("A") = fmt::format("GPN{}", patterns_).c_str();
    guidance.append_attribute("B") = line.name.c_str();
    guidance.append_attribute("C") = line.straight() ? pattern::kAb : pattern::kCurve;
    guidance.append_attribute("E") = line.parallels ? pattern::kBothSides : pattern::kNoParallels;
    guidance.append_attribute("F") = pattern::kNotProlonged;
    if (line.straight()) {
      const Point a = projection_->to_lonlat(line.points.front());
      guidance.append_attribute("G") = fmt::format("{:.6f}", true_heading_deg(line, field.frame, a)).c_str();
    }
    guidance.append_attribute("I") = pattern::kFromDesktop;
    add_points(guidance, field, line);
  }

  void add_points(pugi::xml_node parent, const TerminalField& field, const TerminalLine& line) const {
    const bool typed = style_.version == TaskDataVersion::k4;
    pugi::xml_node string = parent.append_child("LSG");
    string.append_attribute("A") = line_type::kGuidance;
    string.append_attribute("B") = line.name.c_str();
    string.append_attribute("C") = static_cast<long long>(std::llround(field.width_m * kMillimetres));
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const int in_line = i == 0                        ? point_type::kA
                          : i + 1 == line.points.size() ? point_type::kB
                                                        : point_type::kGuidance;
      add_point(string, typed ? in_line : point_type::kOther, line.points[i]);
    }
  }

  pugi::xml_node root_;
  const TaskSetStyle& style_;
  const FrameProjection* projection_ = nullptr;
  Designators field_names_;
  std::vector<std::string> names_;
  std::vector<ChangedName> changed_;
  int fields_ = 0, patterns_ = 0;
};

}  // namespace

TaskSet task_set(const std::vector<TerminalField>& fields, const TaskSetStyle& style) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = document.append_child("ISO11783_TaskData");
  root.append_attribute("VersionMajor") = static_cast<int>(style.version);
  root.append_attribute("VersionMinor") = style.version == TaskDataVersion::k4 ? 2 : 3;
  root.append_attribute("ManagementSoftwareManufacturer") = "tramline";
  root.append_attribute("ManagementSoftwareVersion") = TRAMLINE_VERSION;
  root.append_attribute("TaskControllerManufacturer") = "";
  root.append_attribute("TaskControllerVersion") = "";
  root.append_attribute("DataTransferOrigin") = kFromOffice;
  SetWriter writer(root, style);
  writer.add_owner();
  for (const TerminalField& field : fields) writer.add_field(field);
  writer.add_tasks();
  std::ostringstream text;
  document.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
  return {text.str(), std::move(writer).changed()};
}

}  // namespace tramline::io
