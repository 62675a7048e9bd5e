#pragma once

namespace tentpole {

/// L1 data cache and L2 cache of one core [B], as the system reports them; 288 KiB if it does not.
double private_cache_bytes();

/// Hardware threads of a core; 1 if the system does not tell.
int threads_per_core();

/// Size of a page of memory [B].
int page_bytes();

}  // namespace tentpole
