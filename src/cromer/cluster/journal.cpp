#include "cromer/cluster/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>

#include "cromer/os/file.h"

namespace cromer::core {
namespace {

constexpr char finished = 'x', unfinished_mark = '-';

std::string first_line(std::uint64_t chunks, const std::string& work) {
  return fmt::format("cromer journal 1: {} chunks of {}; x: finished\n", chunks, work);
}

}  // namespace

Result<void> Journal::lock() const {
  // A program that was just killed may take a moment to be gone.
  for (int i = 0; i < 20; ++i) {
    if (os::lock(file_.descriptor()) || errno != EWOULDBLOCK) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return Error{"another_is_writing", {{"journal", path_}}};
}

Result<Journal> Journal::create(const std::string& file, std::uint64_t chunks, const std::string& work) {
  Journal journal;
  journal.path_ = path_of(file);
  auto opened = DiskFile::open(journal.path_, O_CREAT);
  if (!opened) return opened.error();
  journal.file_ = std::move(*opened);
  if (auto good = journal.lock(); !good) return good.error();
  if (!os::truncate(journal.file_.descriptor(), 0))
    return Error{"cannot_write_journal", {{"journal", journal.path_}}};
  const std::string line = first_line(chunks, work);
  journal.begin_ = line.size();
  journal.chunks_ = chunks;
  const std::string marks(std::min<std::uint64_t>(chunks, 1 << 20), unfinished_mark);
  for (std::uint64_t at = 0; at < chunks; at += marks.size())
    if (auto good = journal.file_.write(marks.data(), std::min<std::uint64_t>(marks.size(), chunks - at),
                                        journal.begin_ + at);
        !good)
      return good.error();
  if (auto good = journal.file_.write(line.data(), line.size(), 0); !good) return good.error();
  if (auto good = journal.file_.sync(); !good) return good.error();
  return journal;
}

Result<Journal> Journal::open(const std::string& file, std::uint64_t chunks, const std::string& work) {
  Journal journal;
  journal.path_ = path_of(file);
  auto opened = DiskFile::open(journal.path_, 0);
  if (!opened) return opened.error();
  journal.file_ = std::move(*opened);
  if (auto good = journal.lock(); !good) return good.error();
  const std::string line = first_line(chunks, work);
  journal.begin_ = line.size();
  journal.chunks_ = chunks;
  std::string there(line.size() + 1, '\0');
  char last = 0;
  there.resize(journal.file_.read(there.data(), there.size(), 0));
  const bool whole = journal.file_.read(&last, 1, journal.begin_ + chunks - 1) == 1;
  if (there.compare(0, line.size(), line) != 0 || !whole)
    return Error{"not_the_journal", {{"journal", journal.path_}, {"file", file}}};
  return journal;
}

std::vector<std::uint64_t> Journal::unfinished() const {
  std::vector<std::uint64_t> chunks;
  std::string marks(1 << 16, '\0');
  for (std::uint64_t at = 0; at < chunks_; at += marks.size()) {
    const std::size_t count = std::min<std::uint64_t>(marks.size(), chunks_ - at);
    const std::size_t there = file_.read(marks.data(), count, begin_ + at);
    for (std::size_t i = 0; i < count; ++i)
      if (i >= there || marks[i] != finished) chunks.push_back(at + i);
  }
  return chunks;
}

Result<void> Journal::mark(const std::vector<std::uint64_t>& chunks) const {
  for (const std::uint64_t chunk : chunks)
    if (auto good = file_.write(&finished, 1, begin_ + chunk); !good) return good;
  return file_.sync();
}

}  // namespace cromer::core
