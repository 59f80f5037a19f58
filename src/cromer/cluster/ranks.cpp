#include "cromer/cluster/ranks.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cromer/cluster/crew.h"
#include "cromer/cluster/differences.h"
#include "cromer/cluster/module.h"
#include "cromer/cluster/mpi_module.h"
#include "cromer/ensemble/chunks.h"
#include "cromer/os/process.h"

namespace cromer::core {
namespace {

using std::chrono::microseconds;

/// What a message between ranks consists of.
using Words = std::vector<std::uint64_t>;

/// Kinds of messages.
enum class Kind : int {
  hello,        ///< to the first: threads, then host and description as text
  chunk,        ///< from the first: a chunk to make
  rows,         ///< to the first: a chunk made
  problem,      ///< to the first: why this rank cannot go on: a Trouble's kind, then host and words as text
  interrupted,  ///< to the first: somebody wants this rank to stop
  stop,         ///< from the first: there is nothing more to do
  left,         ///< to the first: the last message of this rank
};

struct Message {
  int from = 0;
  Kind kind{};
  Words words{};
};

Words words_of(const std::string& text) {
  Words words(1 + (text.size() + 7) / 8);
  words[0] = text.size();
  std::memcpy(words.data() + 1, text.data(), text.size());
  return words;
}

/// A number, then texts.
Words words_of(std::uint64_t number, std::initializer_list<std::string> texts) {
  Words words = {number};
  for (const std::string& text : texts) {
    const Words more = words_of(text);
    words.insert(words.end(), more.begin(), more.end());
  }
  return words;
}

/// The text that begins at `at`; moves `at` behind it.
std::string text_of(const Words& words, std::size_t& at) {
  std::string text(words.at(at), '\0');
  std::memcpy(text.data(), words.data() + at + 1, text.size());
  at += 1 + (text.size() + 7) / 8;
  return text;
}

/// Sends without waiting; the words live here until they are sent.
class Post {
 public:
  explicit Post(const CromerMpi* mpi) : mpi_(mpi) {}

  void send(int to, Kind kind, Words words) {
    auto& letter = letters_.emplace_back(Letter{std::move(words), nullptr});
    letter.sending = mpi_->send(to, static_cast<int>(kind), letter.words.data(), letter.words.size());
  }
  /// Whether all is sent.
  bool empty() {
    letters_.remove_if([&](const Letter& letter) { return mpi_->sent(letter.sending); });
    return letters_.empty();
  }
  bool receive(Message& message) {
    int kind = 0;
    std::size_t count = 0;
    if (!mpi_->arrived(&message.from, &kind, &count)) return false;
    message.kind = static_cast<Kind>(kind);
    message.words.resize(count);
    mpi_->receive(message.words.data());
    return true;
  }

 private:
  struct Letter {
    Words words;
    void* sending;
  };
  const CromerMpi* mpi_;
  std::list<Letter> letters_{};
};

/// The first rank's part: which rank gets which chunk, and when all is over. Each rank has as many chunks in
/// hand as it has threads, and one more while there are plenty: it never waits for the next one, and towards
/// the end no rank holds a chunk that another could begin.
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
    // After something happened, more is likely to come soon.
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

std::optional<int> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text || !*text) return std::nullopt;
  char* end = nullptr;
  const long number = std::strtol(text, &end, 10);
  if (*end != '\0' || number < 0 || number > 100'000'000) return std::nullopt;
  return static_cast<int>(number);
}

Words hello(const ChunkedRows& work, int threads) {
  return words_of(static_cast<std::uint64_t>(threads_of(threads)), {os::host_name(), work.description});
}

ChunkedRows nothing() {
  ChunkedRows work;
  work.make = [](std::uint64_t, double*, const Watch&) { return false; };
  return work;
}

}  // namespace

RankPlace rank_place() {
  // Open MPI's mpirun, MPICH's and Intel's, srun's steps (the variables of a job alone also stand in its
  // script).
  constexpr const char* known[][2] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                      {"PMI_SIZE", "PMI_RANK"},
                                      {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}};
  for (const auto& [size, rank] : known) {
    const auto ranks = number_in(size), place = number_in(rank);
    if (ranks && place && *ranks > 1 && *place < *ranks) return {*place, *ranks};
  }
  return {};
}

int threads_of_rank(int asked) {
  const int usable = threads_of(asked);
  if (asked > 0) return usable;
  // Ranks bound to processors of their own can use those only. Ranks that are not would each take all.
  int here = 1;
  for (const char* variable : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"})
    here = std::max(here, number_in(variable).value_or(1));
  return std::clamp(os::processors() / here, 1, usable);
}

Result<Ranks> Ranks::join(const RankPlace& place) {
  auto found = load_module({"libcromer_mpi.so", "cromer_mpi", Notice{"mpirun_and_srun"}, "libopenmpi-dev"});
  if (!found) return found.error();
  const auto* mpi = reinterpret_cast<const CromerMpi* (*)()>(*found)();
  if (mpi->version != mpi_module_version)
    return Error{"module_of_other_version", {{"module", "libcromer_mpi.so"}}};
  RankPlace seen;
  mpi->start(&seen.rank, &seen.ranks);
  Ranks ranks(mpi, seen);
  if (seen.ranks != place.ranks) {
    ranks.over_ = true;
    return Error{"mpi_sees_others", {{"started", place.ranks}, {"seen", seen.ranks}}};
  }
  return ranks;
}

Ranks::Ranks(Ranks&& other) noexcept
    : mpi_(std::exchange(other.mpi_, nullptr)), place_(other.place_), over_(other.over_) {}

Ranks::~Ranks() {
  if (!mpi_) return;
  // A rank that gets here by an exception cannot say so any more. If it leaves without a word, the others
  // end, and nothing is lost.
  if (!first() && std::uncaught_exceptions() > 0) std::_Exit(1);
  if (first() && !over_) {
    const auto none = [](std::uint64_t, const double*) { return Result<void>(); };
    (void)make_chunks(nothing(), {}, 1, none, {});
  }
  mpi_->finish();
}

Result<ChunksEnd> Ranks::make_chunks(const ChunkedRows& work, const std::vector<std::uint64_t>& chunks,
                                     int threads, const ChunkSink& sink, const Watch& watch) {
  auto end = HandOut(work, chunks, place_.ranks, threads_of_rank(threads), mpi_, sink, watch).run();
  over_ = true;
  return end;
}

void Ranks::help(const ChunkedRows& work, int threads, const Watch& watch) {
  help_or_tell(work, threads_of_rank(threads), watch, {});
}

void Ranks::cannot_help(const std::string& why) {
  help_or_tell(nothing(), 1, {}, {Trouble::Kind::in_words, why});
}

void Ranks::help_or_tell(const ChunkedRows& work, int threads, const Watch& watch, Trouble trouble) {
  over_ = true;
  Post post(mpi_);
  Crew crew(work, threads);
  if (trouble.empty()) post.send(0, Kind::hello, hello(work, threads));
  bool said = false, stopping = false;
  auto patience = microseconds(1000);
  while (!stopping || !crew.gone()) {
    bool happened = !post.empty();
    for (Message message; post.receive(message); happened = true) {
      if (message.kind == Kind::chunk) crew.give(message.words.at(0));
      if (message.kind == Kind::stop) crew.stop(), stopping = true;
    }
    while (auto made = crew.take()) {
      post.send(0, Kind::rows, std::move(made->words));
      happened = true;
    }
    if (trouble.empty()) trouble = crew.trouble();
    if (!trouble.empty() && !said) {
      said = true;
      post.send(0, Kind::problem,
                words_of(static_cast<std::uint64_t>(trouble.kind), {os::host_name(), trouble.words}));
    }
    if (watch.interrupted() && !said) {
      said = true;
      post.send(0, Kind::interrupted, {0});
    }
    patience = happened ? microseconds(50) : std::min(2 * patience, microseconds(1000));
    crew.wait(patience);
  }
  while (auto made = crew.take()) post.send(0, Kind::rows, std::move(made->words));
  post.send(0, Kind::left, {0});
  while (!post.empty()) crew.wait(microseconds(50));
}

}  // namespace cromer::core
