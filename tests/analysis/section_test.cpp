#include "analysis/section.hpp"

#include "cloud.hpp"
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "analysis/tracks.hpp"

namespace sabo {
namespace {

/// Small whole numbers, so that paths often meet vertices and run along the line.
Vec3d lattice_point(int reach) {
  return {static_cast<double>(*rc::gen::inRange(-reach, reach + 1)),
          static_cast<double>(*rc::gen::inRange(-reach, reach + 1)), 0};
}

// The line runs north: its left is the west.
TEST(Curtain, counts_from_left_to_right) {
  const Curtain curtain({{{0, 0, 0}, {0, 10, 0}}});
  EXPECT_EQ(curtain.crossings({-1, 5, 0}, {1, 5, 0}), 1);
  EXPECT_EQ(curtain.crossings({1, 5, 0}, {-1, 5, 0}), -1);
  EXPECT_EQ(curtain.crossings({-2, 5, 0}, {-1, 6, 0}), 0);
  EXPECT_EQ(curtain.crossings({-1, 11, 0}, {1, 11, 0}), 0) << "beyond the end";
  EXPECT_EQ(curtain.crossings({-5, 9, 0}, {5, 12, 0}), 0) << "box met, line missed";
  EXPECT_EQ(curtain.crossings({-1, 5, 900}, {1, 5, -900}), 1) << "height does not matter";
}

TEST(Curtain, a_path_through_a_shared_vertex_counts_once) {
  const Curtain bent({{{0, -10, 0}, {0, 0, 0}, {3, 10, 0}}});
  EXPECT_EQ(bent.crossings({-2, 0, 0}, {2, 0, 0}), 1);
  EXPECT_EQ(bent.crossings({2, 1, 0}, {-2, -1, 0}), -1);
  const Curtain straight({{{0, -10, 0}, {0, 0, 0}, {0, 0, 0}, {0, 10, 0}}});
  EXPECT_EQ(straight.crossings({-2, 0, 0}, {2, 0, 0}), 1);
}

TEST(Curtain, a_stop_on_the_line_counts_once) {
  const Curtain bent({{{0, -10, 0}, {0, 0, 0}, {3, 10, 0}}});
  for (const Vec3d stop : {Vec3d{0, -3, 0}, Vec3d{0, 0, 0}, Vec3d{1.5, 5, 0}}) {
    const Vec3d west{-4, 1, 0};
    const Vec3d east{4, 1, 0};
    EXPECT_EQ(bent.crossings(west, stop) + bent.crossings(stop, east), 1);
    EXPECT_EQ(bent.crossings(west, stop) + bent.crossings(stop, west), 0);
  }
}

TEST(Curtain, a_zigzag_is_crossed_as_often_as_it_turns) {
  // Teeth between y = -1 and y = 1 with vertices on every whole x; a path along y = 0 from the far
  // left to the far right crosses all six pieces, back and forth, through none of their vertices.
  const Curtain teeth(
      {{{0, -1, 0}, {1, 1, 0}, {2, -1, 0}, {3, 1, 0}, {4, -1, 0}, {5, 1, 0}, {6, -1, 0}}});
  EXPECT_EQ(teeth.crossings({-1, 0, 0}, {7, 0, 0}), 0);
  EXPECT_EQ(teeth.crossings({-1, 0, 0}, {5, 0, 0}), 1) << "five pieces";
  EXPECT_EQ(teeth.crossings({-1, 1, 0}, {7, 1, 0}), 0) << "touches the upper tips only";
}

TEST(Curtain, lists_the_crossings_of_many_paths_in_their_order) {
  EXPECT_TRUE(rc::check("the same by one thread and by several", [] {
    const Curtain curtain({{{0, -2, 0}, {0, 1, 0}, {1, 3, 0}}});
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(0, 9000));
    std::vector<Vec3d> from(count), to(count);
    std::uint32_t state = static_cast<std::uint32_t>(*rc::gen::inRange(1, 1 << 30));
    const auto next = [&] {
      state = state * 1664525U + 1013904223U;
      return static_cast<double>(state >> 29) - 4;
    };
    for (std::size_t i = 0; i < count; ++i) {
      from[i] = {next(), next(), 0};
      to[i] = {next(), next(), 0};
    }
    for (const int threads : {1, 3}) {
      const std::vector<Crossing> found = curtain.crossings(from, to, threads);
      std::size_t k = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const int net = curtain.crossings(from[i], to[i]);
        if (net == 0) continue;
        RC_ASSERT(k < found.size());
        RC_ASSERT(found[k].row == i);
        RC_ASSERT(found[k].net == net);
        ++k;
      }
      RC_ASSERT(k == found.size());
    }
  }));
}

TEST(Curtain, walks_about_a_straight_line_count_their_change_of_side) {
  EXPECT_TRUE(rc::check("net = side at the end - side at the start", [] {
    Vec3d a = lattice_point(4);
    Vec3d b = lattice_point(4);
    RC_PRE(!(a == b));
    // Continued far beyond all walks, in two pieces with a vertex amid them.
    const Curtain line({{a - 100. * (b - a), a, a + 100. * (b - a)}});
    const auto side = [&](const Vec3d& p) {  // of p + (e, e^2)
      const double turn = cross(b - a, p - a).z;
      if (turn != 0) return turn > 0 ? 0 : 1;
      if (a.y != b.y) return a.y - b.y > 0 ? 0 : 1;
      return b.x > a.x ? 0 : 1;
    };
    const Vec3d start = lattice_point(5);
    Vec3d from = start;
    int net = 0;
    for (int step = 0; step < 30; ++step) {
      const Vec3d to = lattice_point(5);
      net += line.crossings(from, to);
      from = to;
    }
    RC_ASSERT(net == side(from) - side(start));
  }));
}

TEST(Curtain, closed_walks_cross_closed_lines_evenly) {
  EXPECT_TRUE(rc::check("net crossings of a closed walk about a closed line are zero", [] {
    Polyline ring;
    ring.vertices.resize(*rc::gen::inRange<std::size_t>(2, 9));
    for (Vec3d& vertex : ring.vertices) vertex = lattice_point(4);
    ring.vertices.push_back(ring.vertices.front());
    const Curtain curtain(ring);
    const Vec3d start = lattice_point(5);
    Vec3d from = start;
    int net = 0;
    for (int step = 0; step < 20; ++step) {
      const Vec3d to = step == 19 ? start : lattice_point(5);
      net += curtain.crossings(from, to);
      from = to;
    }
    RC_ASSERT(net == 0);
  }));
}

TEST(Curtain, a_line_without_length_is_never_crossed) {
  EXPECT_EQ(Curtain(Polyline{}).crossings({-1, 0, 0}, {1, 0, 0}), 0);
  EXPECT_EQ(Curtain({{{0, 0, 0}, {0, 0, 0}}}).crossings({-1, 0, 0}, {1, 0, 0}), 0);
}

TEST(Section, keeps_both_signs_and_hands_out_intervals) {
  Section section({{{0, 0, 0}, {0, 10, 0}}});
  section.record({-1, 5, 0}, {1, 5, 0}, 3);
  section.record({1, 5, 0}, {-1, 5, 0}, 2);
  EXPECT_EQ(section.take_interval(), (SectionVolumes{3, 2}));
  EXPECT_EQ(section.take_interval(), SectionVolumes{});
  section.record({-1, 5, 0}, {1, 5, 0}, 0.5);
  EXPECT_EQ(section.take_interval(), (SectionVolumes{0.5, 0}));
  EXPECT_EQ(section.total(), (SectionVolumes{3.5, 2}));
  EXPECT_EQ(section.total().net(), 1.5);
}

TEST(Section, a_cloud_counts_by_volume) {
  Section section({{{0, 0, 0}, {0, 10, 0}}});
  const Particles particles = cloud({{1, 5, 0}, {-3, 5, 0}, {1, 6, 0}}, 500);
  section.record({{-1, 5, 0}, {-1, 5, 0}, {-1, 6, 0}}, particles, 2000);
  EXPECT_EQ(section.total(), (SectionVolumes{0.5, 0}));
}

TEST(Tracks, follow_particles_through_sorting_leaving_and_coming) {
  Tracks tracks;
  Particles particles = cloud({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  EXPECT_EQ(tracks.advance(particles), particles.position) << "unknown before";
  particles.permute({2, 0});
  for (Vec3d& position : particles.position) position.y = 7;
  EXPECT_EQ(tracks.advance(particles), (std::vector<Vec3d>{{2, 0, 0}, {0, 0, 0}}));
  particles.id[0] = 5;
  EXPECT_EQ(tracks.advance(particles), (std::vector<Vec3d>{{2, 7, 0}, {0, 7, 0}}));
  EXPECT_TRUE(tracks.advance(Particles{}).empty());
}

}  // namespace
}  // namespace sabo
