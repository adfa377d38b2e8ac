#include "base/archive.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sabo {
namespace {

/// One of each kind of member.
struct State {
  double time = 0.5;
  bool is_awake = true;
  std::string name = "wall";
  std::vector<std::uint32_t> rows{3, 1, 2};
  std::vector<std::vector<double>> bins{{1.5}, {}, {2, 3}};
  std::deque<float> window{1, 2};
  std::optional<double> start = 7;
  std::optional<double> none = {};
  std::map<std::int64_t, std::string> tiles{{-1, "a"}, {5, ""}};

  template <class Archive>
  void archive(Archive& a) {
    a.mark("state");
    a(time, is_awake, name, rows, bins, window, start, none, tiles);
  }
  friend bool operator==(const State&, const State&) = default;
};

template <class T>
std::string written(T state) {
  std::string bytes;
  ArchiveWriter a([&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  });
  a(state);
  return bytes;
}

template <class T>
void read(const std::string& bytes, T& state) {
  std::size_t place = 0;
  ArchiveReader a([&](void* to, std::size_t size) {
    const std::size_t count = bytes.copy(static_cast<char*>(to), size, place);
    place += count;
    return count;
  });
  a(state);
  a.end();
}

TEST(Archive, GivesBackWhatWasWritten) {
  State state;
  state.time = -0.0;
  state.none = 3;
  state.rows.clear();
  State other;
  other.tiles[7] = "left over";
  read(written(state), other);
  EXPECT_TRUE(other == state);
  EXPECT_TRUE(std::signbit(other.time));
}

TEST(Archive, RefusesBytesThatEndAnywhereOrGoOn) {
  const std::string bytes = written(State());
  State state;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(read(bytes.substr(0, size), state), RunError) << size;
  EXPECT_THROW(read(bytes + '\0', state), RunError);
}

TEST(Archive, NeverTakesMoreMemoryThanBytesAreThere) {
  // A list that claims 2^60 numbers, of which one is there.
  std::string bytes = written(std::vector<double>{1});
  bytes[8] = 0x10;
  std::vector<double> list;
  EXPECT_THROW(read(bytes, list), RunError);
  EXPECT_LE(list.capacity(), std::size_t{1} << 18);
}

TEST(Archive, RefusesAnotherLayout) {
  const auto is_refused = [](const std::string& bytes, auto other) {
    EXPECT_THROW(read(bytes, other), RunError);
  };
  is_refused(written(1.5), 1.5f);
  is_refused(written(1.5), std::string());
  is_refused(written(std::vector<double>{1}), std::vector<std::uint32_t>());
  is_refused(written(std::string("state")), State());
  is_refused(written(std::uint8_t{2}), true);
}

TEST(Archive, RefusesAListOfAnotherLength) {
  struct Fixed {
    std::vector<double> list;
    void archive(ArchiveWriter& a) { a.fixed(list); }
    void archive(ArchiveReader& a) { a.fixed(list); }
  };
  Fixed three{{1, 2, 3}}, two{{1, 2}};
  EXPECT_THROW(read(written(three), two), RunError);
  Fixed other{{0, 0, 0}};
  read(written(three), other);
  EXPECT_EQ(other.list, three.list);
}

}  // namespace
}  // namespace sabo
