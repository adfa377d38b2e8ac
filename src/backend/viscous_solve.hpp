#pragma once

namespace sabo {

/// How an implicit step of viscosity went.
struct ViscousSolve {
  int iterations = 0;
  bool converged = true;
  double heat = 0;  ///< kinetic energy that viscosity and walls took, J
};

}  // namespace sabo
