#pragma once

#include <cstdio>

namespace sabo {

bool is_terminal(std::FILE* stream);

/// Whether to colour what goes there: a terminal that can, and no NO_COLOR (no-color.org).
bool takes_colour(std::FILE* stream);

/// Columns of a terminal; 80 where it does not tell.
int columns_of(std::FILE* stream);

}  // namespace sabo
