#pragma once

namespace tentpole {

/// What this machine reaches, measured once per process at the first question (about 0.3 s): the best of several
/// repetitions, because on a shared machine everything slower is somebody else's.
struct MachinePeaks {
  double dgemm;  ///< matrix product of the system's BLAS, 512 x 512 [flop/s]
  double copy;   ///< bytes read plus bytes written by a copy of 32 MiB [B/s]
};

/// Peaks of `num_threads` threads; more than the machine has cores count as all of them.
MachinePeaks machine_peaks(int num_threads);

/// Hardware threads of this machine.
int num_cores();

}  // namespace tentpole
