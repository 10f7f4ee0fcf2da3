#include "tramline/io/vector/gdal_messages.h"

#include <cpl_error.h>

#include <algorithm>

namespace tramline::io {
namespace {

void CPL_STDCALL collect(CPLErr error_class, CPLErrorNum, const char* text) {
  static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->add(error_class, text);
}

}  // namespace

GdalMessages::GdalMessages() { CPLPushErrorHandlerEx(collect, this); }
GdalMessages::~GdalMessages() { CPLPopErrorHandler(); }

void GdalMessages::add(int error_class, const char* text) {
  if (error_class < CE_Failure) return;
  failed_ = true;
  last_ = text != nullptr ? text : "";
  // Further errors follow on this one.
  feature_too_large_ = feature_too_large_ || last_.find("OGR_GEOJSON_MAX_OBJ_SIZE") != std::string::npos;
}

std::string GdalMessages::last() const {
  // Libraries below GDAL add hints on further lines.
  std::string out = last_.substr(0, last_.find('\n'));
  std::replace(out.begin(), out.end(), '\t', ' ');
  while (!out.empty() && (out.back() == '.' || out.back() == ' ')) out.pop_back();
  return out.empty() ? "no reason given" : out;
}

void GdalMessages::clear() {
  failed_ = feature_too_large_ = false;
  last_.clear();
}

}  // namespace tramline::io
