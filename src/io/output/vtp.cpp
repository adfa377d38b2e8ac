#include "io/output/vtp.hpp"

#include <cmath>
#include <numeric>
#include <type_traits>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/output/file.hpp"
#include "io/output/markup.hpp"
#include "io/output/vtk_appended.hpp"

namespace sabo {
namespace {

// The parts of a PolyData file; each text holds DataArray elements of `data`.
struct PolyData {
  std::string fields;
  std::size_t point_count = 0;
  std::string points;
  std::string point_data;
  std::string cell_kind;  // Verts or Polys
  std::size_t cell_count = 0;
  std::string cells;
  VtkAppended data;
};

std::string file_text(const PolyData& p) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\" "
      "compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<FieldData>\n{}</FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"
      "<PointData>\n{}</PointData>\n<Points>\n{}</Points>\n<{}>\n{}</{}>\n"
      "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
      vtk_byte_order, p.fields, p.point_count, p.cell_kind == "Verts" ? p.cell_count : 0,
      p.cell_kind == "Polys" ? p.cell_count : 0, p.point_data, p.points, p.cell_kind, p.cells,
      p.cell_kind);
  text += p.data.bytes();
  return text + "\n</AppendedData>\n</VTKFile>\n";
}

std::string origin_field(const Vec3d& origin) {
  return fmt::format(
      "<DataArray type=\"Float64\" Name=\"origin [m]\" NumberOfComponents=\"3\" "
      "NumberOfTuples=\"1\" format=\"ascii\">{:.17g} {:.17g} {:.17g}</DataArray>\n",
      origin.x, origin.y, origin.z);
}

template <class T>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "UInt32";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
}

template <class T>
std::string add(VtkAppended& data, const std::string& name, int components,
                std::span<const T> values) {
  return data.add(vtk_type<T>(), name, components, std::as_bytes(values));
}

void check(const std::filesystem::path& file, const VtpArray& array, std::size_t points) {
  const std::size_t size = std::visit([](auto values) { return values.size(); }, array.values);
  if (size != points * array.components) {
    throw RunError(
        fmt::format("{}: {} has {} values for {} points", file.string(), array.name, size, points));
  }
  if (const auto* values = std::get_if<std::span<const float>>(&array.values)) {
    for (float value : *values) {
      if (!std::isfinite(value)) {
        throw RunError(fmt::format("{}: {} holds {}", file.string(), array.name, value));
      }
    }
  }
}

std::span<const float> floats_of(std::span<const Vec3f> points) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  return {points.empty() ? nullptr : &points.front().x, 3 * points.size()};
}

// Cells of the raster that become points, and the number of each (-1: no data).
struct SurfacePoints {
  int columns = 0;
  int rows = 0;
  std::vector<Vec3f> points;
  std::vector<std::int32_t> number;
};

SurfacePoints surface_points(const Raster& elevation, std::size_t max_points) {
  const Grid& grid = elevation.grid;
  const auto wanted = static_cast<double>(grid.size()) / static_cast<double>(max_points);
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(wanted))));
  SurfacePoints s{(grid.columns - 1) / stride + 1, (grid.rows - 1) / stride + 1, {}, {}};
  s.number.reserve(static_cast<std::size_t>(s.columns) * s.rows);
  for (int row = 0; row < grid.rows; row += stride) {
    for (int column = 0; column < grid.columns; column += stride) {
      const double z = elevation.at(column, row);
      s.number.push_back(std::isnan(z) ? -1 : static_cast<std::int32_t>(s.points.size()));
      if (std::isnan(z)) continue;
      s.points.push_back({static_cast<float>(grid.x_of(column)), static_cast<float>(grid.y_of(row)),
                          static_cast<float>(z)});
    }
  }
  return s;
}

std::vector<std::int32_t> triangles_of(const SurfacePoints& s) {
  std::vector<std::int32_t> corners;
  const auto add_triangle = [&corners](std::int32_t a, std::int32_t b, std::int32_t c) {
    if (a >= 0 && b >= 0 && c >= 0) corners.insert(corners.end(), {a, b, c});
  };
  for (int row = 0; row + 1 < s.rows; ++row) {
    for (int column = 0; column + 1 < s.columns; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * s.columns + column;
      const std::int32_t nw = s.number[i], ne = s.number[i + 1];
      const std::int32_t sw = s.number[i + s.columns], se = s.number[i + s.columns + 1];
      add_triangle(nw, sw, se);
      add_triangle(nw, se, ne);
    }
  }
  return corners;
}

std::string time_field(double time) {
  return fmt::format(
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{:.17g}</DataArray>\n",
      time);
}

std::string add_array(VtkAppended& data, const VtpArray& array) {
  return std::visit([&](auto values) { return add(data, array.name, array.components, values); },
                    array.values);
}

std::vector<Vec3f> points_of(const TriangleMesh& mesh) {
  std::vector<Vec3f> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3d& v : mesh.vertices) points.push_back({float(v.x), float(v.y), float(v.z)});
  return points;
}

std::vector<std::int32_t> corners_of(const TriangleMesh& mesh) {
  std::vector<std::int32_t> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : t) corners.push_back(static_cast<std::int32_t>(corner));
  return corners;
}

void write_triangles(const std::filesystem::path& file, const std::string& fields,
                     const std::vector<Vec3f>& points, const std::vector<std::int32_t>& corners,
                     const std::vector<VtpArray>& arrays) {
  std::vector<std::int32_t> offsets(corners.size() / 3);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    offsets[i] = static_cast<std::int32_t>(3 * (i + 1));
  PolyData p;
  p.fields = fields;
  p.point_count = points.size();
  p.cell_count = offsets.size();
  p.cell_kind = "Polys";
  p.points = add(p.data, "position [m]", 3, floats_of(points));
  for (const VtpArray& array : arrays) {
    check(file, array, points.size());
    p.point_data += add_array(p.data, array);
  }
  p.cells = add<std::int32_t>(p.data, "connectivity", 1, corners) +
            add<std::int32_t>(p.data, "offsets", 1, offsets);
  write_file_atomically(file, file_text(p));
}

}  // namespace

void write_particles_vtp(const std::filesystem::path& file, const VtpFrame& frame, int threads) {
  const std::size_t count = frame.points.size();
  check(file, {"position", 3, floats_of(frame.points)}, count);
  PolyData p;
  p.data = VtkAppended(threads);
  p.fields = time_field(frame.time) + origin_field(frame.origin);
  p.point_count = p.cell_count = count;
  p.cell_kind = "Verts";
  p.points = add(p.data, "position [m]", 3, floats_of(frame.points));
  for (const VtpArray& array : frame.arrays) {
    check(file, array, count);
    p.point_data += add_array(p.data, array);
  }
  std::vector<std::int32_t> numbers(count + 1);
  std::iota(numbers.begin(), numbers.end(), 0);
  const std::span<const std::int32_t> all(numbers);
  p.cells =
      add(p.data, "connectivity", 1, all.first(count)) + add(p.data, "offsets", 1, all.subspan(1));
  write_file_atomically(file, file_text(p));
}

void write_surface_vtp(const std::filesystem::path& file, const Raster& elevation,
                       const Vec3d& origin, std::size_t max_points) {
  const SurfacePoints surface = surface_points(elevation, max_points);
  std::vector<float> z;
  for (const Vec3f& point : surface.points) z.push_back(point.z);
  write_triangles(file, origin_field(origin), surface.points, triangles_of(surface),
                  {{"elevation [m]", 1, std::span<const float>(z)}});
}

void write_mesh_vtp(const std::filesystem::path& file, const TriangleMesh& mesh,
                    const std::vector<float>& numbers, const Vec3d& origin) {
  write_triangles(file, origin_field(origin), points_of(mesh), corners_of(mesh),
                  {{"body", 1, std::span<const float>(numbers)}});
}

void write_moving_surface_vtp(const std::filesystem::path& file, const VtpSurface& surface) {
  const std::vector<Vec3f> points = points_of(surface.mesh);
  check(file, {"position", 3, floats_of(points)}, points.size());
  write_triangles(file, time_field(surface.time) + origin_field(surface.origin), points,
                  corners_of(surface.mesh), surface.arrays);
}

void PvdWriter::add(double time, const std::string& frame_file) {
  entries_ +=
      fmt::format("<DataSet timestep=\"{:.9g}\" file=\"{}\"/>\n", time, escaped(frame_file));
  write();
}

void PvdWriter::write() const {
  write_file_atomically(file_, fmt::format("<?xml version=\"1.0\"?>\n"
                                           "<VTKFile type=\"Collection\" version=\"0.1\" "
                                           "byte_order=\"{}\">\n<Collection>\n{}</Collection>\n"
                                           "</VTKFile>\n",
                                           vtk_byte_order, entries_));
}

}  // namespace sabo
