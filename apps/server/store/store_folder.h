#pragma once
// The folder in which a server stores its files.

#include <filesystem>
#include <string>
#include <vector>

namespace tramline::server {

/// $XDG_DATA_HOME/tramline, or ~/.local/share/tramline. Throws failure where the system knows no home.
std::filesystem::path default_folder();

/// Reads what somebody else may be deleting: where that fails, and `still_there` throws that it is gone, then
/// that is what went wrong.
template <class StillThere, class Read>
auto while_kept(StillThere&& still_there, Read&& read) {
  try {
    return read();
  } catch (...) {
    still_there();
    throw;
  }
}

/// Belongs to one server at a time; the system itself gives it back when the server ends, however it ends.
class StoreFolder {
 public:
  /// Makes the folder where it is missing. Throws bad_input where that cannot be, where nothing can be
  /// written into it, and where another server has it.
  explicit StoreFolder(std::filesystem::path path);
  StoreFolder(const StoreFolder&) = delete;
  StoreFolder& operator=(const StoreFolder&) = delete;
  ~StoreFolder();

  const std::filesystem::path& path() const { return path_; }
  /// The folder of that name in this one, made where it is missing. Throws failure where it cannot be made,
  /// and where the store itself has been removed: a new folder in its place would not be locked by anybody.
  std::filesystem::path part(const char* name) const;
  /// "plans/20260314-081500-k3f9ab.gpkg", the folder of that kind made as part() does. Precondition:
  /// is_id(id).
  std::filesystem::path file(const char* kind, const std::string& id, const char* extension = ".gpkg") const;
  /// Of the files of a kind, ascending.
  std::vector<std::string> ids(const char* kind, const char* extension = ".gpkg") const;

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace tramline::server
