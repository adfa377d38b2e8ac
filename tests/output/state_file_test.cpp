#include "io/output/state_file.hpp"

#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sabo {
namespace {

using testing::HasSubstr;

std::vector<double> some_numbers() {
  std::vector<double> numbers;
  for (int k = 0; k < 40; ++k) numbers.push_back(1.0 / (k + 1));
  return numbers;
}

void write(const std::filesystem::path& file, std::uint32_t version = 3) {
  write_state_file(file, version, [](ArchiveWriter& a) {
    std::vector<double> numbers = some_numbers();
    a(numbers);
  });
}

std::vector<double> numbers_in(const std::string& bytes) {
  std::vector<double> numbers;
  StateFile(bytes, 3).read([&](ArchiveReader& a) { a(numbers); });
  return numbers;
}

std::string fault_in(const std::string& bytes) {
  try {
    numbers_in(bytes);
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(StateFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  write(folder / "a.sabo");
  EXPECT_EQ(folder.file_count(), 1U);
  EXPECT_EQ(numbers_in(folder.read("a.sabo")), some_numbers());
}

TEST(StateFile, EveryCutAndEveryFlippedBitIsSeen) {
  const TemporaryFolder folder;
  write(folder / "a.sabo");
  const std::string bytes = folder.read("a.sabo");
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(fault_in(bytes.substr(0, size)), "") << size;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(fault_in(damaged), "") << "bit " << bit;
  }
  EXPECT_THAT(fault_in(bytes.substr(0, 100)), HasSubstr("checksum"));
}

TEST(StateFile, AnotherVersionIsNamed) {
  const TemporaryFolder folder;
  write(folder / "a.sabo", 2);
  EXPECT_EQ(fault_in(folder.read("a.sabo")),
            "has version 2 of the format, this program reads version 3");
}

TEST(StateFile, AFullDiskLeavesTheFormerFile) {
  const TemporaryFolder folder;
  write(folder / "a.sabo");
  const std::string before = folder.read("a.sabo");
  {
    const FullDisk disk(50);
    EXPECT_THROW(write(folder / "a.sabo"), RunError);
  }
  EXPECT_EQ(folder.read("a.sabo"), before);
  EXPECT_EQ(folder.file_count(), 1U);
}

}  // namespace
}  // namespace sabo
