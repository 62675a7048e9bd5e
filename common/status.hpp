#pragma once

namespace tentpole {

/// What a kernel reports about one element or patch. Kernels never throw; the host turns the first bad status into an
/// exception that names the entity (style guide, section 7).
enum class Status : int {
  ok = 0,
  inverted_element = 1,  ///< spacetime volume not positive
  not_causal = 2,        ///< inflow (outflow) facet steeper than the wave speed allows, or above (below) the element
  singular_pivot = 3,    ///< a pivot of the unpivoted elimination vanished or is not finite
  coupling_not_converged = 4,  ///< the amplitude system of the patch did not reach its tolerance
  residual_too_large = 5,      ///< relative residual above tolerance after refinement
  damage_not_converged = 6,    ///< the damage loop of a patch with fracture facets did not settle
  patch_not_general = 7,  ///< inclined tent or general element in a patch that is not declared general, or for D = 3
  boundary_not_vertical = 8,  ///< boundary or fracture facet that is not parallel to the time axis
};

constexpr const char* status_name(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::inverted_element:
      return "inverted element";
    case Status::not_causal:
      return "inflow or outflow facet not causal";
    case Status::singular_pivot:
      return "singular pivot";
    case Status::coupling_not_converged:
      return "amplitude coupling not converged";
    case Status::residual_too_large:
      return "residual too large";
    case Status::damage_not_converged:
      return "damage not converged";
    case Status::patch_not_general:
      return "inclined or general element in a patch that takes none";
    case Status::boundary_not_vertical:
      return "boundary or fracture facet not vertical";
  }
  return "unknown status";
}

}  // namespace tentpole
