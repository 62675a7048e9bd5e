#include "host/output/snapshot_series.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "common/binary_stream.hpp"
#include "host/output/output_times.hpp"
#include "host/output/series_writer.hpp"

namespace tentpole {
namespace {

using Fields = std::vector<const OutputField*>;

/// Numbers per point or per cell.
std::size_t num_values(const Fields& fields, FieldPlace place) {
  std::size_t count = 0;
  for (const OutputField* field : fields)
    if (field->place == place) count += field->num_components;
  return count;
}

void append_values(const Fields& fields, FieldPlace place, const SpacetimeElement& element, const PointFields& at_point,
                   std::vector<double>& values) {
  for (const OutputField* field : fields)
    if (field->place == place) field->append(element, at_point, values);
}

std::string snapshot_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "snapshot_%04d.vtkhdf", index);
  return name;
}

/// Splits mixed values into the grid's arrays, as often as they repeat.
void append_values(std::span<const double> values, std::vector<GridArray<double>>& arrays) {
  for (std::size_t value = 0; value < values.size();)
    for (GridArray<double>& array : arrays) {
      const auto part = values.subspan(value, array.num_components);
      array.values.insert(array.values.end(), part.begin(), part.end());
      value += array.num_components;
    }
}

void append_piece(const SnapshotPiece& piece, std::int64_t number, UnstructuredGrid& grid) {
  const auto first_point = static_cast<std::int64_t>(grid.points.size() / 3);
  for (const auto& point : piece.cells.points) grid.points.insert(grid.points.end(), point.begin(), point.end());
  for (const int corner : piece.cells.connectivity) grid.connectivity.push_back(first_point + corner);
  const int corners = num_corners(piece.cells.shape);
  const auto num_cells = piece.cells.connectivity.size() / corners;
  for (std::size_t cell = 0; cell < num_cells; ++cell) grid.offsets.push_back(grid.offsets.back() + corners);
  grid.types.insert(grid.types.end(), num_cells, static_cast<std::uint8_t>(piece.cells.shape));
  grid.cell_numbers[0].values.insert(grid.cell_numbers[0].values.end(), num_cells, number);
  grid.cell_numbers[1].values.insert(grid.cell_numbers[1].values.end(), num_cells, piece.region);
  for (std::size_t cell = 0; cell < num_cells; ++cell) append_values(piece.cell_values, grid.cell_data);
  append_values(piece.values, grid.point_data);
}

/// Bytes of a piece without points, less than any takes.
constexpr std::size_t smallest_piece = 8 * sizeof(double);

void save_piece(std::ostream& stream, const SnapshotPiece& piece) {
  write_value(stream, piece.place);
  write_value(stream, piece.id);
  write_value(stream, piece.region);
  write_value(stream, piece.cells.shape);
  write_vector(stream, piece.cells.points);
  write_vector(stream, piece.cells.connectivity);
  write_vector(stream, piece.values);
  write_vector(stream, piece.cell_values);
}

bool is_shape(SliceShape shape) {
  switch (shape) {
    case SliceShape::segment:
    case SliceShape::triangle:
    case SliceShape::quad:
    case SliceShape::tetrahedron:
    case SliceShape::wedge:
      return true;
  }
  return false;
}

SnapshotPiece load_piece(std::istream& stream, const Fields& fields) {
  SnapshotPiece piece;
  piece.place = read_value<std::array<double, 4>>(stream);
  piece.id = read_value<std::int64_t>(stream);
  piece.region = read_value<std::int64_t>(stream);
  piece.cells.shape = read_value<SliceShape>(stream);
  require_sound(stream, is_shape(piece.cells.shape), "a slice has an unknown shape");
  piece.cells.points = read_vector<std::array<double, 3>>(stream);
  piece.cells.connectivity = read_vector<int>(stream);
  piece.values = read_vector<double>(stream);
  piece.cell_values = read_vector<double>(stream);
  const auto num_points = static_cast<std::int64_t>(piece.cells.points.size());
  require_sound(stream, piece.cells.connectivity.size() % num_corners(piece.cells.shape) == 0, "a cell lacks corners");
  for (const int corner : piece.cells.connectivity)
    require_sound(
        stream, corner >= 0 && corner < num_points,
        "corner " + std::to_string(corner) + " of a cell is none of " + std::to_string(num_points) + " points");
  require_sound(stream,
                piece.values.size() == num_points * num_values(fields, FieldPlace::point) &&
                    piece.cell_values.size() == num_values(fields, FieldPlace::cell),
                "a piece of a snapshot lacks values");
  return piece;
}

}  // namespace

SnapshotSeries::SnapshotSeries(Options options)
    : options_(std::move(options)), fields_(output_fields(options_.fields)), pieces_(options_.times.size()) {
  check_output_times(options_.times, "snapshots");
}

void SnapshotSeries::record(const SpacetimeElement& element, const ElementFields& fields) {
  const int dimension = element.dimension;
  const OutputRange indices = range(element.time_min(), element.time_max());
  for (int index = indices.first; index < indices.last; ++index) {
    const double time = options_.times[index];
    if (index < num_written_)
      throw std::logic_error("element " + std::to_string(element.id) + " covers snapshot " + std::to_string(index) +
                             ", which was written before; finish() was called with a front time that is too late");
    const std::optional<Slice> slice = slice_element(element, time);
    if (!slice) continue;
    SnapshotPiece piece{
        element.centroid(), element.id, element.region, subdivide(*slice, options_.num_subdivisions), {}, {}};
    append_values(fields_, FieldPlace::cell, element, {}, piece.cell_values);
    for (const auto& point : piece.cells.points) {
      std::array<double, 4> event{point[0], point[1], point[2], 0};
      event[dimension] = time;
      PointFields value = fields.at(std::span(event).first(dimension + 1));
      if (options_.plane_stress) value.stress[2] = 0;
      append_values(fields_, FieldPlace::point, element, value, piece.values);
    }
    pieces_[index].push_back(std::move(piece));
  }
}

void SnapshotSeries::finish(double front_minimum_time) {
  const int num_times = static_cast<int>(options_.times.size());
  while (num_written_ < num_times && front_has_passed(front_minimum_time, options_.times[num_written_])) {
    write_snapshot(num_written_);
    ++num_written_;
    write_series_file();
  }
}

void SnapshotSeries::write_snapshot(int index) {
  std::vector<SnapshotPiece> pieces = std::move(pieces_[index]);
  pieces_[index] = {};
  std::sort(pieces.begin(), pieces.end(), [](const SnapshotPiece& a, const SnapshotPiece& b) {
    return std::tie(a.place, a.id) < std::tie(b.place, b.id);
  });
  UnstructuredGrid grid;
  grid.time = options_.times[index];
  grid.cell_numbers = {{"element", 1, {}}, {"region", 1, {}}};
  for (const OutputField* field : fields_)
    (field->place == FieldPlace::point ? grid.point_data : grid.cell_data)
        .push_back({std::string(field->name), field->num_components, {}});
  for (std::size_t number = 0; number < pieces.size(); ++number)
    append_piece(pieces[number], static_cast<std::int64_t>(number), grid);
  write_vtkhdf(options_.folder, snapshot_name(index), grid);
}

void SnapshotSeries::write_series_file() const {
  std::vector<SeriesEntry> entries;
  for (int index = 0; index < num_written_; ++index) entries.push_back({snapshot_name(index), options_.times[index]});
  write_series(options_.folder, "snapshot.vtkhdf.series", entries);
}

void SnapshotSeries::save(std::ostream& stream) const {
  write_value(stream, num_written_);
  write_value(stream, pieces_.size());
  for (const auto& pieces : pieces_) {
    write_value(stream, pieces.size());
    for (const SnapshotPiece& piece : pieces) save_piece(stream, piece);
  }
}

void SnapshotSeries::load(std::istream& stream) {
  num_written_ = read_number(stream, static_cast<int>(options_.times.size()), "the number of written snapshots");
  const auto num_times = read_value<std::size_t>(stream);
  if (num_times != options_.times.size())
    throw std::runtime_error("the checkpoint has " + std::to_string(num_times) + " snapshot times and the case " +
                             std::to_string(options_.times.size()) + "; resume with the case file of the checkpoint");
  for (auto& pieces : pieces_) {
    pieces.clear();
    for (auto left = read_length(stream, smallest_piece); left > 0; --left)
      pieces.push_back(load_piece(stream, fields_));
  }
}

void SnapshotSeries::add_written(WrittenFiles& files) const {
  for (int index = 0; index < num_written_; ++index) files.push_back({options_.folder / snapshot_name(index)});
  if (num_written_ > 0) files.push_back({options_.folder / "snapshot.vtkhdf.series"});
}

}  // namespace tentpole
