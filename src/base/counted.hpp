#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace sabo {

/// "1 cell", "2 cells": of a noun whose plural ends in s.
template <std::integral Number>
std::string counted(Number count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace sabo
