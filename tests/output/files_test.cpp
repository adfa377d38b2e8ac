#include <cmath>

#include "support/fault_of.hpp"
#include "support/full_disk.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/output/checksum.hpp"
#include "io/output/csv.hpp"
#include "io/output/file.hpp"

namespace sabo {
namespace {

using testing::HasSubstr;

TEST(WriteFileAtomically, ReplacesTheFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a.txt", "one");
  write_file_atomically(folder / "a.txt", std::string("t\0o", 3));
  EXPECT_EQ(folder.read("a.txt"), std::string("t\0o", 3));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "a.txt", "old");
  {
    const FullDisk full(1000);
    EXPECT_THAT(
        run_error_of([&] { write_file_atomically(folder / "a.txt", std::string(100000, 'x')); }),
        HasSubstr("a.txt: File too large"));
  }
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WriteFileAtomically, SaysWhyItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THAT(run_error_of([&] { write_file_atomically(folder / "no/a.txt", ""); }),
              HasSubstr("No such file or directory"));
}

TEST(Checksum, IsTheCrc32OfTheContent) {
  const TemporaryFolder folder;
  // The check value of CRC-32 in every catalogue of CRCs.
  EXPECT_EQ(checksum(folder.write("a", "123456789")), "cbf43926");
  EXPECT_EQ(checksum(folder.write("b", "")), "00000000");
  EXPECT_THAT(run_error_of([&] { checksum(folder / "none"); }), HasSubstr("cannot read"));
}

TEST(CsvWriter, WritesHeaderAndRowsAtOnce) {
  const TemporaryFolder folder;
  CsvWriter csv(folder / "front.csv", {"time [s]", "front [m]", "a,\"b\""});
  csv.append({0.5, 1234567.891, -1e-7});
  EXPECT_EQ(folder.read("front.csv"),
            "time [s],front [m],\"a,\"\"b\"\"\"\n0.5,1234567.89,-1e-07\n");
}

TEST(CsvWriter, RefusesWhatIsNoNumberAndNamesTheColumn) {
  const TemporaryFolder folder;
  CsvWriter csv(folder / "front.csv", {"time [s]", "front [m]"});
  EXPECT_THAT(run_error_of([&] { csv.append({1, std::nan("")}); }), HasSubstr("front [m] is nan"));
  EXPECT_THAT(run_error_of([&] { csv.append({1, HUGE_VAL}); }), HasSubstr("front [m] is inf"));
  EXPECT_THAT(run_error_of([&] { csv.append({1}); }), HasSubstr("1 values for 2 columns"));
  EXPECT_EQ(folder.read("front.csv"), "time [s],front [m]\n");
}

TEST(CsvWriter, ReportsAFullDisk) {
  const TemporaryFolder folder;
  CsvWriter csv(folder / "front.csv", {"time [s]"});
  const FullDisk full(20);
  EXPECT_THAT(run_error_of([&] {
                for (int i = 0; i < 20; ++i) csv.append({1.0});
              }),
              HasSubstr("front.csv: File too large"));
}

}  // namespace
}  // namespace sabo
