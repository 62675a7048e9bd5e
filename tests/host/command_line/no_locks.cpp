// Preloaded (LD_PRELOAD), it makes every file system one without locks.
#include <cerrno>
#include <cstdarg>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

int call(int descriptor, int command, void* argument) {
  switch (command) {
    case F_SETLK:
    case F_SETLKW:
    case F_OFD_SETLK:
    case F_OFD_SETLKW:
      errno = ENOLCK;
      return -1;
    default:
      return static_cast<int>(syscall(SYS_fcntl, descriptor, command, argument));
  }
}

}  // namespace

extern "C" int flock(int, int) {
  errno = ENOLCK;
  return -1;
}

extern "C" int fcntl(int descriptor, int command, ...) {
  va_list list;
  va_start(list, command);
  void* const argument = va_arg(list, void*);
  va_end(list);
  return call(descriptor, command, argument);
}

extern "C" int fcntl64(int descriptor, int command, ...) {
  va_list list;
  va_start(list, command);
  void* const argument = va_arg(list, void*);
  va_end(list);
  return call(descriptor, command, argument);
}
