#include "tramline/io/gdal/start_gdal.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi_virtual.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <string_view>
#include <utility>
#include <vector>

namespace tramline::io {
namespace {

std::atomic<int> allowed{0};

constexpr std::array<std::pair<const char*, const char*>, 11> kSettings = {{
    {"GML_DOWNLOAD_SCHEMA", "NO"},
    {"GML_DOWNLOAD_WFS_SCHEMA", "NO"},
    {"GML_SKIP_RESOLVE_ELEMS", "ALL"},
    // Xerces follows external entities; Expat leaves them alone.
    {"GML_PARSER", "EXPAT"},
    {"LIBKML_EXTERNAL_STYLE", "NO"},
    {"LIBKML_RESOLVE_STYLE", "NO"},
    // SpatiaLite has virtual tables that read any file of the machine.
    {"SPATIALITE_LOAD", "NO"},
    // MB of memory for a feature, by the driver's own estimate: some 1.2 million corners. It takes four times
    // that.
    {"OGR_GEOJSON_MAX_OBJ_SIZE", "200"},
    // Nothing is written beside a file that is read.
    {"CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO"},
    {"OGR_SQLITE_LIST_VIRTUAL_OGR", "NO"},
    {"OGR_SQLITE_STATIC_VIRTUAL_OGR", "NO"},
}};

/// Instead of every fetch over HTTP.
CPLHTTPResult* refuse_fetch(const char* url, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc,
                            void*, void*) {
  CPLError(CE_Failure, CPLE_HttpResponse, "%s is not fetched", url);
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("nothing is fetched for a file");
  return result;
}

/// Stands before a file system of the network, and lets through what is allowed.
class Barred final : public VSIFilesystemHandler {
 public:
  explicit Barred(VSIFilesystemHandler& behind) : behind_(behind) {}

  VSIVirtualHandle* Open(const char* name, const char* access, bool set_error,
                         CSLConstList options) override {
    return allowed > 0 ? behind_.Open(name, access, set_error, options) : nullptr;
  }
  int Stat(const char* name, VSIStatBufL* status, int flags) override {
    return allowed > 0 ? behind_.Stat(name, status, flags) : -1;
  }
  char** ReadDirEx(const char* folder, int most) override {
    return allowed > 0 ? behind_.ReadDirEx(folder, most) : nullptr;
  }

 private:
  VSIFilesystemHandler& behind_;
};

/// Nothing but this machine's memory, archives and parts of files.
bool is_local(std::string_view prefix) {
  constexpr std::array<std::string_view, 8> kLocal = {"/vsimem/", "/vsizip/", "/vsigzip/",    "/vsitar/",
                                                      "/vsi7z/",  "/vsirar/", "/vsisubfile/", "/vsistdout/"};
  return std::find(kLocal.begin(), kLocal.end(), prefix) != kLocal.end();
}

/// GDAL deletes the bars at the end of the process; those behind them are not deleted, because some stand
/// under several names.
void bar_network_folders() {
  static auto* const behind = new std::vector<VSIFilesystemHandler*>;
  const CPLStringList prefixes(VSIFileManager::GetPrefixes());
  for (int i = 0; i < prefixes.size(); ++i) {
    if (is_local(prefixes[i])) continue;
    behind->push_back(VSIFileManager::GetHandler(prefixes[i]));
    VSIFileManager::InstallHandler(prefixes[i], new Barred(*behind->back()));
  }
}

}  // namespace

void start_gdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    for (const auto& [key, value] : kSettings) CPLSetConfigOption(key, value);
    CPLHTTPSetFetchCallback(refuse_fetch, nullptr);
    OSRSetPROJEnableNetwork(0);
    bar_network_folders();
  });
}

ConnectionsAllowed::ConnectionsAllowed() {
  if (++allowed == 1) CPLHTTPSetFetchCallback(nullptr, nullptr);
}

ConnectionsAllowed::~ConnectionsAllowed() {
  if (--allowed == 0) CPLHTTPSetFetchCallback(refuse_fetch, nullptr);
}

}  // namespace tramline::io
