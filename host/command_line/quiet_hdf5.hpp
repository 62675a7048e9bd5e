#pragma once

namespace tentpole {

/// Call before anything else uses HDF5. Its error stacks are not printed, because exceptions say what failed, and its
/// exit handler does not run: after a write to a full disk HDF5 1.10 keeps the file and reads freed memory when it
/// closes it at the end of the program. Every file is closed by then, so the handler has nothing else to do.
void keep_hdf5_quiet();

}  // namespace tentpole
