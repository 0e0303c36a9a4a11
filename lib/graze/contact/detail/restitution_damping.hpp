// Which damping of a contact gives which restitution e, for a mass m that meets the stop at speed
// v: the formulas as published, their true restitution, and the coefficient that gives e exactly.
//
//   Kelvin-Voigt (n = 1)    C = 2 zeta sqrt(k m),  zeta = -ln e/sqrt(pi^2 + ln^2 e)
//                           exact where the contact ends at zero depth; at zero force
//                           e = exp(-zeta/sqrt(1 - zeta^2) arccos(2 zeta^2 - 1))
//   Lee & Wang's first      C = (3/4) alpha k,  e = 1 - alpha v to first order
//   Lee & Wang's second     C as Kelvin-Voigt's
//   Hunt & Crossley         C = (3/2) alpha k,  alpha = (1 - e)/v
//   Lankarani & Nikravesh   C = 3 k (1 - e^2)/(4 v)
//   Flores et al.           C = 8 k (1 - e)/(5 e v)
//   Jankowski (n = 3/2)     C = 2 zeta sqrt(k m),  from an approximate balance of energy
//                           zeta = (9 sqrt 5/2) (1 - e^2)/(e (e (9 pi - 16) + 16))
//
// The three before the last are F = k x^n (1 + d v): with A = d v_0 at a meeting speed v_0
//
//   A (1 + e) = ln[(1 + A)/(1 - A e)]
//
// holds exactly, whatever n, k and m.
//   P. Flores, M. Machado, M. T. Silva, J. M. Martins, Multibody Syst. Dyn. 25 (2011) 357-375.
#pragma once

namespace graze {

// zeta of a linear spring-dashpot that parts at zero depth with restitution 0 < e <= 1.
double damping_ratio_of(double restitution);
// e of a spring-dashpot with this zeta >= 0 that parts at zero depth (0 from zeta = 1 on), and of
// one that parts at zero force (where it is overdamped too).
double restitution_at_zero_depth(double zeta);
double restitution_at_zero_force(double zeta);
// zeta that gives e, 0 < e <= 1, parting at zero force; beyond 1 for the smallest e.
double damping_ratio_at_zero_force(double restitution);

// e of F = k x^n (1 + d v) met at v_0, by A = d v_0 >= 0; and A for 0 < e <= 1.
double restitution_of_power_damping(double a);
double power_damping_of(double restitution);

// d v_0 by the published formula of each model, for a requested restitution 0 < e <= 1.
double hunt_crossley_damping(double restitution);
double lankarani_nikravesh_damping(double restitution);
double flores_damping(double restitution);
// zeta of Jankowski's, likewise.
double jankowski_damping_ratio(double restitution);

}  // namespace graze
