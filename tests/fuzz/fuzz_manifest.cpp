#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.hpp"
#include "run/read_manifest.hpp"
#include "run/run_info.hpp"

/// Whatever the bytes: a manifest is refused, or what it says can be told.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const sabo::TomlTable manifest = sabo::parse_manifest(text, "manifest.toml");
    if (sabo::manifest_text(manifest).empty()) __builtin_trap();
  } catch (const sabo::CaseError&) {
  }
  return 0;
}
