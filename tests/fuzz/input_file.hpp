#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace sabo {

/// A file that holds the bytes of an input, for readers that open one.
class InputFile {
 public:
  InputFile(const std::string& extension, const std::uint8_t* data, std::size_t size)
      : path_(std::filesystem::temp_directory_path() /
              ("sabo_fuzz_" + std::to_string(getpid()) + extension)) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  ~InputFile() { std::filesystem::remove(path_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace sabo
