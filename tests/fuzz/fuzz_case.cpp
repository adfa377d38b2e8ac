#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/case_file/read_case.hpp"
#include "io/case_file/write_case.hpp"

/// Whatever the bytes: the reader returns, and a case without faults can be written and read back.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  sabo::Faults faults;
  const sabo::Case c = sabo::read_case_text(text, "/", faults);
  if (!faults.empty()) return 0;
  sabo::Faults none;
  sabo::read_case_text(sabo::write_case(c), "/", none);
  if (!none.empty()) __builtin_trap();
  return 0;
}
