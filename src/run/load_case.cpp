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

}  // namespace sabo
