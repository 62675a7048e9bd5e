#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tentpole {

/// The process that owns a result folder, as its lock file tells other processes, also those of other machines.
struct LockRecord {
  std::string host;           ///< name of the machine
  std::int64_t process = 0;   ///< number of the process
  std::string start;          ///< when it took the folder, UTC
  std::string boot;           ///< another one each time a machine starts, the same in all its containers
  std::string process_space;  ///< processes have their numbers within it
  std::int64_t ticks = 0;     ///< start of the process: tells it from a later one with its number

  bool operator==(const LockRecord&) const = default;
};

/// That of this process, now.
LockRecord own_lock_record();

/// A line "name value" per member, and back; none if a line is missing or no such line.
std::string lock_record_text(const LockRecord& record);
std::optional<LockRecord> parse_lock_record(const std::string& text);

/// Whether a process lives, as far as the one of `own` can tell.
enum class Life { dead, alive, unknown };
Life life_of(const LockRecord& record, const LockRecord& own);

/// "process 4711 of node17, at work since 2026-12-01 10:22:33 UTC".
std::string owner_text(const LockRecord& record);

}  // namespace tentpole
