#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sabo {

/// Particles at one time, as the 3D view shows them.
struct ViewFrame {
  /// Numbers that stay with the particles; ascending.
  std::vector<std::uint32_t> id = {};
  /// Of each particle: x and y in the solver frame, height over the ground (m), depth of its column
  /// (m), speed (m/s), pressure (Pa). Finite.
  std::array<std::vector<float>, 6> values = {};
};

/// Of the places in `values`.
enum class ViewValue : std::size_t { x, y, height, depth, speed, pressure };

/// Bytes of a particle in a frame, before they become text (which takes 4/3 of it).
inline constexpr std::size_t view_bytes_per_particle = 6 * sizeof(std::uint16_t);

/// A script that hands frame `number` to the page. Each value is a whole number from 0 to 65535
/// between the least and the greatest of its kind in the frame, so it is off by no more than
/// 1/131070 of their difference. Ids follow as 32 bits each where they are not 0, 1, 2, ...
std::string view_frame_script(std::size_t number, const ViewFrame& frame);

/// "frame_00012.js"
std::string view_frame_file(std::size_t number);

/// A value between `low` and `high` as 0 to `steps`.
std::uint16_t quantised(double value, double low, double high, int steps = 65535);

/// Appends the `count` lower bytes of a number, the lowest first, whatever this machine's order.
void append_bytes(std::vector<std::byte>& bytes, std::uint32_t number, int count);

/// Whole numbers as bytes, the lowest byte first, in base64.
std::string packed(const std::vector<std::uint16_t>& numbers);

}  // namespace sabo
