#include "host/output/recorder.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "host/output/slice_cells.hpp"
#include "host/output/snapshot_series.hpp"

namespace tentpole {

struct Recorder::Impl {
  OrthonormalBasis basis;
  SnapshotSeries snapshots;
  std::vector<Probe> probes;
  std::function<void()> require_folder;
};

namespace {

SnapshotSeries::Options snapshot_options(const RecorderOptions& options) {
  return {.num_subdivisions = default_subdivisions(options.dimension, options.degree),
          .plane_stress = options.plane_stress,
          .folder = options.folder,
          .times = options.snapshot_times,
          .fields = options.fields};
}

}  // namespace

Recorder::Recorder(RecorderOptions options) {
  std::set<std::string> names;
  for (const ProbeOptions& probe : options.probes)
    if (!names.insert(probe.name).second)
      throw std::invalid_argument("two probes are called \"" + probe.name + "\"; names must differ");
  impl_ = std::make_unique<Impl>(Impl{.basis = OrthonormalBasis(options.dimension + 1, options.degree),
                                      .snapshots = SnapshotSeries(snapshot_options(options)),
                                      .probes = {},
                                      .require_folder = std::move(options.require_folder)});
  for (ProbeOptions& probe : options.probes)
    impl_->probes.emplace_back(options.dimension, options.folder, std::move(probe));
}

Recorder::~Recorder() = default;
Recorder::Recorder(Recorder&&) noexcept = default;
Recorder& Recorder::operator=(Recorder&&) noexcept = default;

bool Recorder::wants(double time_min, double time_max, std::span<const double> lower,
                     std::span<const double> upper) const {
  if (!impl_->snapshots.range(time_min, time_max).empty()) return true;
  return std::any_of(impl_->probes.begin(), impl_->probes.end(),
                     [&](const Probe& probe) { return probe.wants(time_min, time_max, lower, upper); });
}

void Recorder::record(const SpacetimeElement& element) {
  const ElementFields fields(impl_->basis, element);
  impl_->snapshots.record(element, fields);
  for (Probe& probe : impl_->probes) probe.record(element, fields);
}

void Recorder::finish(double front_minimum_time) {
  impl_->require_folder();
  impl_->snapshots.finish(front_minimum_time);
  for (Probe& probe : impl_->probes) probe.finish(front_minimum_time);
}

void Recorder::save(std::ostream& stream) const {
  impl_->snapshots.save(stream);
  for (const Probe& probe : impl_->probes) probe.save(stream);
}

void Recorder::load(std::istream& stream) {
  impl_->snapshots.load(stream);
  for (Probe& probe : impl_->probes) probe.load(stream);
}

void Recorder::add_written(WrittenFiles& files) const {
  impl_->snapshots.add_written(files);
  for (const Probe& probe : impl_->probes) probe.add_written(files);
}

}  // namespace tentpole
