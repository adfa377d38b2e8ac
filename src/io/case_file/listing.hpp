#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace sabo {

/// One key of a table as text, for files and documents.
struct ListedKey {
  std::string name;
  std::string help;
  std::string unit;
  std::string wanted;  ///< what may be written: "a number from 0 to 60 deg"
  std::string value;   ///< in TOML; empty when there is none
  bool is_required = false;
};

struct ListedTable {
  std::string name;  ///< "structure.notch"; empty for the keys at the head of the file
  std::string help;
  bool is_list = false;  ///< one of [[name]]
  bool is_given = true;  ///< false for a table that the case does not have, listed for its keys
  std::vector<ListedKey> keys{};
};

/// Every table and key of the case in the order of the documentation. Lists that are empty and
/// tables that are not given appear once with their defaults.
std::vector<ListedTable> list_tables(Case c);

/// The keys of [numerics] with their values.
std::vector<ListedKey> list_keys(NumericsCase numerics);

/// The keys of a rheology with its values, those of its yield stress included.
std::vector<ListedKey> list_keys(Rheology law, MohrCoulomb yield = {});

}  // namespace sabo
