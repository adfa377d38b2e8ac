#include "io/gis/fg_gml_files.hpp"

#include <atomic>
#include <cctype>
#include <memory>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal.h>

#include "base/error.hpp"
#include "io/gis/gdal_errors.hpp"

namespace sabo {
namespace {

constexpr int max_entries = 200'000;
constexpr int max_depth = 8;  // folders in folders; links may lead in circles
constexpr GIntBig max_text = 200'000'000;
constexpr GIntBig max_inner_zip = 2'000'000'000;
constexpr const char* archive_form =
    "give a tile, or a folder or .zip of tiles, named such as FG-GML-6444-11-DEM5A-20161001.xml";

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

bool is_tile(const std::string& path) {
  const std::string name = upper(file_name(path));
  const bool is_shadow = name.starts_with("._");  // what macOS puts beside a file in a .zip
  return name.ends_with(".XML") && name.find("DEM") != std::string::npos && !is_shadow;
}

bool is_zip(const std::string& path) { return upper(path).ends_with(".ZIP"); }

std::string inside(const std::string& zip) { return "/vsizip/{" + zip + "}"; }

// Bytes of a file; `name` is how messages call it.
struct Content {
  Content(const std::string& path, const std::string& name, GIntBig limit) {
    const GdalErrors errors;
    if (VSIIngestFile(nullptr, path.c_str(), &bytes, &size, limit)) return;
    throw CaseError("terrain.dem", name + " cannot be read: " + errors.failure("unknown reason"),
                    "download it again");
  }
  ~Content() { VSIFree(bytes); }
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;

  GByte* bytes = nullptr;
  vsi_l_offset size = 0;
};

// A .zip of a .zip as a file in memory: within the outer one, each jump would unpack it anew.
class InnerZip {
 public:
  InnerZip(const std::string& path, const std::string& name) : content_(path, name, max_inner_zip) {
    static std::atomic<unsigned> count = 0;  // GDAL remembers what is in a .zip by its name
    path_ = fmt::format("/vsimem/sabo_inner_{}.zip", ++count);
    VSIFCloseL(VSIFileFromMemBuffer(path_.c_str(), content_.bytes, content_.size, FALSE));
  }
  ~InnerZip() { VSIUnlink(path_.c_str()); }
  InnerZip(const InnerZip&) = delete;
  InnerZip& operator=(const InnerZip&) = delete;

  const std::string& path() const { return path_; }

 private:
  Content content_;
  std::string path_;
};

class Visit {
 public:
  explicit Visit(const std::function<void(const std::string&, const std::string&)>& use)
      : use_(use) {}

  void file(const std::string& path, const std::string& name) {
    const Content content(path, name, max_text);
    use_(name, std::string(reinterpret_cast<const char*>(content.bytes), content.size));
    ++tiles_;
  }

  void folder(const std::string& root, const std::string& name, int zips_left) {
    using Dir = std::unique_ptr<VSIDIR, decltype(&VSICloseDir)>;
    const Dir dir(VSIOpenDir(root.c_str(), max_depth, nullptr), &VSICloseDir);
    if (!dir) return;
    while (const VSIDIREntry* entry = VSIGetNextDirEntry(dir.get())) {
      const std::string path = root + "/" + entry->pszName;
      const std::string own = name + "/" + entry->pszName;
      if (++entries_ > max_entries) {
        throw CaseError("terrain.dem",
                        fmt::format("{} holds more than {} files", name, max_entries),
                        archive_form);
      }
      if (is_tile(path)) file(path, own);
      if (is_zip(path) && zips_left > 0) zip(path, own, zips_left - 1);
    }
  }

  int tiles() const { return tiles_; }

 private:
  void zip(const std::string& path, const std::string& name, int zips_left) {
    if (!path.starts_with("/vsizip/")) return folder(inside(path), name, zips_left);
    const InnerZip inner(path, name);
    folder(inside(inner.path()), name, zips_left);
  }

  const std::function<void(const std::string&, const std::string&)>& use_;
  int entries_ = 0;
  int tiles_ = 0;
};

}  // namespace

bool may_be_fg_gml(const std::filesystem::path& file) {
  const GdalErrors errors;
  std::error_code ignored;
  const std::string name = file.string();
  const bool is_folder = std::filesystem::is_directory(file, ignored);
  if (!is_folder && !is_zip(name) && !upper(name).ends_with(".XML")) return false;
  return GDALIdentifyDriverEx(name.c_str(), GDAL_OF_RASTER, nullptr, nullptr) == nullptr;
}

void for_each_fg_gml(
    const std::filesystem::path& file,
    const std::function<void(const std::string& name, const std::string& text)>& use) {
  const GdalErrors errors;
  std::error_code ignored;
  const std::string name = file.string();
  if (!std::filesystem::exists(file, ignored)) {
    throw CaseError("terrain.dem", name + " there is no such file",
                    "give a path relative to the case file");
  }
  const bool is_folder = std::filesystem::is_directory(file, ignored);
  Visit visit(use);
  if (!is_folder && !is_zip(name)) return visit.file(name, name);
  visit.folder(is_folder ? name : inside(name), name, is_folder ? 2 : 1);
  if (visit.tiles() == 0) {
    const std::string reason = errors.failed() ? ": " + errors.failure("") : "";
    throw CaseError("terrain.dem", name + " holds no DEM tile (*DEM*.xml)" + reason, archive_form);
  }
}

std::string fg_gml_rank(const std::string& name) {
  const std::string own = upper(file_name(name));
  std::size_t at = own.find("DEM");
  if (at != std::string::npos) at = own.find_first_not_of("0123456789.", at + 3);
  const bool has_letter = at != std::string::npos && own[at] >= 'A' && own[at] <= 'Z';
  const char from_last = static_cast<char>(has_letter ? 'Z' - own[at] + 'A' : 'A');
  return from_last + own + name;
}

}  // namespace sabo
