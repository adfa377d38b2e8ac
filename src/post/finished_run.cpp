#include "post/finished_run.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "analysis/columns.hpp"
#include "base/error.hpp"
#include "io/case_file/read_case.hpp"
#include "io/gis/crs.hpp"
#include "io/gis/raster_file.hpp"
#include "run/load_case.hpp"
#include "run/read_manifest.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> map_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry(folder / "maps", error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path& file = entry->path();
    const bool is_given = file.stem() == "ground" || file.stem() == "rel";  // before the run
    if (file.extension() == ".tif" && !is_given) names.push_back(file.stem());
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

FinishedRun::FinishedRun(const fs::path& folder)
    : folder_(folder),
      name_(name_of_case(folder)),
      manifest_(read_manifest(folder)),
      maps_(map_names(folder)) {
  Faults faults;
  case_ = read_case(folder, faults);
  if (!faults.empty()) case_problem_ = to_string(faults.list().front());
  std::error_code error;
  if (maps_.empty() || !fs::exists(folder / "maps" / "ground.tif", error))
    throw CaseError(folder.string(), "has no maps: the run is going on, or it stopped before",
                    "wait for its end, or run it again");
}

std::string FinishedRun::end() const { return text_at(table("run"), "end").value_or("unknown"); }

std::string FinishedRun::version() const {
  return text_at(table("run"), "version").value_or("unknown");
}

std::optional<double> FinishedRun::simulated() const {
  return number_at(table("run"), "simulated_s");
}

void FinishedRun::need_case() const {
  if (!(case_.numerics.spacing > 0))
    throw CaseError((folder_ / "case.toml").string(), "tells no spacing: " + case_problem_,
                    "run the case again");
}

double FinishedRun::wet_depth() const { return sabo::wet_depth(case_.numerics.spacing); }

bool FinishedRun::has_map(std::string_view name) const {
  return std::ranges::find(maps_, name) != maps_.end();
}

RunMap FinishedRun::map(const std::string& name) const {
  const fs::path file = folder_ / "maps" / (name + ".tif");
  std::error_code error;
  if (!fs::exists(file, error))
    throw CaseError(folder_.string(), fmt::format("has no map {}.tif", name),
                    "run the case again with this version of sabo");
  const RasterFile source(file, file.string());
  return {name, source.read(), wkt_of(source.crs()), source.description(), source.unit()};
}

std::optional<NumberTable> FinishedRun::series(const std::string& name) const {
  return read_number_table(folder_ / "series" / (name + ".csv"));
}

std::vector<std::string> names_of(const std::vector<FinishedRun>& runs) {
  std::vector<std::string> names;
  for (const FinishedRun& run : runs) {
    const auto is_same = [&](const FinishedRun& other) { return other.name() == run.name(); };
    std::error_code error;
    const fs::path full = fs::absolute(run.folder(), error).lexically_normal();
    const fs::path above = (full.has_filename() ? full : full.parent_path()).parent_path();
    const bool is_taken = std::ranges::count_if(runs, is_same) > 1 && above.has_filename();
    names.push_back(is_taken ? above.filename().string() + "/" + run.name() : run.name());
  }
  return names;
}

}  // namespace sabo
