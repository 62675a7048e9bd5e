#include "host/output/checkpoint_file.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include <hdf5.h>
#include <unistd.h>

#include "host/case_file/input_error.hpp"
#include "host/output/atomic_file.hpp"
#include "host/output/file_identity.hpp"

namespace tentpole {
namespace {

constexpr std::string_view format_name = "tentpole checkpoint";
/// Raise it whenever the data sets, or what ledger, recorder and history write into theirs, change.
constexpr std::int64_t format_version = 7;

/// An HDF5 identifier that closes itself; throws where HDF5 reports an error.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& action) : id_(id), close_(close) {
    if (id < 0) throw std::runtime_error("HDF5 cannot " + action);
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t result, const std::string& action) {
  if (result < 0) throw std::runtime_error("HDF5 cannot " + action);
}

/// Keeps HDF5 from printing its own error stack; ours says the same in one line.
class QuietErrors {
 public:
  QuietErrors() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

hid_t memory_type(double) {
  return H5T_NATIVE_DOUBLE;
}
hid_t memory_type(std::int64_t) {
  return H5T_NATIVE_INT64;
}
hid_t memory_type(std::int32_t) {
  return H5T_NATIVE_INT32;
}
hid_t memory_type(char) {
  return H5T_NATIVE_CHAR;
}

/// Texts in one: each ends with a zero byte, because expressions may have several lines.
std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text + '\0';
  return all;
}

std::vector<std::string> split(const std::string& all) {
  std::vector<std::string> texts;
  std::istringstream stream(all);
  for (std::string text; std::getline(stream, text, '\0');) texts.push_back(text);
  return texts;
}

/// Key, value, key, value, ...
std::vector<std::string> texts_of(const std::vector<Setting>& settings) {
  std::vector<std::string> texts;
  for (const auto& [key, value] : settings) texts.insert(texts.end(), {key, value});
  return texts;
}

std::vector<Setting> settings_of(const std::vector<std::string>& texts) {
  if (texts.size() % 2 != 0) throw std::runtime_error("data set settings: a key has no value");
  std::vector<Setting> settings;
  for (std::size_t i = 0; i < texts.size(); i += 2) settings.emplace_back(texts[i], texts[i + 1]);
  return settings;
}

constexpr hsize_t largest_chunk = 1 << 20;  ///< bytes

/// Creates the data sets of a file. Chunks carry Fletcher's checksum, so a flipped bit is an error when they are read.
class Writer {
 public:
  explicit Writer(hid_t file) : file_(file) {}

  template <class Values>
  void operator()(const char* name, const Values& values) const {
    const auto type = memory_type(typename Values::value_type{});
    const hsize_t extent = values.size();
    const hsize_t chunk = std::clamp<hsize_t>(extent, 1, largest_chunk / sizeof(values[0]));
    const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose, "create a data space");
    const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "create a property list");
    require(H5Pset_chunk(properties, 1, &chunk), "choose the chunk size");
    require(H5Pset_fletcher32(properties), "choose checksums");
    const Handle dataset(H5Dcreate2(file_, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
                         std::string("create the data set ") + name);
    if (extent > 0)
      require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), std::string("write ") + name);
  }

 private:
  hid_t file_;
};

class Reader {
 public:
  Reader(hid_t file, std::uintmax_t file_size) : file_(file), file_size_(file_size) {}

  template <class Values>
  void operator()(const char* name, Values& values) const {
    const Handle dataset(H5Dopen2(file_, name, H5P_DEFAULT), H5Dclose, std::string("open the data set ") + name);
    const Handle space(H5Dget_space(dataset), H5Sclose, std::string("read the extent of ") + name);
    const hssize_t extent = H5Sget_simple_extent_npoints(space);
    require(extent < 0 ? -1 : 0, std::string("read the extent of ") + name);
    const auto type = memory_type(typename Values::value_type{});
    require_plain(dataset, type, name);
    if (static_cast<std::uintmax_t>(extent) > file_size_ / sizeof(typename Values::value_type))
      throw std::runtime_error(std::string("data set ") + name + " has " + std::to_string(extent) +
                               " entries, more than its " + std::to_string(file_size_) + " bytes can hold");
    values.resize(static_cast<std::size_t>(extent));
    if (extent > 0)
      require(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), std::string("read ") + name);
  }

 private:
  /// Only what Writer makes: other types, filters and chunks would have HDF5 convert, expand and allocate.
  static void require_plain(hid_t dataset, hid_t type, const char* name) {
    const std::string action = std::string("read the properties of ") + name;
    const Handle stored(H5Dget_type(dataset), H5Tclose, action);
    const Handle properties(H5Dget_create_plist(dataset), H5Pclose, action);
    hsize_t chunk = 0;
    const bool is_plain =
        H5Tequal(stored, type) > 0 && H5Pget_layout(properties) == H5D_CHUNKED &&
        H5Pget_chunk(properties, 1, &chunk) == 1 && chunk * H5Tget_size(type) <= largest_chunk &&
        H5Pget_nfilters(properties) == 1 &&
        H5Pget_filter_by_id2(properties, H5Z_FILTER_FLETCHER32, nullptr, nullptr, nullptr, 0, nullptr, nullptr) >= 0;
    if (!is_plain)
      throw std::runtime_error(std::string("data set ") + name +
                               " has another type, layout or filter than checkpoints");
  }

  hid_t file_;
  std::uintmax_t file_size_;
};

/// Hands every array to the writer or the reader under its name.
template <class Contents, class Visitor>
void visit_arrays(Contents& contents, const Visitor& visit) {
  visit("front_times", contents.front_times);
  visit("cell_element", contents.cell_element);
  visit("cell_facet", contents.cell_facet);
  visit("march", contents.march);
  visit("coefficients", contents.coefficients);
  visit("inverse_jacobians", contents.inverse_jacobians);
  visit("ledger", contents.ledger);
  visit("recorder", contents.recorder);
  visit("history", contents.history);
  visit("stage_seconds", contents.stage_seconds);
  visit("run_counts", contents.run_counts);
}

void write_to(const std::filesystem::path& file, const CheckpointContents& contents) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "create a property list");
  // From version 1.10 on the file format has checksums of the metadata too.
  require(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), "choose the file format");
  const Handle handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "create the file");
  const Writer write(handle);
  write("format", std::string(format_name));
  write("version", std::vector<std::int64_t>{format_version});
  write("builds", joined(contents.builds));
  write("settings", joined(texts_of(contents.settings)));
  visit_arrays(contents, write);
  require(H5Fflush(handle, H5F_SCOPE_LOCAL), "flush the file");
}

/// The file as a checkpoint of this version, its arrays not read yet.
void check_format(const Reader& read) {
  std::string format;
  read("format", format);
  if (format != format_name) throw std::runtime_error("its format is \"" + format + "\"");
  std::vector<std::int64_t> version;
  read("version", version);
  if (version != std::vector<std::int64_t>{format_version})
    throw std::runtime_error("its format version is " + (version.empty() ? "absent" : std::to_string(version[0])) +
                             " and this program reads version " + std::to_string(format_version) +
                             "; only the program that wrote it can go on");
}

}  // namespace

void write_checkpoint_file(const OutputFolder& folder, const CheckpointContents& contents) {
  const QuietErrors quiet;
  try {
    replace_file(folder, checkpoint_name, [&](const std::filesystem::path& partial) { write_to(partial, contents); });
  } catch (const FolderLost&) {
    throw;  // nothing is removed in a folder that may be another run's
  } catch (const std::runtime_error& error) {
    unlinkat(folder.open(), partial_name(checkpoint_name).c_str(), 0);
    throw std::runtime_error((folder / checkpoint_name).string() + ": the checkpoint cannot be written: " +
                             error.what() + ". Check the free space and the permissions of the folder.");
  }
}

void remove_checkpoint_file(const OutputFolder& folder) {
  const Descriptor directory = folder.open();
  unlinkat(directory, checkpoint_name, 0);
  unlinkat(directory, partial_name(checkpoint_name).c_str(), 0);
}

CheckpointContents read_checkpoint_file(const std::filesystem::path& file) {
  const QuietErrors quiet;
  try {
    const Handle handle(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open the file");
    const Reader read(handle, std::filesystem::file_size(file));
    check_format(read);
    CheckpointContents contents;
    std::string builds, settings;
    read("builds", builds);
    contents.builds = split(builds);
    read("settings", settings);
    contents.settings = settings_of(split(settings));
    visit_arrays(contents, read);
    return contents;
  } catch (const std::runtime_error& error) {
    throw InputError(file.string() + ": is no checkpoint that this program can resume, or it is damaged: " +
                     error.what() + ". Give the checkpoint.h5 of an interrupted run.");
  }
}

}  // namespace tentpole
