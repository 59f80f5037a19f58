#include "cromer/cluster/hand_out.h"

#include "cromer/cluster/differences.h"

namespace cromer::core {

using std::chrono::microseconds;

HandOut::HandOut(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks, int ranks, int threads,
                 const CromerMpi* mpi, const ChunkSink& sink, const Watch& watch)
    : work_(work),
      chunks_(chunks),
      sink_(sink),
      watch_(watch),
      post_(mpi),
      crew_(work, threads),
      members_(static_cast<std::size_t>(ranks)) {
  threads_ = members_[0].threads = static_cast<std::size_t>(threads_of(threads));
  members_[0].host = "this one";
}

Result<ChunksEnd> HandOut::run() {
  supply(0);
  auto patience = microseconds(1000);
  while (left_ + 1 < members_.size() || !crew_.gone()) {
    // Where something just happened more is likely to come soon.
    patience = look_around() ? microseconds(50) : std::min(2 * patience, microseconds(1000));
    const bool all_done = done_ == chunks_.size();
    if (!ended_ && (all_done || !good_ || interrupted_)) end();
    crew_.wait(patience);
  }
  look_around();
  while (!post_.empty()) crew_.wait(microseconds(50));
  if (!good_) return good_.error();
  return done_ == chunks_.size() ? ChunksEnd::done : ChunksEnd::interrupted;
}

bool HandOut::look_around() {
  bool happened = false;
  for (Message message; post_.receive(message); happened = true) answer(message);
  while (const auto made = crew_.take()) {
    keep(0, made->chunk(), made->rows());
    happened = true;
  }
  if (const Trouble trouble = crew_.trouble(); !trouble.empty()) fail(notice_of(trouble));
  if (watch_.interrupted()) interrupted_ = true;
  post_.empty();
  return happened;
}

void HandOut::answer(const Message& message) {
  Member& member = members_[static_cast<std::size_t>(message.from)];
  std::size_t at = 1;
  switch (message.kind) {
    case Kind::hello: {
      member.threads = message.words.at(0);
      member.host = text_of(message.words, at);
      threads_ += member.threads;
      const std::string description = text_of(message.words, at);
      if (const std::vector<Notice> other = differences(work_.description, description); !other.empty())
        return fail(Notice{"rank_computes_otherwise",
                           {{"rank", message.from}, {"host", member.host}, {"differences", other}}});
      return supply(message.from);
    }
    case Kind::rows:
      return keep(message.from, message.words.at(0),
                  reinterpret_cast<const double*>(message.words.data() + 1));
    case Kind::problem: {
      const std::string host = text_of(message.words, at);
      const Trouble trouble{static_cast<Trouble::Kind>(message.words.at(0)), text_of(message.words, at)};
      return fail(
          Notice{"rank_in_trouble", {{"rank", message.from}, {"host", host}, {"what", notice_of(trouble)}}});
    }
    case Kind::interrupted:
      interrupted_ = true;
      return;
    case Kind::left:
      ++left_;
      return;
    case Kind::chunk:
    case Kind::stop:
      return;  // only the first rank sends these
  }
}

void HandOut::keep(int rank, std::uint64_t chunk, const double* rows) {
  --members_[static_cast<std::size_t>(rank)].in_hand;
  if (!good_) return;
  good_ = sink_(chunk, rows);
  if (!good_) return;
  ++done_;
  if (watch_.progress) watch_.progress(static_cast<double>(done_) / static_cast<double>(chunks_.size()));
  supply(rank);
}

void HandOut::supply(int rank) {
  Member& member = members_[static_cast<std::size_t>(rank)];
  while (!ended_ && handed_out_ < chunks_.size()) {
    const bool plenty = chunks_.size() - handed_out_ > 2 * threads_;
    if (member.in_hand >= member.threads + (plenty ? 1 : 0)) return;
    const std::uint64_t chunk = chunks_[handed_out_++];
    ++member.in_hand;
    if (rank == 0)
      crew_.give(chunk);
    else
      post_.send(rank, Kind::chunk, {chunk});
  }
}

void HandOut::fail(const Notice& why) {
  if (good_) good_ = Error{why};
}

void HandOut::end() {
  ended_ = true;
  crew_.stop();
  for (int rank = 1; rank < static_cast<int>(members_.size()); ++rank) post_.send(rank, Kind::stop, {0});
}

}  // namespace cromer::core
