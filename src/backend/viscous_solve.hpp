#pragma once

namespace sabo {

/// How an implicit step of viscosity went.
struct ViscousSolve {
  int iterations = 0;
  bool converged = true;
};

}  // namespace sabo
