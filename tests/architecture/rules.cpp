#include "architecture/rules.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

namespace tramline::architecture {
namespace {

using Names = std::set<std::string, std::less<>>;

// Rooms on one floor do not know one another, with the exceptions below.
const std::vector<Names> kFloors = {{"geometry"}, {"model"},    {"geodesy", "admission", "coverage"},
                                    {"turns"},    {"headland"}, {"decomposition"},
                                    {"tracks"},   {"cost"},     {"avoidance"},
                                    {"route"},    {"planner"}};

const std::map<std::string, Names, std::less<>> kBeside = {
    {"check", {"geometry", "model", "coverage"}},
    {"io", {"geometry", "model", "geodesy"}},
    {"render", {"geometry", "model"}},
};

// The exceptions, each with its reason: admission measures faults in metres, so it projects first.
const std::set<std::pair<std::string, std::string>> kAlongAFloor = {{"admission", "geodesy"}};

// Of a room that may be used, what else is out of bounds: the verifier finds lines, bands and areas by roads
// of its own, so of geometry it takes shapes and measures, and nothing that plans are made with.
const std::map<std::pair<std::string, std::string>, Names> kOnlyHeaders = {
    {{"check", "geometry"},
     {"angle.h", "boolean.h", "box_grid.h", "convex_clip.h", "line_crossing.h", "path.h", "point.h",
      "tolerances.h", "region.h", "steered_path.h"}},
};

struct ThirdParty {
  std::string_view header_prefix;
  Names rooms;  ///< empty: everywhere
  bool only_in_cpp = false;
};

const std::array kThirdParty = {
    ThirdParty{"geos_c.h", {"geometry"}},
    ThirdParty{"polyclipping/", {"geometry"}},
    ThirdParty{"clipper", {"geometry"}},
    ThirdParty{"proj.h", {"geodesy"}},
    ThirdParty{"gdal", {"io"}},
    ThirdParty{"ogr", {"io"}},
    ThirdParty{"cpl_", {"io"}},
    ThirdParty{"zlib.h", {"io", "apps"}},
    ThirdParty{"cairo", {"render"}},
    ThirdParty{"coin/", {"planner"}, true},
    ThirdParty{"tbb/", {"planner", "coverage", "apps", "python"}, true},
    ThirdParty{"oneapi/", {"planner", "coverage", "apps", "python"}, true},
    ThirdParty{"pugixml", {"io", "apps"}},
    ThirdParty{"nlohmann/", {"io", "apps", "python"}},
    ThirdParty{"toml++/", {"io", "apps"}},
    ThirdParty{"CLI/", {"apps"}},
    ThirdParty{"pybind11/", {"python"}},
    ThirdParty{"Python.h", {"python"}},
    ThirdParty{"httplib.h", {"apps"}},
    ThirdParty{"spdlog/", {"apps"}},
    ThirdParty{"fmt/", {}},
    ThirdParty{"unistd.h", {}},
    ThirdParty{"fcntl.h", {}},
    ThirdParty{"malloc.h", {"apps"}},
    ThirdParty{"sys/", {}},
    ThirdParty{"poll.h", {"io", "apps"}},
    ThirdParty{"termios.h", {"io", "apps"}},
    ThirdParty{"signal.h", {"apps"}},
    ThirdParty{"pthread.h", {"apps"}},
    ThirdParty{"netdb.h", {"io"}},
    ThirdParty{"netinet/", {"io", "apps"}},
    ThirdParty{"net/if.h", {"apps"}},
    ThirdParty{"arpa/inet.h", {"apps"}},
    ThirdParty{"ifaddrs.h", {"apps"}},
};

const std::map<std::string, Names, std::less<>> kLibraries = {
    {"PkgConfig::GEOS", {"geometry"}},
    {"PROJ::proj", {"geodesy"}},
    {"PkgConfig::GDAL", {"io"}},
    {"ZLIB::ZLIB", {"io"}},
    {"PkgConfig::CAIRO", {"render"}},
    {"PkgConfig::CLP", {"planner"}},
    {"TBB::tbb", {"planner", "coverage"}},
    {"nlohmann_json::nlohmann_json", {"io"}},
    {"PkgConfig::TOMLPP", {"io"}},
    {"pugixml::pugixml", {"io"}},
    {"fmt::fmt", {}},
    {"Threads::Threads", {}},
};

bool allowed_in(const Names& rooms, std::string_view room) { return rooms.empty() || rooms.contains(room); }

std::string list(const Names& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

std::optional<std::size_t> floor_of(std::string_view room) {
  for (std::size_t i = 0; i < kFloors.size(); ++i)
    if (kFloors[i].contains(room)) return i;
  return std::nullopt;
}

bool is_room(std::string_view name) { return floor_of(name) || kBeside.contains(name); }

// Above the tower and the rooms beside it: what is made of all of them.
const Names kFaces = {"apps", "python"};

// "src/tramline/geometry/tolerances.h" and "include/tramline/geometry/point.h" are in geometry,
// "apps/tramline/main.cpp" in apps, "python/src/module.cpp" in python.
std::string room_of(const std::string& path) {
  for (const std::string& face : kFaces)
    if (path.starts_with(face + "/")) return face;
  const std::size_t root = path.find('/');
  const bool library = path.starts_with("src/tramline/") || path.starts_with("include/tramline/");
  if (!library) return "";
  const std::string inside = path.substr(root + std::string_view("/tramline/").size());
  const std::size_t slash = inside.find('/');
  return slash == std::string::npos ? "" : inside.substr(0, slash);
}

bool is_standard(const std::string& header) { return header.find_first_of("./") == std::string::npos; }

// The reason why `room` must not include `header`, a header that is not the project's.
std::optional<std::string> fault_of_foreign(const std::string& header, const std::string& room, bool in_cpp) {
  if (is_standard(header)) return std::nullopt;
  for (const ThirdParty& known : kThirdParty) {
    if (!header.starts_with(known.header_prefix)) continue;
    if (!allowed_in(known.rooms, room)) return "this library belongs in " + list(known.rooms) + " only";
    if (known.only_in_cpp && !in_cpp) return "this library may be included in .cpp files only";
    return std::nullopt;
  }
  return "no room has been given to this library (see the table in tests/architecture/rules.cpp)";
}

std::optional<std::string> fault_of_own(const std::string& header, const std::string& room) {
  constexpr std::string_view kPrefix = "tramline/";
  const std::string target = header.substr(kPrefix.size(), header.find('/', kPrefix.size()) - kPrefix.size());
  if (!is_room(target)) return "there is no room named '" + target + "'";
  if (!may_use(room, target)) return room + " may not use " + target;
  const auto only = kOnlyHeaders.find({room, target});
  const std::string file = header.substr(header.rfind('/') + 1);
  if (only != kOnlyHeaders.end() && !only->second.contains(file))
    return room + " may use of " + target + " only " + list(only->second);
  return std::nullopt;
}

std::optional<std::string> fault_of_quoted(const std::string& header, const std::string& room, bool in_cpp) {
  if (header.starts_with("tramline/")) return fault_of_own(header, room);
  if (header.find("..") != std::string::npos)
    return "paths that climb are not used; write tramline/ROOM/FILE";
  if (header.starts_with("python/")) return "the Python package is used by nothing else";
  if (kFaces.contains(room)) return std::nullopt;  // a header beside the file, or of another app
  if (header.starts_with("apps/")) return "the library knows no program";
  const auto fault = fault_of_foreign(header, room, in_cpp);
  return fault ? "write headers of the project as tramline/ROOM/FILE; otherwise: " + *fault : fault;
}

// A room may be built as several modules, each named after it: io_plan and io_vector make up io.
std::string room_of_module(const std::string& module) { return module.substr(0, module.find('_')); }

std::string without_comments(const std::string& cmake) {
  return std::regex_replace(cmake, std::regex("#[^\n]*"), "");
}

}  // namespace

std::string describe(const Violation& violation) {
  return violation.file + ":" + std::to_string(violation.line) + ": " + violation.subject + ": " +
         violation.why;
}

std::vector<std::string> rooms() {
  std::vector<std::string> out;
  for (const Names& floor : kFloors) out.insert(out.end(), floor.begin(), floor.end());
  for (const auto& [room, _] : kBeside) out.push_back(room);
  return out;
}

bool may_use(std::string_view from, std::string_view to) {
  if (from == to || kFaces.contains(from)) return true;
  if (const auto beside = kBeside.find(from); beside != kBeside.end()) return beside->second.contains(to);
  if (kAlongAFloor.contains({std::string(from), std::string(to)})) return true;
  const auto upper = floor_of(from);
  const auto lower = floor_of(to);
  return upper && lower && *lower < *upper;
}

std::vector<Violation> check_includes(const std::string& path, const std::string& text) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
  const std::string room = room_of(path);
  if (!kFaces.contains(room) && !is_room(room))
    return {{path, 0, path, "there is no room named '" + room + "'"}};

  std::vector<Violation> out;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_match(line, match, kInclude)) continue;
    const std::string header = match[2];
    const bool own = match[1] == "\"" || header.starts_with("tramline/");
    const bool in_cpp = path.ends_with(".cpp");
    const auto fault = own ? fault_of_quoted(header, room, in_cpp) : fault_of_foreign(header, room, in_cpp);
    if (fault) out.push_back({path, number, header, *fault});
  }
  return out;
}

std::vector<Violation> check_links(const std::string& path, const std::string& text) {
  static const std::regex kModule(R"(tramline_module\(([^)]*)\))");
  const std::string room = room_of(path);
  const std::string code = without_comments(text);
  std::vector<Violation> out;
  for (std::sregex_iterator call(code.begin(), code.end(), kModule), end; call != end; ++call) {
    std::istringstream words((*call)[1]);
    std::string name;
    words >> name;
    if (room_of_module(name) != room)
      out.push_back(
          {path, 0, name, "the modules of this folder are named " + room + " or " + room + "_PART"});
    bool in_links = false;
    for (std::string word; words >> word;) {
      if (word == "SOURCES" || word == "LINKS" || word == "PRIVATE_LINKS") {
        in_links = word != "SOURCES";
      } else if (in_links && word.starts_with("tramline::")) {
        const std::string target = room_of_module(word.substr(std::string_view("tramline::").size()));
        if (!is_room(target) || !may_use(room, target))
          out.push_back({path, 0, word, room + " may not use " + target});
      } else if (in_links) {
        const auto library = kLibraries.find(word);
        if (library == kLibraries.end())
          out.push_back({path, 0, word, "no room has been given to this library"});
        else if (!allowed_in(library->second, room))
          out.push_back({path, 0, word, "this library belongs in " + list(library->second) + " only"});
      }
    }
  }
  return out;
}

}  // namespace tramline::architecture
