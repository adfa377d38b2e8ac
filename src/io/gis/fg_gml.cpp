#include "io/gis/fg_gml.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include <cpl_minixml.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/parsed_number.hpp"
#include "base/shown_text.hpp"
#include "io/gis/gdal_errors.hpp"

namespace sabo {
namespace {

constexpr const char* blanks = " \t\r\n";
constexpr double undefined_elevation = -9999;

struct XmlDeleter {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};

// Takes the word before the next blank off the text; "" at the end.
std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

class Document {
 public:
  Document(const std::string& text, const std::string& name)
      : name_(name), tree_(CPLParseXMLString(text.c_str())) {
    if (!tree_) {
      refuse("is no complete XML: " + errors_.failure("empty"), "download or unpack it again");
    }
    dem_ = CPLGetXMLNode(tree_.get(), "=Dataset.DEM");
    if (!dem_) {
      refuse("is no elevation model of the GSI base map (Dataset, DEM)",
             "give FG-GML files of a DEM, such as FG-GML-6444-11-DEM5A-20161001.xml");
    }
    for (const CPLXMLNode* next = dem_->psNext; next; next = next->psNext) {
      if (std::strcmp(next->pszValue, "DEM") == 0) refuse("holds more than one DEM", "split it");
    }
  }

  /// Text of an element or attribute below DEM; nullptr when there is none, or when comments or
  /// elements are in it.
  const char* find(const char* path) const {
    const CPLXMLNode* const node = CPLGetXMLNode(dem_, path);
    if (!node) return nullptr;
    const CPLXMLNode* content = node->psChild;
    while (content && content->eType == CXT_Attribute) content = content->psNext;
    return content ? CPLGetXMLValue(node, nullptr, nullptr) : "";
  }

  const char* text(const char* path) const {
    const char* const found = find(path);
    if (!found) {
      refuse(fmt::format("has no {}", std::string_view(path).substr(last_part(path))),
             "download it again");
    }
    return found;
  }

  /// Two numbers with a blank between them.
  template <class Number>
  std::array<Number, 2> pair(const char* path) const {
    std::string_view rest = text(path);
    const std::string_view whole = rest;
    const auto first = finite_number<Number>(take_word(rest));
    const auto second = finite_number<Number>(take_word(rest));
    if (!first || !second || !take_word(rest).empty()) {
      refuse(fmt::format("has \"{}\" as {}, which is not two numbers", shown_text(whole),
                         std::string_view(path).substr(last_part(path))),
             "download it again");
    }
    return {*first, *second};
  }

  [[noreturn]] void refuse(const std::string& problem, std::string remedy) const {
    throw CaseError("terrain.dem", name_ + " " + problem, std::move(remedy));
  }

 private:
  static std::size_t last_part(std::string_view path) { return path.rfind('.') + 1; }

  GdalErrors errors_;
  std::string name_;
  std::unique_ptr<CPLXMLNode, XmlDeleter> tree_;
  const CPLXMLNode* dem_ = nullptr;
};

JapaneseDatum datum_of(const Document& document) {
  const std::string_view srs = document.text("coverage.gml:boundedBy.gml:Envelope.srsName");
  if (srs == "fguuid:jgd2000.bl") return JapaneseDatum::jgd2000;
  if (srs == "fguuid:jgd2011.bl") return JapaneseDatum::jgd2011;
  if (srs == "fguuid:jgd2024.bl") return JapaneseDatum::jgd2024;
  document.refuse(fmt::format("is in \"{}\"", shown_text(srs)),
                  "give a tile in fguuid:jgd2000.bl, jgd2011.bl or jgd2024.bl");
}

constexpr const char* low_path =
    "coverage.gml:gridDomain.gml:Grid.gml:limits.gml:GridEnvelope"
    ".gml:low";
constexpr const char* high_path =
    "coverage.gml:gridDomain.gml:Grid.gml:limits.gml:GridEnvelope"
    ".gml:high";

Grid grid_of(const Document& document) {
  const auto lower = document.pair<double>("coverage.gml:boundedBy.gml:Envelope.gml:lowerCorner");
  const auto upper = document.pair<double>("coverage.gml:boundedBy.gml:Envelope.gml:upperCorner");
  const auto [south, west] = lower;  // latitude first
  const auto [north, east] = upper;
  if (!(south < north && west < east)) {
    document.refuse(fmt::format("has its lower corner at {} {}, not south-west of the upper one at "
                                "{} {} (latitude, longitude)",
                                south, west, north, east),
                    "download it again");
  }
  if (south < -90 || north > 90 || west < -180 || east > 180) {
    document.refuse("has corners that are no latitude and longitude", "download it again");
  }
  const auto low = document.pair<int>(low_path);
  const auto high = document.pair<int>(high_path);
  const auto limit = static_cast<long long>(max_tile_cells);
  const long long columns = static_cast<long long>(high[0]) - low[0] + 1;
  const long long rows = static_cast<long long>(high[1]) - low[1] + 1;
  if (columns < 1 || rows < 1 || columns > limit || rows > limit || columns * rows > limit) {
    document.refuse(
        fmt::format("has {} x {} cells; a tile has from 1 to {} cells", columns, rows, limit),
        "download it again");
  }
  Grid grid{.columns = static_cast<int>(columns), .rows = static_cast<int>(rows), .west = west};
  grid.north = north;
  grid.dx = (east - west) / grid.columns;
  grid.dy = (north - south) / grid.rows;
  constexpr double smallest = 1e-7;  // degrees: 1 cm
  if (grid.dx < smallest || grid.dy < smallest) {
    document.refuse(fmt::format("has cells of {} x {} degrees", grid.dx, grid.dy),
                    "download it again");
  }
  return grid;
}

// Where the values begin, as an index into the grid.
std::size_t start_of(const Document& document, const Grid& grid) {
  constexpr const char* path = "coverage.gml:coverageFunction.gml:GridFunction.gml:startPoint";
  const auto low = document.pair<int>(low_path);
  // Without one, GML 3.2 starts at the low corner of the grid.
  const auto start = document.find(path) ? document.pair<int>(path) : low;
  const long long column = static_cast<long long>(start[0]) - low[0];
  const long long row = static_cast<long long>(start[1]) - low[1];
  if (column < 0 || column >= grid.columns || row < 0 || row >= grid.rows) {
    document.refuse(fmt::format("has the start point {} {}, beside its {} x {} cells", start[0],
                                start[1], grid.columns, grid.rows),
                    "download it again");
  }
  return grid.index(static_cast<int>(column), static_cast<int>(row));
}

// "No data" in the two encodings that these files have had, UTF-8 and Shift_JIS.
bool is_no_data(std::string_view kind) {
  return kind == "データなし" || kind == "\x83\x66\x81\x5b\x83\x5e\x82\xc8\x82\xb5";
}

void read_tuples(const Document& document, std::size_t start, std::vector<double>& values) {
  std::string_view list = document.text("coverage.gml:rangeSet.gml:DataBlock.gml:tupleList");
  std::size_t cell = start;
  for (std::string_view tuple = take_word(list); !tuple.empty(); tuple = take_word(list)) {
    if (cell == values.size()) {
      document.refuse(fmt::format("has more values than the {} cells from its start point on",
                                  values.size() - start),
                      "download it again");
    }
    const std::size_t comma = tuple.find(',');
    const auto elevation = comma == std::string_view::npos
                               ? std::nullopt
                               : finite_number<double>(tuple.substr(comma + 1));
    if (!elevation) {
      document.refuse(fmt::format("has \"{}\" as value {}, which is not KIND,ELEVATION",
                                  shown_text(tuple), cell - start + 1),
                      "download it again");
    }
    const bool is_data = *elevation != undefined_elevation && !is_no_data(tuple.substr(0, comma));
    values[cell++] = is_data ? *elevation : Raster::no_data;
  }
}

std::string date_of(const Document& document) {
  for (const char* path : {"devDate.gml:timePosition", "lfSpanFr.gml:timePosition"}) {
    const char* const found = document.find(path);
    const std::string_view date = found ? found : "";
    const bool is_date =
        date.size() == 10 && date.find_first_not_of("0123456789-") == std::string_view::npos;
    if (is_date) return std::string(date);
  }
  return "";
}

}  // namespace

FgGmlTile parse_fg_gml(const std::string& text, const std::string& name) {
  const Document document(text, name);
  const std::string_view order =
      document.text("coverage.gml:coverageFunction.gml:GridFunction.gml:sequenceRule.order");
  if (order != "+x-y") {
    document.refuse(fmt::format("has its values in the order \"{}\"", shown_text(order)),
                    "give a tile in the order +x-y, as GSI makes them");
  }
  FgGmlTile tile;
  tile.datum = datum_of(document);
  tile.date = date_of(document);
  const Grid grid = grid_of(document);
  const std::size_t start = start_of(document, grid);
  tile.raster = Raster(grid, Raster::no_data);
  read_tuples(document, start, tile.raster.values);
  return tile;
}

}  // namespace sabo
