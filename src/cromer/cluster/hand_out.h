// The first rank's part: who gets which chunk, and when all is over.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cromer/cluster/crew.h"
#include "cromer/cluster/messages.h"
#include "cromer/ensemble/chunks.h"

namespace cromer::core {

/// Each rank has as many chunks in hand as it has threads, and one more while there are plenty: it never
/// waits for the next one, and towards the end no rank holds a chunk that another could begin.
class HandOut {
 public:
  HandOut(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks, int ranks, int threads,
          const CromerMpi* mpi, const ChunkSink& sink, const Watch& watch);

  /// Until all ranks have left.
  Result<ChunksEnd> run();

 private:
  struct Member {
    std::string host{};
    std::size_t threads = 0, in_hand = 0;  // 0 threads: it has not said hello
  };

  bool look_around();  // whether anything happened
  void answer(const Message& message);
  void keep(int rank, std::uint64_t chunk, const double* rows);
  void supply(int rank);
  void fail(const Notice& why);
  void end();

  const ChunkedRows& work_;
  const std::vector<std::uint64_t>& chunks_;
  const ChunkSink& sink_;
  const Watch& watch_;
  Post post_;
  Crew crew_;
  std::vector<Member> members_;
  std::size_t handed_out_ = 0, done_ = 0, threads_ = 0, left_ = 0;
  bool interrupted_ = false, ended_ = false;
  Result<void> good_{};
};

}  // namespace cromer::core
