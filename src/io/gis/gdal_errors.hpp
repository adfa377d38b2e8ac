#pragma once

#include <string>

namespace sabo {

/// Keeps what GDAL says instead of letting it print, from construction to destruction. Every use of
/// GDAL in this project happens inside the life of one; it registers the drivers at first use.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  bool failed() const { return !failure_.empty(); }
  /// The first error, or `otherwise` when GDAL gave none.
  std::string failure(const std::string& otherwise) const;
  /// The last warning; "" when there was none.
  const std::string& warning() const { return warning_; }

 private:
  static void keep(int severity, int number, const char* message);

  std::string failure_;
  std::string warning_;
};

}  // namespace sabo
