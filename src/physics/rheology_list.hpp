#pragma once

#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "physics/rheology/bingham.hpp"
#include "physics/rheology/cross.hpp"
#include "physics/rheology/general_cross.hpp"
#include "physics/rheology/newtonian.hpp"

namespace sabo {

/// The one list of rheologies. Each is a plain struct with
///   name, summary          words of the case file and of `sabo models`
///   has_yield              whether the keys of MohrCoulomb apply
///   describe(v)            its parameters
///   viscosity(gd, tau_B)   effective viscosity, Pa s, at shear rate gd (1/s) and yield stress (Pa)
///   max_viscosity()        upper bound of viscosity(), Pa s
using Rheology = std::variant<Cross, Bingham, GeneralCross, Newtonian>;

inline std::string_view name_of(const Rheology& law) {
  return std::visit([](const auto& l) { return std::string_view(l.name); }, law);
}

inline bool has_yield(const Rheology& law) {
  return std::visit([](const auto& l) { return l.has_yield; }, law);
}

/// Every law once, with its default parameters, in the order of the list.
inline std::vector<Rheology> all_rheologies() {
  constexpr auto make = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<Rheology>{Rheology(std::in_place_index<I>)...};
  };
  return make(std::make_index_sequence<std::variant_size_v<Rheology>>());
}

}  // namespace sabo
