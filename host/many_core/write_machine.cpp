#include "host/many_core/write_machine.hpp"

#include <algorithm>

#include "host/case_file/number_text.hpp"

namespace tentpole {
namespace {

std::string line(const std::string& key, const std::string& value, const std::string& comment) {
  std::string text = key + " = " + value;
  text.resize(std::max<std::size_t>(text.size() + 1, 36), ' ');
  return text + "# " + comment + "\n";
}

std::string line(const std::string& key, int value, const std::string& comment) {
  return line(key, std::to_string(value), comment);
}

std::string line(const std::string& key, double value, const std::string& comment) {
  return line(key, number_text(value), comment);
}

/// A TOML string; processors have plain names, but nothing is taken for granted.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    result += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return result + "\"";
}

std::string shares(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_text(value);
  return "[" + text + "]";
}

}  // namespace

std::string machine_text(const Machine& machine, const std::string& origin) {
  const auto& [name, cores, cache, translation, fork_join, loop] = machine;
  return "# " + origin + "\n# `tentpole model` reads this file. Seconds and bytes.\nname = " + quoted(name) +
         "\n\n[cores]\n" + line("count", cores.count, "cores that a process may use") +
         line("system", cores.system, "of them, those that the system keeps") +
         line("threads", cores.threads, "hardware threads per core") +
         line("vector_length", cores.vector_length, "doubles per instruction of this build") +
         line("vector_time", cores.vector_time, "[s] one vector of a row that is in the core's cache") + "\n[cache]\n" +
         line("private_bytes", cache.private_bytes, "[B] L1 and L2 of one core, as the system reports") +
         line("core_bandwidth", cache.core_bandwidth, "[B/s] beyond them, one core alone") +
         line("shared_bandwidth", cache.shared_bandwidth, "[B/s] all cores together; 1e15: no limit seen") +
         "\n[translation]\n" + line("entries", translation.entries, "walks are part of core_bandwidth") +
         line("page_bytes", translation.page_bytes, "[B]") + line("walk_time", translation.walk_time, "[s] as above") +
         "\n[fork_join]\n" + line("fixed", fork_join.fixed, "[s] a parallel loop; what it takes beyond its work") +
         line("per_thread", fork_join.per_thread, "[s] for each of its threads") +
         line("arrival", fork_join.arrival, "[s] part of the above") +
         line("turn", fork_join.turn, "[s] for each thread beyond the hardware threads") + "\n[loop]\n" +
         line("keeps_matrix", loop.keeps_matrix ? "true" : "false", "passes over one matrix") +
         line("added", shares(loop.added), "no matrices are added, products of vectors only");
}

}  // namespace tentpole
