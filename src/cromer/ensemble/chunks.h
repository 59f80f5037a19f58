// Rows of numbers, made chunk by chunk: what threads and ranks share out.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"

namespace cromer::core {

/// Work that falls into chunks, each of which depends on nothing but its number: so the rows are the same
/// bits whoever makes them, in whatever order.
struct ChunkedRows {
  std::vector<std::string> columns{};  ///< names with units: "amplitude (m)"
  std::uint64_t rows = 0;
  std::uint64_t rows_per_chunk = 1;  ///< the last chunk may have fewer

  /// Makes the rows of a chunk: rows_of(chunk) times columns.size() numbers, row after row. Called by several
  /// threads at once. False: it was interrupted, the rows are worthless.
  std::function<bool(std::uint64_t chunk, double* rows, const Watch& watch)> make{};

  /// Everything that the rows depend on, as text (JSON): works of the same description have the same rows.
  std::string description{};

  std::uint64_t chunks() const { return (rows + rows_per_chunk - 1) / rows_per_chunk; }
  std::uint64_t rows_of(std::uint64_t chunk) const {
    return std::min(rows_per_chunk, rows - chunk * rows_per_chunk);
  }
};

/// Takes a finished chunk; called by one thread at a time, chunks in any order. An Error ends the work.
using ChunkSink = std::function<Result<void>(std::uint64_t chunk, const double* rows)>;

/// How the work ended; an Error is the sink's.
enum class ChunksEnd { done, interrupted };

/// Hands out the next chunk to make, or nothing if there are no more. Called by one thread at a time; may
/// wait.
using ChunkSource = std::function<std::optional<std::uint64_t>()>;

/// Makes those chunks on so many threads (0: one for each processor) and hands each to the sink. Holds at
/// most two chunks a thread in memory. Progress: the share of the chunks that are done.
Result<ChunksEnd> make_chunks(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks, int threads,
                              const ChunkSink& sink, const Watch& watch);

/// The same for chunks that are handed out while the work goes on; tells no progress.
Result<ChunksEnd> make_chunks(const ChunkedRows& work, const ChunkSource& source, int threads,
                              const ChunkSink& sink, const Watch& watch);

/// A function that makes chunks: make_chunks, or one that spreads them over ranks.
using ChunkMaker =
    std::function<Result<ChunksEnd>(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks,
                                    int threads, const ChunkSink& sink, const Watch& watch)>;

/// The number of threads: `threads`, or if that is 0 one for each processor that this process may use.
int threads_of(int threads);

}  // namespace cromer::core
