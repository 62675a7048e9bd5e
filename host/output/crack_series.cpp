#include "host/output/crack_series.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "host/output/binary_stream.hpp"
#include "host/output/crack_grid.hpp"
#include "host/output/output_times.hpp"
#include "host/output/series_writer.hpp"
#include "host/output/time_coverage.hpp"

namespace tentpole {
namespace {

std::string file_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "cracks_%04d.vtkhdf", index);
  return name;
}

void write_series_file(const CrackSeries::Options& options, int num_written) {
  std::vector<SeriesEntry> entries;
  for (int index = 0; index < num_written; ++index) entries.push_back({file_name(index), options.times[index]});
  write_series(options.folder / "cracks.vtkhdf.series", entries);
}

}  // namespace

CrackSeries::CrackSeries(Options options) : options_(std::move(options)) {
  check_output_times(options_.times, "cracks");
  if (options_.dimension != 1 && options_.dimension != 2)
    throw std::invalid_argument("cracks are written in one and two dimensions, not in " +
                                std::to_string(options_.dimension));
  std::filesystem::create_directories(options_.folder);
}

bool CrackSeries::wants(double front_minimum_time) const {
  return num_written_ < static_cast<int>(options_.times.size()) &&
         front_has_passed(front_minimum_time, options_.times[num_written_]);
}

void CrackSeries::finish(double front_minimum_time, std::span<const CrackSegment> segments) {
  while (wants(front_minimum_time)) {
    const UnstructuredGrid grid = crack_grid(options_.dimension, options_.times[num_written_], segments);
    write_vtkhdf(options_.folder / file_name(num_written_), grid);
    ++num_written_;
    write_series_file(options_, num_written_);
  }
}

void CrackSeries::save(std::ostream& stream) const {
  write_value(stream, num_written_);
}

void CrackSeries::load(std::istream& stream) {
  const int num_written = read_value<int>(stream);
  const int num_times = static_cast<int>(options_.times.size());
  if (num_written < 0 || num_written > num_times)
    throw std::runtime_error("the checkpoint has " + std::to_string(num_written) + " crack files and the case " +
                             std::to_string(num_times) + "; resume with the case file of the checkpoint");
  num_written_ = num_written;
}

void CrackSeries::add_written(WrittenFiles& files) const {
  for (int index = 0; index < num_written_; ++index) files.push_back({options_.folder / file_name(index)});
  if (num_written_ > 0) files.push_back({options_.folder / "cracks.vtkhdf.series"});
}

}  // namespace tentpole
