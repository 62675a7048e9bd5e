#include "kernels/transplant.hpp"

#include <cstdio>
#include <cstdlib>

#include "kernels/transplant_element.hpp"
#include "kernels/with_dimension.hpp"

namespace tentpole {
namespace {

template <int D>
void run_on_host(const TransplantTask& task) {
#pragma omp parallel for schedule(monotonic : dynamic, 8) num_threads(task.shape.workers)
  for (int request = 0; request < task.num_requests; ++request) transplant_element<D>(task, request);
}

#ifdef TENTPOLE_OFFLOAD
template <int D>
void run_on_cpu_device(const TransplantTask task, int device_number) {
  const int num_requests = task.num_requests, workers = task.shape.workers;
#pragma omp target teams num_teams(1) device(device_number) firstprivate(task)
#pragma omp parallel for num_threads(workers) schedule(monotonic : dynamic, 8)
  for (int request = 0; request < num_requests; ++request) transplant_element<D>(task, request);
}

template <int D>
void run_on_gpu(const TransplantTask task, int device_number) {
  const int num_requests = task.num_requests;
#pragma omp target teams distribute parallel for device(device_number) firstprivate(task)
  for (int request = 0; request < num_requests; ++request) transplant_element<D>(task, request);
}
#endif

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
  with_dimension(task.tables.dimension, [&](auto dimension) { run_on_host<dimension()>(task); });
}

void transplant_device([[maybe_unused]] const TransplantTask& task, [[maybe_unused]] int device_number) {
#ifdef TENTPOLE_OFFLOAD
  with_dimension(task.tables.dimension, [&](auto dimension) {
    if (task.shape.lanes == 1)
      run_on_cpu_device<dimension()>(task, device_number);
    else
      run_on_gpu<dimension()>(task, device_number);
  });
#else
  std::fputs("transplant_device: this build has no device code (preset host)\n", stderr);
  std::abort();
#endif
}

}  // namespace tentpole
