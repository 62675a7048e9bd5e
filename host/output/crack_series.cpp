#include "host/output/crack_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/binary_stream.hpp"
#include "host/output/crack_grid.hpp"
#include "host/output/output_times.hpp"
#include "host/output/series_writer.hpp"

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
  write_series(options.folder, "cracks.vtkhdf.series", entries);
}

bool is_sound(const CrackSegment& segment) {
  const bool has_mode =
      segment.mode == CrackMode::open || segment.mode == CrackMode::stick || segment.mode == CrackMode::slip;
  return has_mode && std::all_of(segment.damage.begin(), segment.damage.begin() + segment.num_points,
                                 [](double damage) { return std::isfinite(damage); });
}

}  // namespace

CrackSeries::CrackSeries(Options options) : options_(std::move(options)), segments_(options_.times.size()) {
  check_output_times(options_.times, "cracks");
  if (options_.dimension != 1 && options_.dimension != 2)
    throw std::invalid_argument("cracks are written in one and two dimensions, not in " +
                                std::to_string(options_.dimension));
}

void CrackSeries::add(int index, const CrackSegment& segment) {
  if (index < num_written_)
    throw std::logic_error("fracture edge " + std::to_string(segment.id) + " covers crack file " +
                           std::to_string(index) + ", which is written already");
  check_segment(segment, options_.dimension);
  segments_.at(index).push_back(segment);
}

void CrackSeries::finish(double front_minimum_time) {
  while (num_written_ < static_cast<int>(times().size()) &&
         front_has_passed(front_minimum_time, times()[num_written_])) {
    std::vector<CrackSegment>& segments = segments_[num_written_];
    write_vtkhdf(options_.folder, file_name(num_written_),
                 crack_grid(options_.dimension, times()[num_written_], segments));
    segments = {};
    ++num_written_;
    write_series_file(options_, num_written_);
  }
}

void CrackSeries::save(std::ostream& stream) const {
  write_value(stream, num_written_);
  write_value(stream, segments_.size());
  for (const std::vector<CrackSegment>& segments : segments_) write_vector(stream, segments);
}

void CrackSeries::load(std::istream& stream) {
  const int num_written = read_number(stream, static_cast<int>(times().size()), "the number of written crack files");
  const auto num_times = read_value<std::size_t>(stream);
  if (num_times != times().size())
    throw std::runtime_error("the checkpoint has " + std::to_string(num_times) + " crack files and the case " +
                             std::to_string(times().size()) + "; resume with the case file of the checkpoint");
  for (std::vector<CrackSegment>& segments : segments_) {
    segments = read_vector<CrackSegment>(stream);
    for (const CrackSegment& segment : segments) {
      check_segment(segment, options_.dimension);
      require_sound(stream, is_sound(segment), "a crack segment has an unknown mode, or damage that is not finite");
    }
  }
  num_written_ = num_written;
}

void CrackSeries::add_written(WrittenFiles& files) const {
  for (int index = 0; index < num_written_; ++index) files.push_back({options_.folder / file_name(index)});
  if (num_written_ > 0) files.push_back({options_.folder / "cracks.vtkhdf.series"});
}

}  // namespace tentpole
