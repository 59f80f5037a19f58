// What libcromer_mpi.so does: ranks, and messages between them. One thread calls it.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

struct CromerMpi {
  int version;

  /// Joins the ranks that were started together.
  void (*start)(int* rank, int* ranks);

  /// Begins to send `count` words, which stay as they are until sent() is true.
  void* (*send)(int to, int kind, const std::uint64_t* words, std::size_t count);
  /// Whether that is done; once true, `sending` is gone.
  bool (*sent)(void* sending);

  /// Whether a message is there, from whom and how long it is; receive() takes it.
  bool (*arrived)(int* from, int* kind, std::size_t* count);
  void (*receive)(std::uint64_t* words);

  /// Leaves the ranks; comes back when all do.
  void (*finish)();
};

const CromerMpi* cromer_mpi();

}  // extern "C"

namespace cromer::core {
constexpr int mpi_module_version = 1;
}
