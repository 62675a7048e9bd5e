#include "host/output/vtkhdf_writer.hpp"

#include <stdexcept>
#include <string_view>
#include <utility>

#include <hdf5.h>

#include "host/output/atomic_file.hpp"

namespace tentpole {
namespace {

/// An HDF5 identifier that closes itself; throws where HDF5 reports an error.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), std::string_view action) : id_(id), close_(close) {
    if (id < 0)
      throw std::runtime_error("HDF5 cannot " + std::string(action) + ". Check the free space and the permissions.");
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t result, const std::string& action) {
  if (result < 0) throw std::runtime_error("HDF5 cannot " + action + ". Check the free space and the permissions.");
}

/// Property list without time stamps, so equal grids give equal bytes.
Handle untimed(hid_t kind) {
  Handle list(H5Pcreate(kind), H5Pclose, "create a property list");
  require(H5Pset_obj_track_times(list, false), "turn off time stamps");
  return list;
}

template <class Value>
hid_t memory_type();
template <>
hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

/// Dataset [num_rows] or, with more than one component, [num_rows][num_components].
template <class Value>
void write_dataset(hid_t group, const std::string& name, const std::vector<Value>& values, int num_components = 1) {
  const hsize_t extent[] = {values.size() / num_components, static_cast<hsize_t>(num_components)};
  const Handle space(H5Screate_simple(num_components > 1 ? 2 : 1, extent, nullptr), H5Sclose, "create a data space");
  const Handle properties = untimed(H5P_DATASET_CREATE);
  const Handle dataset(
      H5Dcreate2(group, name.c_str(), memory_type<Value>(), space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
      "create the data set " + name);
  if (values.empty()) return;
  require(H5Dwrite(dataset, memory_type<Value>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write " + name);
}

Handle create_group(hid_t parent, const char* name) {
  const Handle properties = untimed(H5P_GROUP_CREATE);
  return {H5Gcreate2(parent, name, H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
          std::string("create group ") + name};
}

void write_attributes(hid_t group) {
  const hsize_t two = 2;
  const std::int64_t version[] = {1, 0};
  const Handle version_space(H5Screate_simple(1, &two, nullptr), H5Sclose, "create a data space");
  const Handle version_attribute(
      H5Acreate2(group, "Version", H5T_NATIVE_INT64, version_space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      "write Version");
  require(H5Awrite(version_attribute, H5T_NATIVE_INT64, version), "write Version");

  const std::string_view type = "UnstructuredGrid";
  const Handle string_type(H5Tcopy(H5T_C_S1), H5Tclose, "create a string type");
  require(H5Tset_size(string_type, type.size()), "create a string type");
  require(H5Tset_strpad(string_type, H5T_STR_NULLPAD), "create a string type");
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "create a data space");
  const Handle type_attribute(H5Acreate2(group, "Type", string_type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                              "write Type");
  require(H5Awrite(type_attribute, string_type, type.data()), "write Type");
}

template <class Value>
void check_array(const GridArray<Value>& array, std::size_t num_rows) {
  if (array.num_components < 1 || array.values.size() != num_rows * array.num_components)
    throw std::invalid_argument("grid array " + array.name + ": " + std::to_string(array.values.size()) +
                                " values for " + std::to_string(num_rows) + " rows of " +
                                std::to_string(array.num_components));
}

void check_grid(const UnstructuredGrid& grid) {
  const bool fits = grid.points.size() % 3 == 0 && grid.offsets.size() == grid.types.size() + 1 &&
                    grid.offsets.back() == static_cast<std::int64_t>(grid.connectivity.size());
  if (!fits) throw std::invalid_argument("grid: points, offsets, types and connectivity do not fit together");
  for (const auto& array : grid.point_data) check_array(array, grid.points.size() / 3);
  for (const auto& array : grid.cell_data) check_array(array, grid.types.size());
  for (const auto& array : grid.cell_numbers) check_array(array, grid.types.size());
}

void write_grid(hid_t root, const UnstructuredGrid& grid) {
  using Counts = std::vector<std::int64_t>;
  write_attributes(root);
  write_dataset(root, "NumberOfPoints", Counts{static_cast<std::int64_t>(grid.points.size() / 3)});
  write_dataset(root, "NumberOfCells", Counts{static_cast<std::int64_t>(grid.types.size())});
  write_dataset(root, "NumberOfConnectivityIds", Counts{static_cast<std::int64_t>(grid.connectivity.size())});
  write_dataset(root, "Points", grid.points, 3);
  write_dataset(root, "Connectivity", grid.connectivity);
  write_dataset(root, "Offsets", grid.offsets);
  write_dataset(root, "Types", grid.types);
  const Handle points = create_group(root, "PointData");
  for (const auto& array : grid.point_data) write_dataset(points, array.name, array.values, array.num_components);
  const Handle cells = create_group(root, "CellData");
  for (const auto& array : grid.cell_data) write_dataset(cells, array.name, array.values, array.num_components);
  for (const auto& array : grid.cell_numbers) write_dataset(cells, array.name, array.values, array.num_components);
  const Handle field = create_group(root, "FieldData");
  write_dataset(field, "time", std::vector<double>{grid.time});
}

void write_grid_file(const std::filesystem::path& file, const UnstructuredGrid& grid) {
  const Handle creation = untimed(H5P_FILE_CREATE);
  const Handle handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, H5P_DEFAULT), H5Fclose, "create the file");
  const Handle root = create_group(handle, "VTKHDF");
  write_grid(root, grid);
  require(H5Fflush(handle, H5F_SCOPE_LOCAL), "flush the file");
}

}  // namespace

void write_vtkhdf(const OutputFolder& folder, const std::string& name, const UnstructuredGrid& grid) {
  check_grid(grid);
  replace_file(folder, name, [&](const std::filesystem::path& partial) {
    try {
      write_grid_file(partial, grid);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error((folder / name).string() + ": " + error.what());
    }
  });
}

}  // namespace tentpole
