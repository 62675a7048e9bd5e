#pragma once

namespace tentpole {

/// Number of threads that the system's BLAS and LAPACK use from now on, where the library lets a program choose
/// (OpenBLAS: openblas_set_num_threads). Returns false where it does not.
bool set_blas_threads(int num_threads);

}  // namespace tentpole
