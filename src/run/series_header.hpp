#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace sabo {

/// Columns of a series that are about one of several things, as "p1 greatest depth [m]".
inline void add_columns(std::vector<std::string>& header, const std::string& name,
                        std::initializer_list<const char*> columns) {
  for (const char* column : columns) header.push_back(name + " " + column);
}

}  // namespace sabo
