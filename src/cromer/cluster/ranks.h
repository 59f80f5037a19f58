// Processes that mpirun or srun started together: the first hands out the chunks, all make them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/ensemble/chunks.h"
#include "cromer/result.h"

struct CromerMpi;

namespace cromer::core {

struct Trouble;

/// The place of this process among those started together, as mpirun or srun left it in the environment.
struct RankPlace {
  int rank = 0, ranks = 1;
  bool first() const { return rank == 0; }
};
RankPlace rank_place();

/// The number of threads of a rank: `asked`, or if that is 0 its share of the machine's processors, and no
/// more than it may use.
int threads_of_rank(int asked);

/// The ranks, from joining them to leaving them. Only the first may write and print.
class Ranks {
 public:
  /// Waits for the others. An Error where MPI is missing or sees other ranks than the environment says.
  static Result<Ranks> join(const RankPlace& place);
  Ranks(Ranks&& other) noexcept;
  Ranks& operator=(Ranks&&) = delete;
  /// The first lets the others go, if it has not yet. Waits until all leave.
  ~Ranks();

  bool first() const { return place_.first(); }
  int count() const { return place_.ranks; }

  /// The first rank: makes those chunks on all ranks, on so many threads each (0: threads_of_rank), and hands
  /// each to the sink, which the calling thread alone calls. An interruption or a failure of any rank ends
  /// the work of all; an Error is the sink's, or says which rank could not go on. Descriptions that differ
  /// between ranks are an Error.
  Result<ChunksEnd> make_chunks(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks,
                                int threads, const ChunkSink& sink, const Watch& watch);

  /// The other ranks: make what they are handed until the first lets them go.
  void help(const ChunkedRows& work, int threads, const Watch& watch);

  /// The other ranks: tell the first, in words, why this one cannot help.
  void cannot_help(const std::string& why);

 private:
  Ranks(const CromerMpi* mpi, const RankPlace& place) : mpi_(mpi), place_(place) {}

  void help_or_tell(const ChunkedRows& work, int threads, const Watch& watch, Trouble trouble);

  const CromerMpi* mpi_ = nullptr;
  RankPlace place_{};
  bool over_ = false;
};

}  // namespace cromer::core
