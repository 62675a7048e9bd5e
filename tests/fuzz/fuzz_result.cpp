#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <hdf5.h>

#include "host/case_file/input_error.hpp"
#include "host/command_line/commands.hpp"
#include "host/command_line/prepare_hdf5.hpp"
#include "host/command_line/result_difference.hpp"
#include "tests/temporary_folder.hpp"

// Files of a result as `tentpole info` and `tentpole compare` read them. The first byte says which the other bytes are:
// 0 history.csv, 1 summary.json, 2 the data sets of a snapshot, 3 those of a checkpoint, 4 history.csv of one of two
// results. They are described or refused with a message. Files of HDF5 are made with the library of the data sets that
// the bytes describe, five each: what the library does with a file that is no HDF5 file is its own affair.
namespace tentpole {
namespace {

namespace fs = std::filesystem;

const fs::path& folder() {
  static const TemporaryFolder made;
  static const bool is_filled = [] {
    prepare_hdf5();
    for (const char* part : {"described", "first", "second"}) fs::create_directories(made.path() / part);
    std::ofstream(made.path() / "second" / "history.csv") << "time,kinetic\n0,1\n1,2\n";
    return true;
  }();
  if (!is_filled) std::abort();
  return made.path();
}

const char* const dataset_names[] = {
    "VTKHDF/FieldData/time",     "VTKHDF/NumberOfPoints",   "VTKHDF/NumberOfCells",   "VTKHDF/Points",
    "VTKHDF/PointData/velocity", "VTKHDF/PointData/stress", "VTKHDF/CellData/region", "coefficients"};

/// name, type and layout, two extents, the byte that its values are made of.
void add_dataset(hid_t file, hid_t links, const unsigned char* bytes) {
  const hid_t types[] = {H5T_NATIVE_DOUBLE, H5T_NATIVE_INT64, H5T_NATIVE_FLOAT, H5T_NATIVE_UCHAR, H5T_C_S1};
  const hsize_t extent[] = {bytes[2] % 16u, bytes[3] % 16u, 2};
  const int rank = bytes[1] / 8 % 4;
  const hid_t type = types[bytes[1] % 5], properties = H5Pcreate(H5P_DATASET_CREATE),
              space = rank > 0 ? H5Screate_simple(rank, extent, nullptr) : H5Screate(H5S_SCALAR);
  const hsize_t chunk[] = {1, 1, 1};
  if (bytes[1] >= 128 && rank > 0 && H5Pset_chunk(properties, rank, chunk) >= 0) H5Pset_fletcher32(properties);
  const hid_t dataset =
      H5Dcreate2(file, dataset_names[bytes[0] % std::size(dataset_names)], type, space, links, properties, H5P_DEFAULT);
  const std::vector<unsigned char> values(16 * 16 * 2 * sizeof(double), bytes[4]);
  if (dataset >= 0 && H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0) H5Dclose(dataset);
  H5Sclose(space);
  H5Pclose(properties);
}

void make_hdf5_file(const fs::path& path, const std::string& bytes) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(links, 1);
  for (std::size_t i = 0; i + 5 <= std::min<std::size_t>(bytes.size(), 60); i += 5)
    add_dataset(file, links, reinterpret_cast<const unsigned char*>(bytes.data()) + i);
  H5Pclose(links);
  H5Fclose(file);
}

void describe(int kind, const std::string& bytes) {
  static const char* const names[] = {"history.csv", "summary.json", "snapshot_0000.vtkhdf", "checkpoint.h5"};
  const fs::path file = kind == 4 ? folder() / "first" / "history.csv" : folder() / "described" / names[kind];
  if (kind == 2 || kind == 3)
    make_hdf5_file(file, bytes);
  else
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  if (kind == 4)
    compare_results(folder() / "first", folder() / "second");
  else
    info_command(file);
}

}  // namespace
}  // namespace tentpole

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::ostringstream printed;
  std::streambuf* const terminal = std::cout.rdbuf(printed.rdbuf());
  try {
    tentpole::describe(data[0] % 5, std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  } catch (const std::runtime_error& error) {
    if (error.what()[0] == '\0') std::abort();
  }
  std::cout.rdbuf(terminal);
  return 0;
}
