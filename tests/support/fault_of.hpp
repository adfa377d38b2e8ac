#pragma once

#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace sabo {

/// The only fault that `action` reports; fails the test when it reports none.
template <class Action>
Fault fault_of(Action&& action) {
  try {
    action();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.faults().size(), 1u);
    return error.faults().front();
  }
  ADD_FAILURE() << "no CaseError";
  return {};
}

/// The message of the RunError that `action` throws.
template <class Action>
std::string run_error_of(Action&& action) {
  try {
    action();
  } catch (const RunError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no RunError";
  return "";
}

}  // namespace sabo
