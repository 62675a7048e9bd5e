#pragma once

#include <filesystem>

#include "host/books/run_books.hpp"
#include "host/march/front_march.hpp"
#include "host/output/output_folder.hpp"

namespace tentpole {

/// Writes everything that a run needs to go on bitwise identically: front, the elements below it (renumbered by cell,
/// so the file is as large as the front), the books, and where the output files stood. The state must be settled: every
/// tent pitched is committed. The rows of the output tables reach the disk first, so that even after a power failure
/// the tables are at least as long as the checkpoint says. Throws std::runtime_error if the file cannot be written,
/// FolderLost if the folder is not the one claimed; an older checkpoint is then untouched.
void save_checkpoint(const OutputFolder& folder, RunBooks& books, const FrontMarch& march);

/// Puts a checkpoint into the state of a run that has not begun; its next rows follow those that the checkpoint knows.
/// Batch size, threads and device may differ from those of the run that wrote it. Touches no output file.
/// Throws InputError for a file that is damaged, no checkpoint, or of a run with other settings (naming the first one
/// that differs); also if output that the run had written is missing or too short. A checkpoint of another build
/// (build_identity()) is refused unless `any_build`: the program may round differently, so that the result is not bit
/// for bit that of an uninterrupted run.
void load_checkpoint(const std::filesystem::path& file, RunBooks& books, FrontMarch& march, bool any_build = false);

/// The same with what is in the file, which is named in messages.
void restore_checkpoint(const std::filesystem::path& file, const CheckpointContents& contents, RunBooks& books,
                        FrontMarch& march, bool any_build = false);

}  // namespace tentpole
