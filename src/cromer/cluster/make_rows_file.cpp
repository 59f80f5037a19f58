#include "cromer/cluster/make_rows_file.h"

namespace cromer {

Result<ChunksEnd> make_rows_file(RowsFile& file, const ChunkedRows& work, Ranks* ranks, int threads,
                                 const Watch& watch) {
  const auto sink = [&](std::uint64_t chunk, const double* rows) { return file.write(chunk, rows); };
  auto end = ranks ? ranks->make_chunks(work, file.unfinished(), threads, sink, watch)
                   : make_chunks(work, file.unfinished(), threads, sink, watch);
  auto closed = file.close();
  if (end && !closed) return closed.error();
  return end;
}

}  // namespace cromer
