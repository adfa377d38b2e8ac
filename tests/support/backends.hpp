#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/device_on_host.hpp"
#include <gtest/gtest.h>

#include "solver/make_backend.hpp"

// What a test of all backends runs on. `device` is the code of graphics cards, run on the host;
// `cuda` the same on a card, where there is one.

namespace sabo::test {

enum class On { reference, cpu, device, cuda };

inline std::string word_of(On on) {
  const char* const words[] = {"reference", "cpu", "device", "cuda"};
  return words[static_cast<int>(on)];
}

inline std::unique_ptr<Backend> make_backend(On on, const FlowModel& model) {
  switch (on) {
    case On::reference:
      return sabo::make_backend(BackendKind::reference, model);
    case On::cpu:
      return sabo::make_backend(BackendKind::cpu, model);
    case On::device:
      return std::make_unique<DeviceOnHost>(model);
    case On::cuda:
      break;
  }
  return sabo::make_backend(BackendKind::cuda, model);
}

/// Why nothing can run on a graphics card here; empty if it can.
inline std::string cuda_is_missing() { return missing_backend(BackendKind::cuda); }

/// Those that this machine has: for loops within a test.
inline std::vector<On> backends() {
  std::vector<On> list{On::reference, On::cpu, On::device};
  if (cuda_is_missing().empty()) list.push_back(On::cuda);
  return list;
}

/// For tests with a backend as their parameter: skipped, with the reason, where it is missing.
class OnBackend : public testing::TestWithParam<On> {
 protected:
  void SetUp() override {
    if (GetParam() == On::cuda && !cuda_is_missing().empty()) GTEST_SKIP() << cuda_is_missing();
  }
};

inline constexpr On all_backends[] = {On::reference, On::cpu, On::device, On::cuda};
inline const auto name_of_backend = [](const auto& test) { return word_of(test.param); };

}  // namespace sabo::test
