#include "host/command_line/prepare_hdf5.hpp"

#include <cstdlib>

#include <hdf5.h>

namespace tentpole {

void prepare_hdf5() {
  setenv("HDF5_USE_FILE_LOCKING", "FALSE", 0);  // read once, when the library starts; plots inherit it
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace tentpole
