#include "tests/host/march/resting_front.hpp"

#include "tests/host/run/case_text.hpp"
#include "tests/host/run/solved_run.hpp"

namespace tentpole::testing {
namespace {

Simulation unit_square(int intervals) {
  CaseText text;
  text.dimension = 2;
  text.cells = {intervals, intervals};
  for (const char* side : {"left", "right", "bottom", "top"})
    text.rest += std::string("[boundary.") + side + "]\nabsorbing = true\n";
  text.rest +=
      "[adaptivity]\nenabled = true\nerror_tolerance = 1e-3\nmin_size = 1e-3\nmax_size = 1\n"
      "[fracture]\nenabled = true\nthreshold = 1\nstrength = 2\nrelaxation_time = 1\n";
  return simulation_of(text.text());
}

}  // namespace

RestingFront::RestingFront(int intervals, double crack_size, double growth_length)
    : simulation(unit_square(intervals)),
      books(simulation),
      state{.books = books.get(),
            .front = AdaptiveFront(simulation.mesh, std::vector{simulation.scaled_materials[0].dilatational_speed()})} {
  state.limits.crack_size = crack_size / unit();
  state.limits.growth_length = growth_length / unit();
  state.limits.max_size = 1 / unit();
  state.limits.max_pole_height = std::numeric_limits<double>::infinity();
  state.limits.law = scaled_fracture_law(simulation);
  state.follow_front();
  std::ranges::fill(state.sources.slot, none);
}

Point RestingFront::place(std::int32_t vertex) const {
  Point position = state.front.mesh().position(vertex);
  for (double& coordinate : position) coordinate *= unit();
  return position;
}

}  // namespace tentpole::testing
