#pragma once
// GDAL's messages, collected instead of printed.

#include <string>

namespace tramline::io {

/// While it lives, GDAL prints nothing on this thread; errors are kept. Not copyable, strictly nested.
class GdalMessages {
 public:
  GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;
  ~GdalMessages();

  bool failed() const { return failed_; }
  /// The last error, on one line and without a final full stop; "no reason given" when there was none.
  std::string last() const;
  /// Whether a feature was too large for the driver of GeoJSON (start_gdal.cpp says how large it may be).
  bool feature_too_large() const { return feature_too_large_; }
  void clear();
  /// Called by GDAL through the handler.
  void add(int error_class, const char* text);

 private:
  bool failed_ = false, feature_too_large_ = false;
  std::string last_;
};

}  // namespace tramline::io
