#include "tramline/io/vector/own_content.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <istream>
#include <memory>
#include <streambuf>
#include <string_view>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/json_crs.h"
#include "tramline/io/vector/json_size.h"
#include "tramline/io/vector/locate_dataset.h"
#include "tramline/io/vector/lower_case.h"
#include "tramline/io/vector/vsi_file.h"

namespace tramline::io {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18;
/// What stands before the first element of XML, and the head of a MapInfo table.
constexpr std::size_t kHead = std::size_t{1} << 16;
/// Longer than anything that is looked for.
constexpr std::size_t kOverlap = 64;
constexpr std::size_t kMostKml = std::size_t{48} << 20;
/// Kept whole, in ten times the memory: GDAL's own limit, OGR_GEOJSON_MAX_OBJ_SIZE, is for the features of
/// collections only.
constexpr std::size_t kMostJsonValue = std::size_t{64} << 20;

std::size_t size_of(const std::string& name) {
  VSIStatBufL status;
  return VSIStatL(name.c_str(), &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

/// A file of GDAL's as a stream.
class FileBuffer final : public std::streambuf {
 public:
  explicit FileBuffer(VSILFILE* file) : file_(file), block_(kBlock) {}
  /// Read so far, to a block.
  std::size_t bytes() const { return bytes_; }

 protected:
  int_type underflow() override {
    const std::size_t got = VSIFReadL(block_.data(), 1, block_.size(), file_);
    if (got == 0) return traits_type::eof();
    bytes_ += got;
    setg(block_.data(), block_.data(), block_.data() + got);
    return traits_type::to_int_type(block_.front());
  }

 private:
  VSILFILE* file_;
  std::vector<char> block_;
  std::size_t bytes_ = 0;
};

/// The first bytes, letters only: without the zeros that UTF-16 and UTF-32 have between them, a mark of the
/// byte order, and white space.
std::string head_of(const std::string& name) {
  const VsiFile file = opened_to_read(name);
  if (!file) return {};
  std::string out(kHead, '\0');
  out.resize(VSIFReadL(out.data(), 1, out.size(), file.get()));
  if (out.starts_with("SQLite format 3")) return out;
  std::erase(out, '\0');
  for (const std::string_view mark : {"\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF"})
    if (out.starts_with(mark)) out.erase(0, mark.size());
  out.erase(0, std::min(out.find_first_not_of(" \t\r\n"), out.size()));
  return out;
}

/// Does the file hold bytes of which `has` says so? It is given overlapping pieces.
bool any_piece(const std::string& name, const std::function<bool(std::string_view)>& has) {
  const VsiFile file = opened_to_read(name);
  if (!file) return false;
  std::string piece;
  std::vector<char> block(kBlock);
  for (std::size_t got = 0; (got = VSIFReadL(block.data(), 1, block.size(), file.get())) > 0;) {
    piece.erase(0, piece.size() - std::min(piece.size(), kOverlap));
    piece.append(block.data(), got);
    if (has(piece)) return true;
  }
  return false;
}

Error points_elsewhere(const std::string& shown, const std::string& at, const std::string& what_to_do) {
  return bad_input(fmt::format("'{}' {}, and a file may not lead elsewhere; {}", shown, at, what_to_do));
}

/// "http://www.opengis.net/def/crs/EPSG/0/4326" is a name; PROJ knows it without asking anybody.
bool is_well_known(const std::string& place) {
  for (const char* start : {"http://www.opengis.net/", "https://www.opengis.net/", "http://opengis.net/",
                            "https://opengis.net/", "http://spatialreference.org/ref/epsg/"})
    if (place.starts_with(start)) return true;
  return false;
}

bool is_address_or_path(const std::string& place) {
  constexpr std::array<std::string_view, 8> kStarts = {
      "http:", "https:", "ftp:", "file:", "/", "\\", "./", "../"};
  const bool starts = std::any_of(kStarts.begin(), kStarts.end(),
                                  [&](std::string_view start) { return place.starts_with(start); });
  return starts || place.ends_with(".prj") || place.ends_with(".wkt");
}

/// GDAL keeps a value that is no collection of features whole, in twenty-five times its size.
void require_readable_json(const std::string& name, const std::string& shown) {
  const std::size_t size = size_of(name);
  if (size <= kMostJsonValue) return;
  const VsiFile file = opened_to_read(name);
  FileBuffer buffer(file.get());
  std::istream text(&buffer);
  if (has_large_json_value(
          text, [&] { return buffer.bytes(); }, size, kMostJsonValue))
    throw bad_input(fmt::format(
        "'{}' holds JSON of more than {} MB that is no collection of features; save it as a GeoPackage",
        shown, kMostJsonValue >> 20));
}

void look_at_json(const std::string& name, const std::string& shown) {
  require_readable_json(name, shown);
  // An escaped letter may hide the word.
  if (!any_piece(name, [](std::string_view piece) {
        return piece.find("crs\"") != std::string_view::npos || piece.find("\\u") != std::string_view::npos;
      }))
    return;
  const VsiFile file = opened_to_read(name);
  FileBuffer buffer(file.get());
  std::istream text(&buffer);
  each_json_crs(text, [&](const std::string& type, const std::string& place) {
    const std::string kind = lower_case(type), at = lower_case(place);
    const bool link = kind == "link" || kind == "url";
    if (!link && (is_well_known(at) || !is_address_or_path(at))) return;
    throw points_elsewhere(
        shown, fmt::format("takes its coordinate reference system (\"crs\") from '{}'", place),
        "name the system instead, as urn:ogc:def:crs:EPSG::25832, or save the file again in longitude and "
        "latitude without a \"crs\"");
  });
}

/// The text from the first element on, or from a document type: what comes before it is passed over.
std::string_view after_prolog(std::string_view text) {
  while (true) {
    text.remove_prefix(std::min(text.find('<'), text.size()));
    const bool comment = text.starts_with("<!--");
    if (!comment && !text.starts_with("<?")) return text;
    const std::string_view end = comment ? "-->" : "?>";
    const std::size_t at = text.find(end);
    if (at == std::string_view::npos) return {};
    text.remove_prefix(at + end.size());
  }
}

/// GDAL keeps all of a KML at once, in twelve times its size.
void require_readable_kml(const std::string& name, const std::string& shown) {
  if (size_of(name) <= kMostKml) return;
  throw bad_input(fmt::format("'{}' holds more than {} MiB of KML; save it as a GeoPackage, or split it",
                              shown, kMostKml >> 20));
}

void look_at_xml(const std::string& name, const std::string& head, const std::string& shown) {
  const std::string_view root = after_prolog(head);
  if (root.empty() && head.size() > kHead / 4)
    throw bad_input(
        fmt::format("'{}' has no element in its first {} KiB; export it again", shown, kHead >> 10));
  if (lower_case(root.substr(0, 9)) == "<!doctype")
    throw points_elsewhere(shown,
                           "declares a document type (<!DOCTYPE>), whose entities may stand in other files",
                           "remove that declaration, or export the file again");
  if (root.starts_with("<kml")) require_readable_kml(name, shown);
  for (const char* description :
       {"<OGRVRT", "<VRTDataset", "<OGRWFS", "<OGCAPI", "<GDAL_WM", "<CSW", "<WMS_", "<WCS_"})
    if (root.starts_with(description))
      throw points_elsewhere(shown,
                             fmt::format("only describes data that are somewhere else ({}…>)", description),
                             "name the file that holds them");
}

/// A KMZ is a zip that GDAL unpacks by itself.
void look_at_kmz(const std::string& name, const std::string& shown) {
  const std::string root = "/vsizip/{" + name + "}";
  const CPLStringList entries(VSIReadDirRecursive(root.c_str()));
  for (int i = 0; i < entries.size(); ++i)
    if (lower_case(entries[i]).ends_with(".kml")) {
      const std::string inner = root + "/" + entries[i];
      look_at_xml(inner, head_of(inner), shown);
    }
}

void look_at_table(const std::string& head, const std::string& shown) {
  const std::string text = lower_case(head);
  if (text.find("isseamless") != std::string::npos || text.find("create view") != std::string::npos)
    throw points_elsewhere(shown, "is a MapInfo table made of other tables", "name the tables themselves");
}

void look_at_database(const std::string& name, const std::string& shown) {
  constexpr std::array<std::string_view, 6> kReaders = {"virtualtext", "virtualshape",   "virtualdbf",
                                                        "virtualxl",   "virtualgeojson", "virtualogr"};
  std::string found;
  any_piece(name, [&](std::string_view piece) {
    const std::string text = lower_case(piece);
    for (const std::string_view reader : kReaders)
      if (text.find(reader) != std::string::npos && text.find("virtual table") != std::string::npos)
        found = reader;
    return !found.empty();
  });
  if (!found.empty())
    throw points_elsewhere(shown, fmt::format("has a virtual table ({}) that reads another file", found),
                           "copy its rows into a plain table, or name that file");
}

}  // namespace

void require_own_content(const std::string& name, const std::string& shown) {
  if (is_folder(name)) return;
  const GdalMessages silence;
  const std::string head = head_of(name);
  if (head.starts_with("SQLite format 3")) return look_at_database(name, shown);
  if (head.starts_with("PK") && lower_case(name).ends_with(".kmz")) return look_at_kmz(name, shown);
  if (head.starts_with('<')) return look_at_xml(name, head, shown);
  if (lower_case(head.substr(0, 6)) == "!table") return look_at_table(head, shown);
  const bool json = head.starts_with('{') || head.starts_with('[') || head.starts_with('\x1e');
  if (json) look_at_json(name, shown);
}

}  // namespace tramline::io
