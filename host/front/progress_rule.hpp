#pragma once

#include "host/front/front_simplex.hpp"

namespace tentpole {

/// Latest time that corner `corner` of a cell may have, given those of the others: progress rule B for D = 2
/// (docs/formulation.md, Progress), the travel time for D = 1. `slope_limit` = g = gamma / c.
///   D = 2, corners (v, q, r): the smaller of tau_q + s x + h sqrt(g^2 - s^2) (exact causal limit) and, for w = q and
///   r, tau_w + f_e g |vw| with f_e = (1 - eps) min(1, sin phi over the obtuse angles at v and w), eps = 0.3; D = 1:
///   tau_w + g |vw|.
double latest_corner_time(const FrontSimplex& cell, int corner, double slope_limit);

/// Largest |tau_a - tau_b| / (f_e g |ab|) over the edges of a cell: <= 1 where it obeys the progress rule.
double edge_limit_use(const FrontSimplex& cell, double slope_limit);

/// Whether a cell is causal and obeys the progress rule, up to rounding (1e-9): every cell that an operation makes
/// must, or later minima of the front get stuck.
bool may_be_on_front(const FrontSimplex& cell, double slope_limit);

}  // namespace tentpole
