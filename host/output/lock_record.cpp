#include "host/output/lock_record.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <sstream>

#include <unistd.h>

namespace tentpole {
namespace {

std::string first_line(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

std::string host_name() {
  char name[256] = "";
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

/// "pid:[4026531836]".
std::string process_space() {
  char target[64];
  const ssize_t length = readlink("/proc/self/ns/pid", target, sizeof target);
  return length > 0 ? std::string(target, static_cast<std::size_t>(length)) : "";
}

/// Clock ticks from the start of the machine to that of the process; 0 if there is no such process.
std::int64_t start_ticks(std::int64_t process) {
  const std::string status = first_line("/proc/" + std::to_string(process) + "/stat");
  const auto name_end = status.rfind(')');  // the name of the program may hold anything
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(status.substr(name_end + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;  // proc(5): (22) starttime
  std::int64_t ticks = 0;
  fields >> ticks;
  return ticks;
}

std::string time_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[40];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S UTC", &parts)};
}

}  // namespace

LockRecord own_lock_record() {
  return {host_name(),          getpid(), time_text(), first_line("/proc/sys/kernel/random/boot_id"), process_space(),
          start_ticks(getpid())};
}

std::string lock_record_text(const LockRecord& record) {
  std::ostringstream text;
  text << "host " << record.host << "\nprocess " << record.process << "\nstart " << record.start << "\nboot "
       << record.boot << "\nprocess_space " << record.process_space << "\nticks " << record.ticks << "\n";
  return std::move(text).str();
}

std::optional<LockRecord> parse_lock_record(const std::string& text) {
  LockRecord record;
  std::istringstream stream(text);
  const auto value_of = [&](const std::string& name) {
    std::string line;
    if (!std::getline(stream, line) || stream.eof() || !line.starts_with(name + " "))
      stream.setstate(std::ios::failbit);
    return stream ? line.substr(name.size() + 1) : "";
  };
  record.host = value_of("host");
  std::istringstream(value_of("process")) >> record.process;
  record.start = value_of("start");
  record.boot = value_of("boot");
  record.process_space = value_of("process_space");
  std::istringstream(value_of("ticks")) >> record.ticks;
  if (!stream) return std::nullopt;
  return record;
}

Life life_of(const LockRecord& record, const LockRecord& own) {
  if (record.boot != own.boot) return record.host == own.host ? Life::dead : Life::unknown;  // dead: it was restarted
  const bool can_be_told = !record.boot.empty() && record.process_space == own.process_space && record.ticks > 0;
  if (!can_be_told) return Life::unknown;
  const std::int64_t ticks = start_ticks(record.process);
  // A process of another user can be hidden from /proc.
  if (ticks == 0 && kill(static_cast<pid_t>(record.process), 0) != 0 && errno == ESRCH) return Life::dead;
  return ticks == 0 ? Life::unknown : ticks == record.ticks ? Life::alive : Life::dead;
}

std::string owner_text(const LockRecord& record) {
  return "process " + std::to_string(record.process) + " of " + record.host + ", at work since " + record.start;
}

}  // namespace tentpole
