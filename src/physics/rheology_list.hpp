#pragma once

#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "physics/rheology/bingham.hpp"
#include "physics/rheology/cross.hpp"
#include "physics/rheology/frigaard_nouar.hpp"
#include "physics/rheology/general_cross.hpp"
#include "physics/rheology/herschel_bulkley.hpp"
#include "physics/rheology/mu_i.hpp"
#include "physics/rheology/newtonian.hpp"
#include "physics/rheology/papanastasiou.hpp"
#include "physics/rheology/quadratic.hpp"
#include "physics/rheology/threshold.hpp"

namespace sabo {

/// The one list of rheologies. Each is a plain struct with
///   name, summary          words of the case file and of `sabo models`
///   has_yield              whether the keys of MohrCoulomb apply
///   describe(v)            its parameters
///   viscosity(shear)       effective viscosity, Pa s, at a shear rate, yield stress and pressure
///   max_viscosity()        upper bound of viscosity(), Pa s
/// Beside its line here a law has a page, docs/rheology/NAME.md, and a table of expected values,
/// tests/physics/rheology/NAME.csv; both are looked for by the tests.
using Rheology = std::variant<Cross, Bingham, FrigaardNouar, Threshold, Papanastasiou,
                              HerschelBulkley, Quadratic, MuI, GeneralCross, Newtonian>;

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
