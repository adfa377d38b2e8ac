#include "verify/verification.hpp"

#include "verify/cases.hpp"

namespace sabo {

const std::vector<Verification>& verifications() {
  static const std::vector<Method> both{Method::fast, Method::paper};
  static const std::vector<Verification> list{
      {"slab", "Frictional slab on an infinite slope, from rest",
       "the same rheology in one dimension, by finite volumes", both, verify_slab},
      {"runout",
       "Run-out of a block from 33 to 5 degrees, by both methods",
       "explicit two-point viscosity (Morris et al. 1997) and walls of Adami et al. (2012)",
       {Method::fast},
       verify_runout},
  };
  return list;
}

}  // namespace sabo
