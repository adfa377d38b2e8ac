#include "run/load_case.hpp"

#include "run/avaframe.hpp"

namespace sabo {

Case load_case(const std::filesystem::path& path, Faults& faults,
               const std::vector<Override>& overrides) {
  if (const auto made = avaframe_case(path))
    return read_case_text(made->text, made->folder, faults, overrides,
                          "case made from " + path.string());
  return read_case(path, faults, overrides);
}

std::string name_of_case(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::absolute(path, error).lexically_normal();
  if (!std::filesystem::is_directory(folder, error)) folder = folder.parent_path();
  if (!folder.has_filename()) folder = folder.parent_path();  // "name/" has an empty last part
  const std::string name = folder.filename().string();
  return name.empty() ? "case" : name;
}

}  // namespace sabo
