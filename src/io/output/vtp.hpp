#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/triangle_mesh.hpp"

#include "math/vec3.hpp"
#include "terrain/raster.hpp"

namespace sabo {

/// One quantity of the points of a frame.
struct VtpArray {
  std::string name;    ///< with its unit, e.g. "velocity [m/s]"
  int components = 1;  ///< the values of a point stand together
  std::variant<std::span<const float>, std::span<const std::uint32_t>> values;
};

/// Particles at one time, in the solver frame.
struct VtpFrame {
  double time = 0;    ///< s
  Vec3d origin = {};  ///< written as the field "origin [m]": CRS coordinates = point + origin
  std::span<const Vec3f> points = {};
  std::vector<VtpArray> arrays = {};
};

/// Writes VTK XML PolyData with one vertex cell per particle: appended raw data in zlib blocks.
/// Throws RunError; also for an array of another length than the points and for a value that is
/// not finite. Threads as host_threads() takes them.
void write_particles_vtp(const std::filesystem::path& file, const VtpFrame& frame, int threads = 1);

/// Writes the ground (solver frame) as triangles between cell centres with data, cut as Surface
/// cuts them, with the array "elevation [m]". Of more than `max_points` cells every k-th is taken.
void write_surface_vtp(const std::filesystem::path& file, const Raster& elevation,
                       const Vec3d& origin, std::size_t max_points = 4'000'000);

/// Writes a mesh (solver frame) with a number for each vertex as the array "body". Throws RunError.
void write_mesh_vtp(const std::filesystem::path& file, const TriangleMesh& mesh,
                    const std::vector<float>& numbers, const Vec3d& origin);

/// A surface at one time, in the solver frame, with arrays of its vertices.
struct VtpSurface {
  double time = 0;    ///< s
  Vec3d origin = {};  ///< as that of VtpFrame
  const TriangleMesh& mesh;
  std::vector<VtpArray> arrays = {};
};

/// Writes it as triangles, as write_particles_vtp writes particles. Throws RunError, as that does.
void write_moving_surface_vtp(const std::filesystem::path& file, const VtpSurface& surface);

/// The list of frames that ParaView opens as a time series.
class PvdWriter {
 public:
  explicit PvdWriter(std::filesystem::path file) : file_(std::move(file)) {}

  /// Adds a frame, its path relative to the list, and rewrites the list. Throws RunError.
  void add(double time, const std::string& frame_file);

  /// What is read takes off what was added later. Throws RunError.
  template <class Archive>
  void archive(Archive& a) {
    a(entries_);
    if constexpr (Archive::is_reader) write();
  }

 private:
  void write() const;

  std::filesystem::path file_;
  std::string entries_;
};

}  // namespace sabo
