#include "host/command_line/quiet_hdf5.hpp"

#include <hdf5.h>

namespace tentpole {

void keep_hdf5_quiet() {
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace tentpole
