#pragma once

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "base/faults.hpp"
#include "io/case_file/read_case.hpp"

namespace sabo {

/// A new empty folder, removed at the end.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& name = "case") {
    const std::string number = std::to_string(std::random_device{}());
    path_ = std::filesystem::temp_directory_path() / ("sabo-" + number) / name;
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_.parent_path()); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& file, const std::string& text = "") const {
    std::ofstream(path_ / file, std::ios::binary) << text;
    return path_ / file;
  }

 private:
  std::filesystem::path path_;
};

/// The fewest keys that make a case. They fill lines 1 to 10, so what a test adds starts at 11.
inline const std::string smallest_case = R"([terrain]
dem = "dem.tif"
[release]
polygon = "release.gpkg"
volume = 100
[run]
duration = 10
[numerics]
spacing = 0.5

)";

/// A folder that holds the files the tests name.
inline const std::filesystem::path& folder_with_files() {
  static const TemporaryFolder folder;
  static const bool is_filled = [] {
    for (const char* file : {"dem.tif", "release.gpkg", "release.tif", "points.txt", "dam.gpkg",
                             "path.gpkg", "mesh.stl"}) {
      folder.write(file);
    }
    return true;
  }();
  (void)is_filled;
  return folder.path();
}

/// What a user would see, one line for each fault.
inline std::vector<std::string> messages(const std::string& text) {
  Faults faults;
  read_case_text(text, folder_with_files(), faults);
  std::vector<std::string> lines;
  for (const Fault& fault : faults.list()) lines.push_back(to_string(fault));
  return lines;
}

/// `text` with its one occurrence of `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace sabo
