#include "kernels/launch/transplant.hpp"

#include "kernels/element/with_dimension.hpp"
#include "kernels/formulation/one_field/transplant_element.hpp"

namespace tentpole {
namespace {

constexpr int chunk = 8;  // requests that a thread takes at a time

/// One request.
template <int D>
struct Transplant {
  TransplantTask task;
  void operator()(int request) const { transplant_element<D>(task, request); }
};

/// Reference coordinates of a corner of the element: corner 0 is the origin, corner l the l-th unit point.
double reference_coordinate(int corner, int l) {
  return corner == l + 1 ? 1.0 : 0.0;
}

}  // namespace

TransplantRequest cell_part_request(int dimension, int source_facet, const CellPart& part) {
  TransplantRequest request{};
  request.source_slot = request.target_slot = none;
  const int opposite = source_facet <= dimension + 1 ? source_facet : source_facet - dimension - 2;
  int listed[max_dimension + 1];
  for (int i = 0, corner = 0; i <= dimension; ++corner)
    if (corner != opposite || source_facet > dimension + 1) listed[i++] = corner;
  if (source_facet > dimension + 1) listed[opposite] = dimension + 1;
  for (int l = 0; l <= dimension; ++l) {
    for (int vertex = 0; vertex <= dimension; ++vertex)
      for (int i = 0; i <= dimension; ++i)
        request.corner[vertex][l] += part[vertex][i] * reference_coordinate(listed[i], l);
    request.corner[dimension + 1][l] = reference_coordinate(opposite, l);
  }
  return request;
}

void transplant_host(const TransplantTask& task) {
  with_dimension(task.tables.dimension, [&](auto dimension) {
    loop_on_host(task.shape, task.num_requests, chunk, Transplant<dimension()>{task});
  });
}

void transplant_device([[maybe_unused]] const TransplantTask& task, [[maybe_unused]] int device_number) {
#ifdef TENTPOLE_OFFLOAD
  with_dimension(task.tables.dimension, [&](auto dimension) {
    loop_on_device(task.shape, task.num_requests, chunk, Transplant<dimension()>{task}, device_number);
  });
#else
  refuse_launch("transplant_device");
#endif
}

}  // namespace tentpole
