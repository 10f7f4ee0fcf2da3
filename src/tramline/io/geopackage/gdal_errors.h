#pragma once
// Catches GDAL's errors: a library never prints.

#include <cpl_error.h>

#include <string>

namespace tramline::io {

/// While alive, keeps what GDAL reports on this thread instead of printing it. Warnings are ignored.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  bool any() const { return !first_.empty(); }
  /// The first failure reported, as GDAL words it; empty when there was none.
  const std::string& first() const { return first_; }

 private:
  static void CPL_STDCALL keep(CPLErr severity, CPLErrorNum number, const char* text);
  std::string first_;
};

}  // namespace tramline::io
