#include "run/state_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "analysis/columns.hpp"
#include "base/error.hpp"
#include "io/output/file.hpp"
#include "io/output/index_page.hpp"
#include "io/output/map_picture.hpp"
#include "io/output/scene_picture.hpp"
#include "run/overlay.hpp"
#include "run/read_frames.hpp"
#include "run/scene_bodies.hpp"
#include "run/scene_structures.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t default_count = 6;

struct Quantity {
  const char* name;
  const char* title;
  const char* label;
  Raster (Columns::*raster)() const;
  double scale;  ///< from the unit of the raster to that of the label
};
constexpr std::array<Quantity, 3> quantities{
    {{"depth", "Depth", "depth [m]", &Columns::depth, 1},
     {"speed", "Speed", "speed [m/s]", &Columns::speed, 1},
     {"pressure", "Pressure", "greatest pressure in the column [kPa]", &Columns::pressure, 1e-3}}};

/// The frames nearest to the times, each once, in order.
std::vector<PvdEntry> chosen_frames(const std::vector<PvdEntry>& frames,
                                    std::vector<double> times) {
  const double end = frames.back().time;
  if (times.empty()) {
    for (std::size_t k = 1; k <= default_count; ++k) times.push_back(end * k / default_count);
  }
  std::vector<PvdEntry> chosen;
  for (const double time : times) {
    if (!(time >= 0 && time <= end * (1 + 1e-9))) {
      throw CaseError("--times", fmt::format("{:g} s is not within the run", time),
                      fmt::format("give times from 0 to {:g} s", end));
    }
    const auto nearest = std::ranges::min_element(
        frames, {}, [time](const PvdEntry& e) { return std::abs(e.time - time); });
    const bool is_new =
        std::ranges::none_of(chosen, [&](const PvdEntry& e) { return e.file == nearest->file; });
    if (is_new) chosen.push_back(*nearest);
  }
  std::ranges::sort(chosen, {}, &PvdEntry::time);
  return chosen;
}

/// Draws one frame after the other; the first pass over them sets scales and view.
class StatePictures {
 public:
  StatePictures(const fs::path& folder, const Case& c, const Scene& scene)
      : folder_(folder),
        case_(c),
        scene_(scene),
        ground_(scene.surface->elevation()),
        columns_(ground_, c.numerics.spacing, c.material.density),
        wet_depth_(wet_depth(c.numerics.spacing)),
        greatest_depth_(ground_.grid) {}

  std::vector<PagePicture> draw(const std::vector<PvdEntry>& frames) {
    for (const PvdEntry& frame : frames) {
      take(frame);
      for (std::size_t k = 0; k < quantities.size(); ++k) tops_[k] = std::max(tops_[k], top_of(k));
      for (const std::size_t cell : columns_.touched())
        greatest_depth_.values[cell] = std::max(greatest_depth_.values[cell], columns_.depth(cell));
    }
    view_ = view_around(greatest_depth_, wet_depth_);
    direction_ = scene_direction(scene_picture("", 0), ground_, greatest_depth_);
    for (const PvdEntry& frame : frames) {
      take(frame);
      for (std::size_t k = 0; k < quantities.size(); ++k) draw_quantity(frame, k);
    }
    return std::move(pictures_);
  }

 private:
  void take(const PvdEntry& frame) {
    columns_.update(particles_of(folder_ / "frames" / frame.file, scene_.frame));
  }

  Raster values_of(std::size_t k) const {
    Raster values = (columns_.*quantities[k].raster)();
    for (double& value : values.values) value *= quantities[k].scale;
    return values;
  }

  double top_of(std::size_t k) const {
    double top = 0;
    for (const double value : values_of(k).values)
      if (value > top) top = value;  // false for NaN
    return top;
  }

  ScenePicture scene_picture(std::string title, std::size_t k) const {
    ScenePicture picture;
    picture.title = std::move(title);
    picture.note = case_.note;
    picture.quantity = quantities[k].label;
    picture.threshold = wet_depth_;
    picture.top = tops_[k];
    picture.view = view_;
    for (const CheckDam& dam : scene_.dams)
      picture.bodies.push_back({dam.name, shown_mesh(dam, scene_)});
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      picture.bodies.push_back(
          {label_of_body(scene_, b), shown_mesh(case_, b, scene_), is_shown_solid(case_, b)});
    picture.lines = overlay(scene_);
    std::erase_if(picture.lines,
                  [](const MapLine& line) { return line.kind == MapLine::Kind::dam; });  // walls
    return picture;
  }

  void draw_quantity(const PvdEntry& frame, std::size_t k) {
    const Quantity& quantity = quantities[k];
    const std::string title = fmt::format("{} at {:.4g} s", quantity.title, frame.time);
    const Raster values = values_of(k);
    MapPicture map{title, case_.note, quantity.label, k == 0 ? wet_depth_ : 0, tops_[k]};
    map.view = view_;
    map.lines = overlay(scene_);
    const std::string from_above =
        write(quantity.name, frame, "map", map_svg(map, ground_, values));

    ScenePicture scene = scene_picture(title, k);
    scene.azimuth = direction_.azimuth;
    scene.down = direction_.down;
    const std::string in_perspective =
        write(quantity.name, frame, "3d", scene_svg(scene, ground_, columns_.depth(), values));
    pictures_.push_back({{from_above, in_perspective}, title, false});
  }

  std::string write(const char* quantity, const PvdEntry& frame, const char* kind,
                    const std::string& svg) {
    // By the number of the frame: times may be as close as one likes.
    const std::string number = fs::path(frame.file).stem().string();
    const std::string name = fmt::format("pictures/state_{}_{}_{}.svg", quantity, number, kind);
    write_file_atomically(folder_ / name, svg);
    return name;
  }

  const fs::path& folder_;
  const Case& case_;
  const Scene& scene_;
  const Raster& ground_;
  Columns columns_;
  double wet_depth_;  // m
  Raster greatest_depth_;
  std::array<double, quantities.size()> tops_{};
  MapView view_;
  LookDirection direction_;
  std::vector<PagePicture> pictures_;
};

/// Those of an earlier call, which may have had other times.
void remove_pictures(const fs::path& run_folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(run_folder / "pictures", error))
    if (entry.path().filename().string().starts_with("state_")) old.push_back(entry.path());
  for (const fs::path& file : old) fs::remove(file, error);
}

}  // namespace

fs::path draw_states(const fs::path& run_folder, const std::vector<double>& times) {
  const auto& [c, scene] = scene_of_run(run_folder);
  const std::vector<PvdEntry> frames = chosen_frames(frames_of(run_folder), times);

  remove_pictures(run_folder);
  IndexPage page;
  page.title = (c.title.empty() ? "Debris flow" : c.title) + ": states of the flow";
  page.subtitle = "Depth, speed and pressure; one colour scale for each quantity";
  page.note = c.note;
  page.columns = quantities.size();
  page.pictures = StatePictures(run_folder, c, scene).draw(frames);
  const fs::path file = run_folder / "states.html";
  write_file_atomically(file, index_html(page));
  return file;
}

}  // namespace sabo
