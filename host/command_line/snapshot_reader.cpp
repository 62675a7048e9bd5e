#include "host/command_line/snapshot_reader.hpp"

#include <optional>
#include <utility>

#include <hdf5.h>

#include "host/case_file/input_error.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

/// An HDF5 identifier that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }
  bool is_valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

[[noreturn]] void refuse(const fs::path& file, const std::string& problem) {
  throw InputError(file.string() + ": " + problem);
}

/// Nothing where the file does not say.
std::optional<std::vector<hsize_t>> extent_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int num_dimensions = space.is_valid() ? H5Sget_simple_extent_ndims(space) : -1;
  if (num_dimensions < 0) return std::nullopt;
  std::vector<hsize_t> extent(num_dimensions);
  if (H5Sget_simple_extent_dims(space, extent.data(), nullptr) < 0) return std::nullopt;
  return extent;
}

/// Whether the data set is as the program writes them: numbers, not compressed, so that they cannot take more memory
/// than `largest_size` bytes of file.
bool is_plain(hid_t dataset, const std::vector<hsize_t>& extent, std::uintmax_t largest_size) {
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const Handle properties(H5Dget_create_plist(dataset), H5Pclose);
  if (!type.is_valid() || !properties.is_valid()) return false;
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_INTEGER && kind != H5T_FLOAT) return false;
  const H5D_layout_t layout = H5Pget_layout(properties);
  if (H5Pget_nfilters(properties) != 0 || (layout != H5D_CONTIGUOUS && layout != H5D_COMPACT)) return false;
  std::uintmax_t left = largest_size / H5Tget_size(type);
  for (const hsize_t count : extent) {
    if (count == 0) return true;
    left /= count;
  }
  return left > 0;
}

SnapshotField read_field(const fs::path& file, hid_t parent, const std::string& path) {
  const Handle dataset(H5Dopen2(parent, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.is_valid()) refuse(file, "has no data set " + path + ", so it is no snapshot of tentpole.");
  const std::vector<hsize_t> extent = extent_of(dataset).value_or(std::vector<hsize_t>{0, 0, 0});
  if (extent.size() > 2 || !is_plain(dataset, extent, fs::file_size(file)))
    refuse(file, "the data set " + path + " is none that tentpole writes; the file is damaged or of another program.");
  SnapshotField field;
  field.name = path.substr(path.rfind('/') + 1);
  field.num_components = extent.size() > 1 ? static_cast<int>(extent[1]) : 1;
  std::size_t num_values = 1;
  for (const hsize_t count : extent) num_values *= count;
  field.values.resize(num_values);
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, field.values.data()) < 0)
    refuse(file, "the data set " + path + " cannot be read; the file is damaged.");
  return field;
}

/// The number in a data set of one.
double read_number(const fs::path& file, hid_t parent, const std::string& path) {
  const SnapshotField field = read_field(file, parent, path);
  if (field.values.size() != 1) refuse(file, "the data set " + path + " must hold one number; the file is damaged.");
  return field.values[0];
}

/// A number of points or cells.
std::int64_t read_count(const fs::path& file, hid_t parent, const std::string& path) {
  const double count = read_number(file, parent, path);
  if (!(count >= 0 && count <= static_cast<double>(fs::file_size(file))))
    refuse(file, "the data set " + path + " holds no number that the file has room for; it is damaged.");
  return static_cast<std::int64_t>(count);
}

extern "C" herr_t append_name(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->push_back(name);
  return 0;
}

extern "C" herr_t append_dataset(hid_t object, const char* name, const H5O_info_t* info, void* rows) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  const Handle dataset(H5Dopen2(object, name, H5P_DEFAULT), H5Dclose);
  std::string extent;
  for (const hsize_t count : extent_of(dataset).value_or(std::vector<hsize_t>{}))
    extent += (extent.empty() ? "" : " x ") + std::to_string(count);
  static_cast<std::vector<std::vector<std::string>>*>(rows)->push_back({name, extent.empty() ? "1" : extent});
  return 0;
}

}  // namespace

SnapshotFile read_snapshot(const fs::path& path) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.is_valid()) refuse(path, "cannot be read as HDF5.");
  SnapshotFile snapshot;
  snapshot.time = read_number(path, file, "VTKHDF/FieldData/time");
  snapshot.num_points = read_count(path, file, "VTKHDF/NumberOfPoints");
  snapshot.num_cells = read_count(path, file, "VTKHDF/NumberOfCells");
  const Handle group(H5Gopen2(file, "VTKHDF/PointData", H5P_DEFAULT), H5Gclose);
  if (!group.is_valid()) refuse(path, "has no group VTKHDF/PointData, so it is no snapshot of tentpole.");
  std::vector<std::string> names;
  hsize_t position = 0;
  H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &position, append_name, &names);
  for (const std::string& name : names) snapshot.fields.push_back(read_field(path, file, "VTKHDF/PointData/" + name));
  return snapshot;
}

std::vector<std::vector<std::string>> list_hdf5_contents(const fs::path& path) {
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.is_valid()) refuse(path, "cannot be read as HDF5.");
  std::vector<std::vector<std::string>> rows;
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, append_dataset, &rows, H5O_INFO_BASIC);
  return rows;
}

}  // namespace tentpole
