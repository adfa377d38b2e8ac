#pragma once

namespace sabo {

/// A drop that stays an ellipse: with velocity sigma (x, -z), pressure P rho (1 - x^2/a^2 -
/// z^2/b^2) and a force -omega^2 (x, z): P = (sigma^2 + omega^2) a^2 b^2 / (a^2 + b^2), d sigma/dt
/// = (sigma^2 + omega^2) (b^2 - a^2) / (a^2 + b^2), da/dt = sigma a, db/dt = -sigma b (Monaghan &
/// Rafiee 2013; omega = 0: Monaghan 1994).
struct EllipticDrop {
  double sigma;
  double omega;
  double a = 1, b = 1;

  double pressure() const {  // P
    return (sigma * sigma + omega * omega) * a * a * b * b / (a * a + b * b);
  }

  /// Runge and Kutta's fourth order.
  void advance(double dt) {
    const auto rate = [](const EllipticDrop& e) {
      const double a2 = e.a * e.a, b2 = e.b * e.b;
      const double turn = (e.sigma * e.sigma + e.omega * e.omega) * (b2 - a2) / (a2 + b2);
      return EllipticDrop{turn, 0, e.sigma * e.a, -e.sigma * e.b};
    };
    const auto moved = [&](const EllipticDrop& k, double t) {
      return EllipticDrop{sigma + t * k.sigma, omega, a + t * k.a, b + t * k.b};
    };
    const EllipticDrop k1 = rate(*this), k2 = rate(moved(k1, dt / 2)), k3 = rate(moved(k2, dt / 2)),
                       k4 = rate(moved(k3, dt));
    const EllipticDrop mean{(k1.sigma + 2 * k2.sigma + 2 * k3.sigma + k4.sigma) / 6, 0,
                            (k1.a + 2 * k2.a + 2 * k3.a + k4.a) / 6,
                            (k1.b + 2 * k2.b + 2 * k3.b + k4.b) / 6};
    *this = moved(mean, dt);
  }
};

}  // namespace sabo
