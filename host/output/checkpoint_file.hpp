#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host/output/output_folder.hpp"

namespace tentpole {

/// Key and value of one setting, e.g. ("material.all.density", "3690").
using Setting = std::pair<std::string, std::string>;

/// What checkpoint.h5 holds: one data set per member, of the same name. Solver arrays in scaled units.
struct CheckpointContents {
  std::vector<std::string> builds;         ///< build_identity() of each program that has worked on the run, last last
  std::vector<Setting> settings;           ///< all that decides the result (result_settings.hpp)
  std::vector<double> front_times;         ///< [vertex]
  std::vector<std::int32_t> cell_element;  ///< [cell]: row of the element below it, or none: the initial data
  std::vector<std::int32_t> cell_facet;    ///< [cell]: facet_table() of that element's facet which is the cell
  std::string march;                       ///< what else an adaptive march keeps
  std::vector<double> coefficients;        ///< [element][num_unknowns]
  std::vector<double> inverse_jacobians;   ///< [element][(D + 1)^2]
  std::string ledger, recorder, history;   ///< what their save() wrote
  std::vector<double> stage_seconds;       ///< [Stage]: wall time so far [s]
  std::vector<std::int64_t> run_counts;    ///< bytes to the device, bytes from it, launches, dense fallbacks
};

/// Name of the checkpoint in a result folder.
inline constexpr const char* checkpoint_name = "checkpoint.h5";

/// Writes the file atomically: under its name there is always a complete checkpoint. Data and metadata carry checksums.
/// Throws std::runtime_error with the path if it cannot be written, FolderLost if the folder is not the one claimed.
void write_checkpoint_file(const OutputFolder& folder, const CheckpointContents& contents);

/// Removes it, and what a killed program left of writing it. A file that does not exist is no error.
void remove_checkpoint_file(const OutputFolder& folder);

/// Reads it back bit by bit. Throws InputError for a file that is no checkpoint, of another format version, or damaged;
/// whatever its bytes are, no more memory is asked for than the file is long.
CheckpointContents read_checkpoint_file(const std::filesystem::path& file);

}  // namespace tentpole
