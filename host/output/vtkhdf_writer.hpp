#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/output/output_folder.hpp"

namespace tentpole {

/// A named array over points or cells, component fastest. Six components are a symmetric tensor: xx, yy, zz, xy, yz,
/// xz.
template <class Value>
struct GridArray {
  std::string name;
  int num_components = 1;
  std::vector<Value> values;  ///< [num_points or num_cells][num_components]
};

/// An unstructured grid as VTK stores it.
struct UnstructuredGrid {
  double time = 0;                         ///< [s], written as field data "time"
  std::vector<double> points;              ///< [num_points][3] [m]
  std::vector<std::int64_t> connectivity;  ///< corners of each cell, one cell after the other
  std::vector<std::int64_t> offsets{0};    ///< [num_cells + 1]: where each cell starts in `connectivity`
  std::vector<std::uint8_t> types;         ///< [num_cells]: VTK cell types
  std::vector<GridArray<double>> point_data;
  std::vector<GridArray<double>> cell_data;
  std::vector<GridArray<std::int64_t>> cell_numbers;  ///< also cell data: integers (element, region)
};

/// Writes a VTKHDF 1.0 file of type UnstructuredGrid with one piece, atomically. Equal grids give bitwise equal files.
/// Throws std::invalid_argument where an array does not fit the grid, std::runtime_error where the file cannot be
/// written. Source: VTK file formats, "VTKHDF".
void write_vtkhdf(const OutputFolder& folder, const std::string& name, const UnstructuredGrid& grid);

}  // namespace tentpole
