#include "io/gis/gdal_errors.hpp"

#include <cpl_error.h>
#include <gdal.h>

namespace sabo {

GdalErrors::GdalErrors() {
  [[maybe_unused]] static const bool registered = [] {
    GDALAllRegister();
    return true;
  }();
  const auto handler = [](CPLErr severity, CPLErrorNum number, const char* message) {
    keep(severity, number, message);
  };
  CPLPushErrorHandlerEx(handler, this);
}

GdalErrors::~GdalErrors() { CPLPopErrorHandler(); }

std::string GdalErrors::failure(const std::string& otherwise) const {
  return failure_.empty() ? otherwise : failure_;
}

void GdalErrors::keep(int severity, int, const char* message) {
  auto* self = static_cast<GdalErrors*>(CPLGetErrorHandlerUserData());
  std::string text = message;
  if (text.ends_with('.')) text.pop_back();  // becomes part of a sentence of ours
  if (severity >= CE_Failure && self->failure_.empty()) self->failure_ = text;
  if (severity == CE_Warning) self->warning_ = text;
}

}  // namespace sabo
