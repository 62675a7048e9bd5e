#pragma once

#include <string>
#include <vector>

namespace tentpole {

/// A processor with many equal cores, and the loop over the rows of a cell matrix that runs on it. Machine files
/// (read_machine.hpp) have a table per struct and a key per member.

struct CoreParameters {
  int count = 1;           ///< cores of the processor
  int system = 0;          ///< of them, those that the operating system keeps for itself
  int threads = 1;         ///< hardware threads per core
  int vector_length = 1;   ///< doubles that one instruction works on
  double vector_time = 0;  ///< one vector of a row whose data is in the core's cache [s]
};

struct CacheParameters {
  double private_bytes = 0;     ///< L1 and L2 of one core [B]
  double core_bandwidth = 0;    ///< what one core alone fetches of data that is not there [B/s]
  double shared_bandwidth = 0;  ///< what the ring or the memory delivers to all cores together [B/s]
};

/// The table of address translations of a core (TLB).
struct TranslationParameters {
  int entries = 0;       ///< pages whose translations a core remembers
  int page_bytes = 0;    ///< [B]
  double walk_time = 0;  ///< finding the translation of one page that is not remembered [s]
};

/// Beginning and end of a parallel loop; nothing of it is paid by one thread alone.
struct ForkJoinParameters {
  double fixed = 0;       ///< [s]
  double per_thread = 0;  ///< for each thread of the team [s]
  double arrival = 0;     ///< threads that arrive at the join together are let in one after the other, each in this [s]
  double turn = 0;        ///< for each thread beyond the hardware threads, which must take turns [s]
};

struct LoopParameters {
  bool keeps_matrix = true;   ///< passes over the same matrix; false: every pass finds a new one, not in any cache
  std::vector<double> added;  ///< per pass, in turn: size of the matrix that is added, as a share of the cell matrix
};

struct Machine {
  std::string name;
  CoreParameters cores;
  CacheParameters cache;
  TranslationParameters translation;
  ForkJoinParameters fork_join;
  LoopParameters loop;

  int usable_cores() const { return cores.count - cores.system; }
};

}  // namespace tentpole
