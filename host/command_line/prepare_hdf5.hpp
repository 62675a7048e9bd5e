#pragma once

namespace tentpole {

/// Call before anything else uses HDF5. Its error stacks are not printed, because exceptions say what failed, and its
/// exit handler does not run: after a write to a full disk HDF5 1.10 keeps the file and reads freed memory when it
/// closes it at the end of the program. Every file is closed by then, so the handler has nothing else to do. It locks
/// no files, unless the environment (HDF5_USE_FILE_LOCKING) says so: many file systems of clusters have no locks, and
/// a file of a run is complete when it gets its name (host/output/atomic_file.hpp).
void prepare_hdf5();

}  // namespace tentpole
