#pragma once
// Small task sets and field folders.

#include <filesystem>
#include <string>
#include <vector>

#include "io/vector/files.h"

namespace tramline::testing_land {

inline std::string task_set(const std::string& inside) {
  return R"(<?xml version="1.0"?><ISO11783_TaskData VersionMajor="4">)" + inside + "</ISO11783_TaskData>";
}

/// PNT elements.
inline std::string places(const std::vector<Point>& lonlat) {
  std::string out;
  for (const Point p : lonlat)
    out += "<PNT A=\"2\" C=\"" + std::to_string(p.y) + "\" D=\"" + std::to_string(p.x) + "\"/>";
  return out;
}

inline std::string ring(const std::string& type, const std::vector<Point>& lonlat) {
  return "<LSG A=\"" + type + "\">" + places(lonlat) + "</LSG>";
}

/// A guidance group with one pattern. `kind`: 1 AB, 2 A+, 3 curve, 4 pivot, 5 spiral; `more`: attributes.
inline std::string pattern(int number, const std::string& name, int kind, const std::vector<Point>& lonlat,
                           const std::string& more = "") {
  const std::string n = std::to_string(number);
  return "<GGP A=\"GGP" + n + "\"><GPN A=\"GPN" + n + "\" B=\"" + name + "\" C=\"" + std::to_string(kind) +
         "\" " + more + "><LSG A=\"5\">" + places(lonlat) + "</LSG></GPN></GGP>";
}

class LandFiles : public testing_files::Files {
 protected:
  /// A field folder of AgOpenGPS started at 52° N, 5° E, with a square of 100 m.
  std::string write_folder(const std::string& name, const std::string& tracks) const {
    std::filesystem::create_directories(folder_ / name);
    write(name + "/Field.txt", "x\n$FieldDir\nmill\n$Offsets\n0,0\nConvergence\n0\nStartFix\n52.0,5.0\n");
    write(name + "/Boundary.txt", "$Boundary\nFalse\n4\n0,0,0\n0,100,1.5\n100,100,3.1\n100,0,4.7\n");
    write(name + "/TrackLines.txt", "$TrackLines\n" + tracks);
    return path(name);
  }
};

}  // namespace tramline::testing_land
