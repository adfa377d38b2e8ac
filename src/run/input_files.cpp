#include "run/input_files.hpp"

#include <algorithm>
#include <system_error>
#include <type_traits>

namespace sabo {
namespace {

namespace fs = std::filesystem;

/// A file and those beside it that hold its attributes and its coordinate system.
std::vector<fs::path> with_companions(const fs::path& file) {
  std::error_code error;
  std::vector<fs::path> files{file};
  for (const char* extension : {".dbf", ".prj"}) {
    fs::path companion = file;
    companion.replace_extension(extension);
    if (companion != file && fs::is_regular_file(companion, error)) files.push_back(companion);
  }
  return files;
}

/// Visitor of a case that collects the files its keys hold.
class FileCollector {
 public:
  template <class T>
  void operator()(const Key& /*key*/, T& member) {
    if constexpr (std::is_same_v<T, fs::path>) add(member);
    if constexpr (std::is_same_v<T, LineSource>) add(member.file);
  }
  template <class T>
  void table(std::string_view /*name*/, std::string_view /*help*/, T& member) {
    member.describe(*this);
  }
  template <class T>
  void tables(std::string_view /*name*/, std::string_view /*help*/, std::vector<T>& members) {
    for (T& member : members) member.describe(*this);
  }

  std::vector<fs::path> take() { return std::move(files_); }

 private:
  void add(const fs::path& path) {
    std::error_code error;
    std::vector<fs::path> found;
    if (fs::is_regular_file(path, error)) found = with_companions(path);
    if (fs::is_directory(path, error)) {
      fs::recursive_directory_iterator entry(path, error);
      for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        if (entry->is_regular_file(error)) found.push_back(entry->path());
      std::sort(found.begin(), found.end());
    }
    for (fs::path& file : found)
      if (std::find(files_.begin(), files_.end(), file) == files_.end())
        files_.push_back(std::move(file));
  }

  std::vector<fs::path> files_;
};

}  // namespace

std::vector<fs::path> input_files(Case c) {
  FileCollector collector;
  c.describe(collector);
  return collector.take();
}

}  // namespace sabo
