#include "host/output/folder_lock.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

#include "host/case_file/input_error.hpp"
#include "host/output/output_folder.hpp"

namespace tentpole {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file) {
  throw fs::filesystem_error("lock file", file, std::error_code(errno, std::generic_category()));
}

enum class Attempt { locked, held, unsupported };

/// A lock of the open file, not of the process: it ends with the last descriptor of the file, and NFS hands it to the
/// server, where it holds for all machines.
Attempt lock_whole_file(int descriptor, const fs::path& file) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  while (fcntl(descriptor, F_OFD_SETLK, &whole) != 0) switch (errno) {
      case EINTR:
        break;
      case EAGAIN:
      case EACCES:
        return Attempt::held;
      case ENOLCK:
      case EOPNOTSUPP:
      case ENOSYS:
      case EINVAL:
        return Attempt::unsupported;
      default:
        fail(file);
    }
  return Attempt::locked;
}

std::optional<LockRecord> read_record(int descriptor) {
  char text[1024];
  const ssize_t length = pread(descriptor, text, sizeof text, 0);
  return length > 0 ? parse_lock_record(std::string(text, static_cast<std::size_t>(length))) : std::nullopt;
}

[[noreturn]] void refuse_held(const fs::path& folder, const std::optional<LockRecord>& owner) {
  throw InputError(folder.string() + ": another run works in this folder" +
                   (owner ? " (" + owner_text(*owner) + ")" : "") +
                   ". Wait for its end, stop it, or give another folder with --out.");
}

[[noreturn]] void refuse_doubtful(const fs::path& folder, const std::optional<LockRecord>& owner) {
  throw InputError(folder.string() + ": another run may work in this folder" +
                   (owner ? " (" + owner_text(*owner) + ")" : "") +
                   ". Its file system has no locks, and from here nobody can tell whether that process still lives. If "
                   "it does not, delete " +
                   (folder / FolderLock::file_name).string() + " and try again; or give another folder with --out.");
}

}  // namespace

FolderLock::FolderLock(fs::path folder) : folder_(std::move(folder)) {
  // A run that has just ended takes its lock file with it, and one that begins moves an older result aside.
  constexpr int most_attempts = 100;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    directory_ = Descriptor(open(folder_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    if (directory_ < 0) fail(folder_);
    if (!take()) continue;
    if (identity_of(folder_) == identity_of(directory_)) return;
    give_up();
  }
  refuse_held(folder_, std::nullopt);
}

FolderLock::~FolderLock() {
  give_up();
}

void FolderLock::give_up() {
  if (file_ >= 0 && is_own_file()) unlinkat(directory_, file_name, 0);
  file_ = Descriptor();
}

/// False if the lock file vanished meanwhile.
bool FolderLock::take() {
  const int flags = O_RDWR | O_CLOEXEC;
  file_ = Descriptor(openat(directory_, file_name, flags | O_CREAT | O_EXCL, 0666));
  if (file_ >= 0) {
    if (lock_whole_file(file_, file()) == Attempt::held) return take_existing();
    write_record();
    return is_own_file();
  }
  if (errno != EEXIST) fail(file());
  file_ = Descriptor(openat(directory_, file_name, flags));
  if (file_ < 0 && errno == ENOENT) return false;
  if (file_ < 0) fail(file());
  return take_existing();
}

bool FolderLock::take_existing() {
  switch (lock_whole_file(file_, file())) {
    case Attempt::held:
      refuse_held(folder_, read_record(file_));
    case Attempt::unsupported:
      return take_unlocked();
    case Attempt::locked:
      break;
  }
  if (!is_own_file()) return false;
  write_record();
  return true;
}

/// Removes the file of a dead process, so that the next attempt can make a new one.
bool FolderLock::take_unlocked() {
  const std::optional<LockRecord> owner = read_record(file_);
  const Life life = owner ? life_of(*owner, own_lock_record()) : Life::unknown;
  if (life == Life::unknown) refuse_doubtful(folder_, owner);
  if (life == Life::alive) refuse_held(folder_, owner);
  if (is_own_file()) unlinkat(directory_, file_name, 0);
  return false;
}

void FolderLock::write_record() {
  const std::string text = lock_record_text(own_lock_record());
  if (ftruncate(file_, 0) == 0 && pwrite(file_, text.data(), text.size(), 0) == std::ssize(text)) return;
  const int error = std::exchange(errno, 0);
  unlinkat(directory_, file_name, 0);  // without its record nobody could tell whose it is
  errno = error != 0 ? error : ENOSPC;
  fail(file());
}

bool FolderLock::is_own_file() const {
  struct stat status {};
  return fstatat(directory_, file_name, &status, 0) == 0 &&
         identity_of(file_) == FileIdentity{status.st_dev, status.st_ino};
}

void FolderLock::require() const {
  require_same_folder(folder_, identity_of(folder_), identity_of(directory_));
  if (is_own_file()) return;
  const Descriptor other(openat(directory_, file_name, O_RDONLY | O_CLOEXEC));
  const std::optional<LockRecord> owner = other >= 0 ? read_record(other) : std::nullopt;
  throw FolderLost(
      folder_.string() + ": " +
      (owner ? "another run has taken over the result folder (" + owner_text(*owner) + ")"
             : "the lock file " + file().string() + " was deleted, so another run may work in the result folder") +
      ". Nothing was written there since. Start one of them anew with another --out.");
}

}  // namespace tentpole
