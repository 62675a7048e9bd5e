#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "host/books/run_books.hpp"
#include "host/case_file/case.hpp"
#include "host/case_file/input_error.hpp"
#include "host/march/adaptive_march.hpp"
#include "host/march/fixed_march.hpp"
#include "host/run/checkpoint.hpp"
#include "host/run/make_simulation.hpp"
#include "tests/temporary_folder.hpp"

// The way of a checkpoint into a run that has not begun. The first byte says which section the other bytes stand for;
// the others are those of a run of the same case: 0 an adaptive march, 1 ledger, 2 recorder, 3 history, 4 the cells of
// a fixed march. With 6 more, the other bytes change the sound section: four each, a place (24 bits) and the byte to
// put there. 5 or 11: they change the data sets of a whole checkpoint. Whatever the bytes are, they are restored or
// refused with a message; what is restored can be saved again. (What HDF5 does with a file that is none of its own is
// the library's affair.)
namespace tentpole {
namespace {

namespace fs = std::filesystem;

void require(bool holds, const char* invariant) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", invariant);
  std::abort();
}

/// A bar of 24 cells with a crack, whose defects give way at once.
const char* const adaptive_case = R"toml(
[domain]
dimension = 2
min = [0.0, 0.0]
max = [1.2e-4, 3e-5]
cells = [6, 2]
pattern = "unstructured"
[material.all]
density = 3690.0
youngs_modulus = 260e9
poisson_ratio = 0.21
[boundary.left]
normal_velocity = "60"
tangential_velocity = "0"
[boundary.right]
normal_velocity = "60"
tangential_velocity = "0"
[boundary.bottom]
normal_velocity = "0"
tangential_traction = "0"
[boundary.top]
normal_velocity = "0"
tangential_traction = "0"
[time]
end = 2.4e-8
[discretization]
degree = 1
[adaptivity]
enabled = true
error_tolerance = 1e-4
min_size = 2e-6
max_size = 5e-5
[fracture]
enabled = true
threshold = 300e6
strength = 400e6
relaxation_time = 1e-9
[[fracture.crack]]
points = [[4e-5, 1.5e-5], [8e-5, 1.5e-5]]
damage = 0.3
[fracture.nucleation]
model = "field"
mean = 2.0e9
minimum = 220e6
maximum = 4.0e9
tail_strength = 400e6
tail_probability = 2e-4
density = 5e13
[output]
times = [6e-10, 2.4e-8]
fields = ["displacement", "stress", "damage"]
history_interval = 2.4e-8
[[output.probe]]
name = "inside"
point = [6e-5, 1e-5]
interval = 1e-8
)toml";

const char* const fixed_case = R"toml(
[domain]
dimension = 1
min = [0.0]
max = [1.0]
cells = [6]
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.0
[boundary.left]
normal_velocity = "1"
[boundary.right]
absorbing = true
[time]
end = 0.5
[discretization]
degree = 1
[output]
history_interval = 0.1
)toml";

Simulation simulation_of(const fs::path& folder, const char* text) {
  std::ofstream(folder / "case.toml") << text;
  return make_simulation(read_case(folder / "case.toml"));
}

/// What a run owns, before its first patch.
struct Run {
  Run(const Simulation& simulation, const fs::path& folder)
      : runner(simulation, host_device(), 1, timer, traffic),
        recorder(options(simulation, folder)),
        history(folder, simulation.settings.output.history_interval, simulation.settings.end_time),
        ledger(simulation, recorder, history),
        books{simulation, store, runner, ledger, recorder, history, timer, traffic} {}

  static RecorderOptions options(const Simulation& simulation, const fs::path& folder) {
    RecorderOptions options;
    options.dimension = simulation.dimension();
    options.degree = simulation.degree();
    options.folder = folder;
    options.snapshot_times = simulation.settings.output.snapshot_times;
    options.fields = {"displacement", "stress", "damage"};
    for (const ProbeSettings& probe : simulation.settings.output.probes)
      options.probes.push_back({probe.name, probe.point, {0, simulation.settings.end_time}});
    return options;
  }

  StageTimer timer;
  TrafficCounters traffic;
  ElementStore store;
  BatchRunner runner;
  Recorder recorder;
  History history;
  Ledger ledger;
  RunBooks books;
};

/// The same case again and again, and a sound checkpoint of it.
class Subject {
 public:
  Subject(const fs::path& folder, const char* text)
      : folder_(folder), simulation_(simulation_of(folder, text)), run_(simulation_, folder) {
    const auto march = make_march();
    AdvanceOptions options{.max_patches = 16};
    options.after_batch = [left = 8](double) mutable { return --left > 0; };
    march->advance(options);
    save_checkpoint(folder_, run_.books, *march);
    good_ = read_checkpoint_file(file());
  }

  std::unique_ptr<FrontMarch> make_march() {
    run_.store = ElementStore{};
    if (simulation_.settings.adaptivity.enabled) return std::make_unique<AdaptiveMarch>(run_.books, folder_);
    return std::make_unique<FixedMarch>(run_.books);
  }
  fs::path file() const { return folder_ / "checkpoint.h5"; }
  const CheckpointContents& good() const { return good_; }
  Run& run() { return run_; }

 private:
  fs::path folder_;
  Simulation simulation_;
  Run run_;
  CheckpointContents good_;
};

void restore_march(Subject& subject, const CheckpointContents& contents) {
  const auto march = subject.make_march();
  const std::vector<std::int32_t> slots = march->load(contents);
  for (const std::int32_t slot : slots)
    require(slot >= 0 && slot < subject.run().store.num_slots(), "every row has a slot");
  CheckpointContents again;
  require(march->save(again).size() == slots.size(), "what is restored can be saved");
  RunSummary summary;
  march->fill(summary);
}

template <class Book>
void restore_book(Book& book, const std::string& bytes) {
  std::istringstream stream(bytes, std::ios::binary);
  book.load(stream);
  std::ostringstream again(std::ios::binary);
  book.save(again);
  require(!again.str().empty(), "what is restored can be saved");
}

/// Half of the bytes are the elements below the cells, half the facets, 32 bits each.
CheckpointContents with_cells(CheckpointContents contents, const std::string& bytes) {
  const std::size_t num_cells = bytes.size() / 8;
  contents.cell_element.assign(num_cells, 0);
  contents.cell_facet.assign(num_cells, 0);
  std::copy_n(bytes.data(), 4 * num_cells, reinterpret_cast<char*>(contents.cell_element.data()));
  std::copy_n(bytes.data() + 4 * num_cells, 4 * num_cells, reinterpret_cast<char*>(contents.cell_facet.data()));
  return contents;
}

std::string bytes_of(const std::vector<std::int32_t>& values) {
  return {reinterpret_cast<const char*>(values.data()), 4 * values.size()};
}

std::string changed(std::string sound, const std::string& edits) {
  for (std::size_t i = 0; i + 4 <= edits.size() && !sound.empty(); i += 4) {
    const auto part = [&](int j) { return static_cast<std::size_t>(static_cast<unsigned char>(edits[i + j])); };
    sound[(part(0) + 256 * part(1) + 65536 * part(2)) % sound.size()] = edits[i + 3];
  }
  return sound;
}

/// The sound bytes of each section.
std::array<std::string, 5> sound_sections(const Subject& adaptive, const Subject& fixed) {
  const CheckpointContents &contents = adaptive.good(), &other = fixed.good();
  return {contents.march, contents.ledger, contents.recorder, contents.history,
          bytes_of(other.cell_element) + bytes_of(other.cell_facet)};
}

template <class Value>
void change(std::vector<Value>& values, std::size_t place, unsigned char byte, bool cuts) {
  if (cuts) values.resize(place % (2 * values.size() + 2));
  if (!values.empty()) std::memset(&values[place % values.size()], byte, sizeof(Value));
}

/// Four bytes each: which data set, a place (16 bits), and of what byte the value there is made.
CheckpointContents with_changes(CheckpointContents contents, const std::string& bytes) {
  for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
    const auto part = [&](int j) { return static_cast<unsigned char>(bytes[i + j]); };
    const std::size_t place = part(1) + 256u * part(2);
    const bool cuts = part(0) >= 128;
    switch (part(0) % 8) {
      case 0:
        change(contents.front_times, place, part(3), cuts);
        break;
      case 1:
        change(contents.cell_element, place, part(3), cuts);
        break;
      case 2:
        change(contents.cell_facet, place, part(3), cuts);
        break;
      case 3:
        change(contents.coefficients, place, part(3), cuts);
        break;
      case 4:
        change(contents.inverse_jacobians, place, part(3), cuts);
        break;
      case 5:
        change(contents.stage_seconds, place, part(3), cuts);
        break;
      case 6:
        change(contents.run_counts, place, part(3), cuts);
        break;
      default:
        contents.settings[place % contents.settings.size()].second += static_cast<char>(part(3));
    }
  }
  return contents;
}

void restore_whole(Subject& subject, const std::string& bytes) {
  const auto march = subject.make_march();
  restore_checkpoint(subject.file(), with_changes(subject.good(), bytes), subject.run().books, *march, true);
}

void restore(int choice, std::string bytes) {
  static const TemporaryFolder adaptive_folder, fixed_folder;
  static Subject adaptive(adaptive_folder.path(), adaptive_case), fixed(fixed_folder.path(), fixed_case);
  static const std::array<std::string, 5> sound = sound_sections(adaptive, fixed);
  const int section = choice % 6;
  if (section == 5) return restore_whole(choice == 5 ? adaptive : fixed, bytes);
  if (choice >= 6) bytes = changed(sound[section], bytes);
  CheckpointContents contents = adaptive.good();
  switch (section) {
    case 0:
      contents.march = bytes;
      return restore_march(adaptive, contents);
    case 1:
      return restore_book(adaptive.run().ledger, bytes);
    case 2:
      return restore_book(adaptive.run().recorder, bytes);
    case 3:
      return restore_book(adaptive.run().history, bytes);
    default:
      return restore_march(fixed, with_cells(fixed.good(), bytes));
  }
}

}  // namespace
}  // namespace tentpole

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    tentpole::restore(data[0] % 12, std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  } catch (const std::runtime_error& error) {
    tentpole::require(error.what()[0] != '\0', "a refusal has a message");
  } catch (const std::invalid_argument& error) {
    tentpole::require(error.what()[0] != '\0', "a refusal has a message");
  }
  return 0;
}
