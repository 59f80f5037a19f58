#include "cromer/ensemble/chunks.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <mutex>

namespace cromer::core {
namespace {

/// A chunk on its way through the pipeline. Its memory is used again and again.
struct Parcel {
  std::uint64_t chunk = 0;
  bool made = false;
  std::vector<double> rows{};
};

/// The memory of all parcels on their way, as many as the pipeline allows.
class Parcels {
 public:
  explicit Parcels(std::size_t count) : all_(count) {
    for (Parcel& parcel : all_) free_.push_back(&parcel);
  }
  Parcel* take() {
    const std::lock_guard lock(mutex_);
    Parcel* parcel = free_.back();
    free_.pop_back();
    return parcel;
  }
  void give_back(Parcel* parcel) {
    const std::lock_guard lock(mutex_);
    free_.push_back(parcel);
  }

 private:
  std::mutex mutex_{};
  std::vector<Parcel> all_;
  std::vector<Parcel*> free_{};
};

}  // namespace

int threads_of(int threads) { return threads > 0 ? threads : oneapi::tbb::info::default_concurrency(); }

Result<ChunksEnd> make_chunks(const ChunkedRows& work, const ChunkSource& source, int threads,
                              const ChunkSink& sink, const Watch& watch) {
  namespace tbb = oneapi::tbb;
  const int count = threads_of(threads);
  const std::size_t parcels_alive = 2 * static_cast<std::size_t>(count);
  Parcels parcels(parcels_alive);
  std::atomic<bool> stop{false}, interrupted{false};
  // Every worker leaves its mark, which the caller reads at the end: oneTBB hands over as well, but not so
  // that the thread sanitizer sees it.
  std::atomic<std::uint64_t> marks{0};
  Result<void> good;
  const Watch interruption = without_progress(watch);  // progress is told by the chunk

  const auto take = [&](tbb::flow_control& flow) -> Parcel* {
    if (watch.interrupted()) interrupted = stop = true;
    const auto chunk = stop ? std::nullopt : source();
    if (!chunk) {
      flow.stop();
      return nullptr;
    }
    Parcel* parcel = parcels.take();
    parcel->chunk = *chunk;
    return parcel;
  };
  const auto make = [&](Parcel* parcel) {
    parcel->rows.resize(work.rows_of(parcel->chunk) * work.columns.size());
    parcel->made = !stop && work.make(parcel->chunk, parcel->rows.data(), interruption);
    if (!parcel->made && !stop) interrupted = stop = true;
    marks.fetch_add(1, std::memory_order_release);
    return parcel;
  };
  const auto hand_on = [&](Parcel* parcel) {
    if (parcel->made && good) {
      good = sink(parcel->chunk, parcel->rows.data());
      if (!good) stop = true;
    }
    parcels.give_back(parcel);
    marks.fetch_add(1, std::memory_order_release);
  };

  using Mode = tbb::filter_mode;
  // More threads than processors only because they were asked for: tests do.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
  tbb::task_arena(count).execute([&] {
    tbb::parallel_pipeline(parcels_alive,
                           tbb::make_filter<void, Parcel*>(Mode::serial_in_order, take) &
                               tbb::make_filter<Parcel*, Parcel*>(Mode::parallel, make) &
                               tbb::make_filter<Parcel*, void>(Mode::serial_out_of_order, hand_on));
  });
  (void)marks.load(std::memory_order_acquire);
  if (!good) return good.error();
  return interrupted ? ChunksEnd::interrupted : ChunksEnd::done;
}

Result<ChunksEnd> make_chunks(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks, int threads,
                              const ChunkSink& sink, const Watch& watch) {
  std::size_t handed_out = 0, done = 0;
  const auto source = [&]() -> std::optional<std::uint64_t> {
    if (handed_out == chunks.size()) return std::nullopt;
    return chunks[handed_out++];
  };
  const auto counting = [&](std::uint64_t chunk, const double* rows) {
    auto good = sink(chunk, rows);
    if (good && watch.progress)
      watch.progress(static_cast<double>(++done) / static_cast<double>(chunks.size()));
    return good;
  };
  return make_chunks(work, source, threads, counting, watch);
}

}  // namespace cromer::core
