#include "host/output/crack_grid.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/element/quadrature.hpp"

namespace tentpole {
namespace {

enum class CrackCell : std::uint8_t { vertex = 1, line = 3 };  // VTK's numbers

enum PointArray { damage, opening };
enum CellArray { edge, mode };

void append_point(const CrackSegment& segment, double place, int value, UnstructuredGrid& grid) {
  for (int i = 0; i < 3; ++i) grid.points.push_back((1 - place) * segment.end[0][i] + place * segment.end[1][i]);
  grid.point_data[damage].values.push_back(segment.damage[value]);
  grid.point_data[opening].values.push_back(segment.opening[value]);
}

void append_cell(const CrackSegment& segment, CrackCell kind, std::int64_t first_point, UnstructuredGrid& grid) {
  const int num_corners = kind == CrackCell::line ? 2 : 1;
  for (int corner = 0; corner < num_corners; ++corner) grid.connectivity.push_back(first_point + corner);
  grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
  grid.types.push_back(static_cast<std::uint8_t>(kind));
  grid.cell_numbers[edge].values.push_back(segment.id);
  grid.cell_numbers[mode].values.push_back(static_cast<std::int64_t>(segment.mode));
}

void append_chain(const CrackSegment& segment, UnstructuredGrid& grid) {
  const Quadrature gauss = gauss_jacobi(segment.num_points, 0);
  const auto first_point = static_cast<std::int64_t>(grid.points.size() / 3);
  append_point(segment, 0, 0, grid);
  for (int point = 0; point < segment.num_points; ++point) append_point(segment, gauss.points[point], point, grid);
  append_point(segment, 1, segment.num_points - 1, grid);
  for (int line = 0; line <= segment.num_points; ++line)
    append_cell(segment, CrackCell::line, first_point + line, grid);
}

}  // namespace

void check_segment(const CrackSegment& segment, int dimension) {
  const int largest = dimension == 1 ? 1 : static_cast<int>(segment.damage.size());
  if (segment.num_points < 1 || segment.num_points > largest)
    throw std::invalid_argument("fracture edge " + std::to_string(segment.id) + " has " +
                                std::to_string(segment.num_points) + " points; it should have 1 to " +
                                std::to_string(largest));
}

UnstructuredGrid crack_grid(int dimension, double time, std::span<const CrackSegment> segments) {
  std::vector<const CrackSegment*> sorted;
  for (const CrackSegment& segment : segments) sorted.push_back(&segment);
  std::sort(sorted.begin(), sorted.end(), [](const CrackSegment* a, const CrackSegment* b) {
    return std::pair(a->id, a->begin) < std::pair(b->id, b->begin);
  });
  UnstructuredGrid grid;
  grid.time = time;
  grid.point_data = {{"damage", 1, {}}, {"opening", 1, {}}};
  grid.cell_numbers = {{"edge", 1, {}}, {"mode", 1, {}}};
  for (const CrackSegment* segment : sorted) {
    check_segment(*segment, dimension);
    if (dimension == 2) {
      append_chain(*segment, grid);
      continue;
    }
    append_point(*segment, 0, 0, grid);
    append_cell(*segment, CrackCell::vertex, static_cast<std::int64_t>(grid.points.size() / 3) - 1, grid);
  }
  return grid;
}

}  // namespace tentpole
