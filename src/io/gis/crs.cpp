#include "io/gis/crs.hpp"

#include <string_view>

#include <cpl_conv.h>
#include <fmt/format.h>

namespace sabo {

OGRSpatialReference crs_of(const std::string& wkt) {
  OGRSpatialReference crs;
  if (!wkt.empty()) crs.importFromWkt(wkt.c_str());
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

bool is_unknown(const OGRSpatialReference& crs) {
  const char* name = crs.GetName();
  return crs.IsEmpty() || crs.IsLocal() || !name || std::string_view(name).starts_with("Undefined");
}

OGRSpatialReference horizontal(const OGRSpatialReference& crs) {
  OGRSpatialReference copy(crs);
  copy.StripVertical();
  copy.DemoteTo2D(nullptr);
  copy.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return copy;
}

std::string wkt_of(const OGRSpatialReference& crs) {
  if (crs.IsEmpty()) return "";
  const char* const options[] = {"FORMAT=WKT2_2019", "MULTILINE=NO", nullptr};
  char* text = nullptr;
  crs.exportToWkt(&text, options);
  std::string wkt = text ? text : "";
  CPLFree(text);
  return wkt;
}

std::string code_of(const OGRSpatialReference& crs) {
  constexpr int sure = 90;  // percent: equal but for names and rounding
  int count = 0;
  int* confidence = nullptr;
  OGRSpatialReferenceH* matches = crs.FindMatches(nullptr, &count, &confidence);
  std::string code;
  if (count > 0 && confidence[0] >= sure) {
    const auto* best = OGRSpatialReference::FromHandle(matches[0]);
    const char* authority = best->GetAuthorityName(nullptr);
    const char* number = best->GetAuthorityCode(nullptr);
    if (authority && number) code = fmt::format("{}:{}", authority, number);
  }
  OSRFreeSRSArray(matches);
  CPLFree(confidence);
  return code;
}

std::string name_of(const OGRSpatialReference& crs) {
  const char* name = crs.GetName();
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  const std::string title = name ? name : "unnamed";
  return authority && code ? fmt::format("{}:{} ({})", authority, code, title) : title;
}

bool is_web_mercator(const OGRSpatialReference& crs) {
  const char* name = crs.GetName();
  return name && std::string_view(name).find("Pseudo-Mercator") != std::string_view::npos;
}

bool same_place(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  const char* const options[] = {"CRITERION=EQUIVALENT", "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 nullptr};
  const OGRSpatialReference first = horizontal(a);
  const OGRSpatialReference second = horizontal(b);
  return first.IsSame(&second, options);
}

}  // namespace sabo
