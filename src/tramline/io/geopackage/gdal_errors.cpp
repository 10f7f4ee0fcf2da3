#include "tramline/io/geopackage/gdal_errors.h"

namespace tramline::io {

GdalErrors::GdalErrors() { CPLPushErrorHandlerEx(&GdalErrors::keep, this); }

GdalErrors::~GdalErrors() { CPLPopErrorHandler(); }

void CPL_STDCALL GdalErrors::keep(CPLErr severity, CPLErrorNum, const char* text) {
  auto* self = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
  if (severity < CE_Failure || self->any()) return;
  self->first_ = text != nullptr && *text != '\0' ? text : "unknown error";
}

}  // namespace tramline::io
