#include "run/read_manifest.hpp"

#include <utility>

#include "base/error.hpp"
#include "io/output/read_file.hpp"

namespace sabo {
namespace {

constexpr const char* remedy = "give a folder that `sabo run` has written";

}  // namespace

TomlTable parse_manifest(std::string_view text, const std::string& name) {
  Faults faults;
  auto manifest = parse_toml(text, name, faults, largest_manifest);
  faults.throw_if_any();
  const TomlNode* run = find(*manifest, "run");
  if (!run || !std::holds_alternative<TomlTable>(run->value))
    throw CaseError(name, "has no table [run]", remedy);
  return std::move(*manifest);
}

TomlTable read_manifest(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "manifest.toml";
  const auto text = read_file(file, largest_manifest);
  if (!text)
    throw CaseError(folder.string(), "is not the folder of a run: it has no readable manifest.toml",
                    remedy);
  return parse_manifest(*text, file.string());
}

}  // namespace sabo
