#include "cromer/cluster/crew.h"

#include <cstring>
#include <exception>
#include <new>

namespace cromer::core {

Notice notice_of(const Trouble& trouble) {
  switch (trouble.kind) {
    case Trouble::Kind::none:
      break;
    case Trouble::Kind::not_made:
      return Notice{"chunk_not_made"};
    case Trouble::Kind::no_memory:
      return Notice{"no_memory_for_chunk"};
    case Trouble::Kind::in_words:
      return Notice{"said_in_words", {{"words", trouble.words}}};
  }
  return {};
}

Crew::Crew(const ChunkedRows& work, int threads) : thread_([this, &work, threads] { run(work, threads); }) {}

void Crew::run(const ChunkedRows& work, int threads) {
  const auto source = [&]() -> std::optional<std::uint64_t> {
    std::unique_lock lock(mutex_);
    given_or_stopped_.wait(lock, [&] { return stop_ || !given_.empty(); });
    if (stop_) return std::nullopt;
    const std::uint64_t chunk = given_.front();
    given_.pop_front();
    return chunk;
  };
  const auto sink = [&](std::uint64_t chunk, const double* rows) -> Result<void> {
    const std::size_t numbers = work.rows_of(chunk) * work.columns.size();
    MadeChunk made;
    made.words.resize(1 + numbers);
    made.words[0] = chunk;
    std::memcpy(&made.words[1], rows, numbers * sizeof(double));
    const std::lock_guard lock(mutex_);
    made_.push_back(std::move(made));
    made_or_gone_.notify_one();
    return {};
  };
  Trouble trouble;
  try {
    const auto end = make_chunks(work, source, threads, sink, {&stop_, {}, {}});
    if (end && *end == ChunksEnd::interrupted && !stop_) trouble.kind = Trouble::Kind::not_made;
  } catch (const std::bad_alloc&) {
    trouble.kind = Trouble::Kind::no_memory;
  } catch (const std::exception& thrown) {
    trouble = {Trouble::Kind::in_words, thrown.what()};
  }
  const std::lock_guard lock(mutex_);
  trouble_ = trouble;
  gone_ = true;
  made_or_gone_.notify_one();
}

void Crew::give(std::uint64_t chunk) {
  const std::lock_guard lock(mutex_);
  given_.push_back(chunk);
  given_or_stopped_.notify_one();
}

std::optional<MadeChunk> Crew::take() {
  const std::lock_guard lock(mutex_);
  if (made_.empty()) return std::nullopt;
  MadeChunk made = std::move(made_.front());
  made_.pop_front();
  return made;
}

void Crew::stop() {
  const std::lock_guard lock(mutex_);
  stop_ = true;
  given_or_stopped_.notify_one();
}

bool Crew::gone() {
  const std::lock_guard lock(mutex_);
  return gone_;
}

void Crew::wait(std::chrono::microseconds patience) {
  std::unique_lock lock(mutex_);
  made_or_gone_.wait_for(lock, patience, [&] { return !made_.empty(); });
}

Trouble Crew::trouble() {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

}  // namespace cromer::core
