#include "cromer/cluster/ranks.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <optional>
#include <utility>

#include "cromer/cluster/crew.h"
#include "cromer/cluster/hand_out.h"
#include "cromer/cluster/messages.h"
#include "cromer/cluster/module.h"

namespace cromer::core {
namespace {

std::optional<int> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  if (!text || !*text) return std::nullopt;
  char* end = nullptr;
  const long number = std::strtol(text, &end, 10);
  if (*end != '\0' || number < 0 || number > 100'000'000) return std::nullopt;
  return static_cast<int>(number);
}

std::string host_name() {
  char name[256] = "";
  gethostname(name, sizeof(name) - 1);
  return name;
}

Words hello(const ChunkedRows& work, int threads) {
  return words_of(static_cast<std::uint64_t>(threads_of(threads)), {host_name(), work.description});
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
  // Where ranks are bound to processors of their own, those are the usable ones; where not, all would take
  // all.
  int here = 1;
  for (const char* variable : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"})
    here = std::max(here, number_in(variable).value_or(1));
  return std::clamp(static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)) / here, 1, usable);
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
  // A rank that throws here cannot say so any more; gone without a word it ends the others, and nothing is
  // lost.
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
  using std::chrono::microseconds;
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
                words_of(static_cast<std::uint64_t>(trouble.kind), {host_name(), trouble.words}));
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
