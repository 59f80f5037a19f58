// A program for the tests to start on ranks, kill and go on with: rows that are cheap but take their time.
// rows_program FILE.h5 ROWS ROWS_PER_CHUNK MICROSECONDS_PER_CHUNK THREADS [resume] [often] [name=TEXT]
// [file-limit=BYTES]
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "cromer/cluster/ranks.h"
#include "cromer/cluster/rows_file.h"
#include "cromer/documents/words/words.h"

namespace {

std::atomic<bool> stop_asked{false};

cromer::core::ChunkedRows slow_rows(std::uint64_t rows, std::uint64_t rows_per_chunk, int microseconds,
                                    const std::string& name) {
  cromer::core::ChunkedRows work;
  work.columns = {"amplitude (m)", "phase (rad)"};
  work.rows = rows;
  work.rows_per_chunk = rows_per_chunk;
  work.description = "{\"name\": \"" + name + "\", \"rows\": " + std::to_string(rows) + "}";
  work.make = [=](std::uint64_t chunk, double* to, const cromer::core::Watch& watch) {
    // Uneven: some take three times as long as others.
    std::this_thread::sleep_for(
        std::chrono::microseconds(microseconds * static_cast<int>(1 + chunk * 7 % 5) / 3));
    const std::uint64_t first = chunk * rows_per_chunk, count = std::min(rows_per_chunk, rows - first);
    for (std::uint64_t r = 0; r < count; ++r) {
      const auto row = static_cast<double>(first + r);
      to[2 * r] = std::sin(row);
      to[2 * r + 1] = 1 / (1 + row);
    }
    return !watch.interrupted();
  };
  return work;
}

int fail(const std::string& message, int status) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return status;
}

}  // namespace

int main(int count, char** words) {
  using namespace cromer::core;
  if (count < 6) return 2;
  RowsFileOptions options{.path = words[1], .program = "rows_program", .command = "rows_program"};
  std::string name = "slow";
  for (int i = 6; i < count; ++i) {
    const std::string word = words[i];
    if (word == "often") options.note_every = std::chrono::milliseconds(50);
    if (word == "resume") options.resume = true;
    if (word.rfind("name=", 0) == 0) name = word.substr(5);
    if (word.rfind("file-limit=", 0) == 0) {
      const rlim_t bytes = std::strtoul(word.c_str() + 11, nullptr, 10);
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    }
  }
  signal(SIGXFSZ, SIG_IGN);
  signal(SIGTERM, [](int) { stop_asked = true; });
  const RankPlace place = rank_place();
  if (name == "by-rank") name += std::to_string(place.rank);
  std::ofstream(options.path + ".rank" + std::to_string(place.rank)) << getpid();
  ChunkedRows work = slow_rows(std::strtoul(words[2], nullptr, 10), std::strtoul(words[3], nullptr, 10),
                               std::atoi(words[4]), name);
  if (name == "throws" && place.rank > 0)
    work.make = [](std::uint64_t, double*, const Watch&) -> bool { throw std::bad_alloc(); };
  const int threads = std::atoi(words[5]);
  const Watch watch{&stop_asked, {}, {}};

  std::unique_ptr<Ranks> ranks;
  if (place.ranks > 1) {
    auto joined = Ranks::join(place);
    if (!joined) return fail(in_words(joined.error()), 2);
    ranks = std::make_unique<Ranks>(std::move(*joined));
    if (name == "cannot" && !ranks->first()) return ranks->cannot_help("this node has no AVX-512"), 0;
    if (!ranks->first()) return ranks->help(work, threads, watch), 0;
  }
  auto file = RowsFile::open(work, options, watch);
  if (!file) return fail(in_words(file.error()), 2);
  const auto sink = [&](std::uint64_t chunk, const double* made) { return file->write(chunk, made); };
  const auto end = ranks ? ranks->make_chunks(work, file->unfinished(), threads, sink, watch)
                         : make_chunks(work, file->unfinished(), threads, sink, watch);
  if (const auto closed = file->close(); !closed && end) return fail(in_words(closed.error()), 1);
  if (!end) return fail(in_words(end.error()), 1);
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  std::printf("%s; peak memory %ld KiB\n", *end == ChunksEnd::done ? "done" : "interrupted", used.ru_maxrss);
  return *end == ChunksEnd::done ? 0 : 1;
}
