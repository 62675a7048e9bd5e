#include "host/many_core/read_machine.hpp"

#include "host/case_file/table_reader.hpp"

namespace tentpole {
namespace {

constexpr Presence required = Presence::required;
constexpr double longest_time = 1e3;  // [s]; keeps sums finite

/// One table of the machine file; a faulty key leaves the member as it is; `count` says if it was read.
class ParameterReader {
 public:
  ParameterReader(const Node& root, const std::string& table, const std::string& what, std::vector<Problem>& problems)
      : reader_(TableReader::section(root, table, problems)) {
    if (!reader_.is_given() && !root.find(table)) problems.push_back({{root.location.file, 0, 0, table, ""}, what});
  }

  void allow_only(const std::vector<std::string>& keys) const { reader_.allow_only(keys); }
  bool count(const std::string& key, int low, const std::string& advice, int& value) const {
    const auto read = reader_.integer(key, required, from_to(low, 1 << 20, advice));
    if (read) value = static_cast<int>(*read);
    return read.has_value();
  }
  void seconds(const std::string& key, const std::string& advice, double& value) const {
    if (const auto read = reader_.number(key, required, from_to(0, longest_time, advice))) value = *read;
  }
  void size(const std::string& key, const std::string& advice, double& value) const {
    if (const auto read = reader_.number(key, required, between(0, 1e18, advice))) value = *read;
  }
  const TableReader& table() const { return reader_; }

 private:
  TableReader reader_;
};

void read_cores(const Node& root, std::vector<Problem>& problems, CoreParameters& cores) {
  const ParameterReader reader(root, "cores", "missing. Write [cores] with count, system, threads, ... below.",
                               problems);
  if (!reader.table().is_given()) return;
  reader.allow_only({"count", "system", "threads", "vector_length", "vector_time"});
  const bool is_counted = reader.count("count", 1, "Give the number of cores.", cores.count);
  reader.count("system", 0, "Give the number of cores that the system keeps, often 0.", cores.system);
  reader.count("threads", 1, "Give the hardware threads per core.", cores.threads);
  reader.count("vector_length", 1, "Give the doubles per vector.", cores.vector_length);
  reader.seconds("vector_time", "Give seconds per vector.", cores.vector_time);
  if (is_counted && cores.system >= cores.count)
    reader.table().report("system",
                          "leaves no core to work. Give less than cores.count = " + std::to_string(cores.count) + ".");
  if (cores.vector_time == 0 && reader.table().has("vector_time"))
    reader.table().report("vector_time", "must be positive. Give seconds per vector.");
}

void read_cache(const Node& root, std::vector<Problem>& problems, CacheParameters& cache) {
  const ParameterReader reader(root, "cache", "missing. Write [cache] with private_bytes, ... below.", problems);
  if (!reader.table().is_given()) return;
  reader.allow_only({"private_bytes", "core_bandwidth", "shared_bandwidth"});
  reader.size("private_bytes", "Give L1 and L2 of one core in bytes.", cache.private_bytes);
  reader.size("core_bandwidth", "Give bytes per second of one core.", cache.core_bandwidth);
  reader.size("shared_bandwidth", "Give bytes per second of all cores together.", cache.shared_bandwidth);
}

void read_translation(const Node& root, std::vector<Problem>& problems, TranslationParameters& translation) {
  const ParameterReader reader(root, "translation", "missing. Write [translation] with entries, ... below.", problems);
  if (!reader.table().is_given()) return;
  reader.allow_only({"entries", "page_bytes", "walk_time"});
  reader.count("entries", 0, "Give the translations that a core remembers.", translation.entries);
  reader.count("page_bytes", 1, "Give the size of a page in bytes, mostly 4096.", translation.page_bytes);
  reader.seconds("walk_time", "Give seconds per page, 0 if they are hidden.", translation.walk_time);
}

void read_fork_join(const Node& root, std::vector<Problem>& problems, ForkJoinParameters& fork_join) {
  const ParameterReader reader(root, "fork_join", "missing. Write [fork_join] with fixed, ... below.", problems);
  if (!reader.table().is_given()) return;
  reader.allow_only({"fixed", "per_thread", "arrival", "turn"});
  reader.seconds("fixed", "Give seconds per parallel loop.", fork_join.fixed);
  reader.seconds("per_thread", "Give seconds per thread.", fork_join.per_thread);
  reader.seconds("arrival", "Give seconds per thread at the join.", fork_join.arrival);
  reader.seconds("turn", "Give seconds per thread that has no hardware thread.", fork_join.turn);
}

void read_loop(const Node& root, std::vector<Problem>& problems, LoopParameters& loop) {
  const ParameterReader reader(root, "loop", "missing. Write [loop] with keeps_matrix and added below.", problems);
  if (!reader.table().is_given()) return;
  reader.allow_only({"keeps_matrix", "added"});
  if (const auto keeps = reader.table().boolean("keeps_matrix", required)) loop.keeps_matrix = *keeps;
  const auto added = reader.table().numbers(
      "added", required, 0, from_to(0, 1, "Give sizes of added matrices as shares of the cell matrix."));
  if (!added) return;
  loop.added = *added;
  if (added->empty() || added->size() > 100)
    reader.table().report("added", "must have 1 to 100 entries. Give one per pass; [0.0] adds no matrix.");
}

}  // namespace

Machine read_machine(const std::filesystem::path& path) {
  std::vector<Problem> problems;
  const Node root = read_document(path, {}, problems);
  const TableReader reader(root, problems);
  reader.allow_only({"name", "cores", "cache", "translation", "fork_join", "loop"});
  for (const char* table : {"cores", "cache", "translation", "fork_join", "loop"})
    if (const Node* node = root.find(table); node && node->kind != Node::Kind::table)
      reader.report(*node, std::string("is ") + kind_name(node->kind) + ". Write [" + table + "] with its keys below.");
  Machine machine;
  machine.name = reader.text("name", required).value_or("");
  read_cores(root, problems, machine.cores);
  read_cache(root, problems, machine.cache);
  read_translation(root, problems, machine.translation);
  read_fork_join(root, problems, machine.fork_join);
  read_loop(root, problems, machine.loop);
  if (!problems.empty()) throw InputError(problems);
  return machine;
}

}  // namespace tentpole
