#include <mpi.h>

#include "cromer/cluster/mpi_module.h"

namespace {

MPI_Message waiting = MPI_MESSAGE_NULL;
int waiting_words = 0;

void start(int* rank, int* ranks) {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, rank);
  MPI_Comm_size(MPI_COMM_WORLD, ranks);
}

void* send(int to, int kind, const std::uint64_t* words, std::size_t count) {
  auto* request = new MPI_Request;
  MPI_Isend(words, static_cast<int>(count), MPI_UINT64_T, to, kind, MPI_COMM_WORLD, request);
  return request;
}

bool sent(void* sending) {
  auto* request = static_cast<MPI_Request*>(sending);
  int done = 0;
  MPI_Test(request, &done, MPI_STATUS_IGNORE);
  if (done) delete request;
  return done;
}

bool arrived(int* from, int* kind, std::size_t* count) {
  int there = 0;
  MPI_Status status;
  MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &waiting, &status);
  if (!there) return false;
  MPI_Get_count(&status, MPI_UINT64_T, &waiting_words);
  *from = status.MPI_SOURCE;
  *kind = status.MPI_TAG;
  *count = static_cast<std::size_t>(waiting_words);
  return true;
}

void receive(std::uint64_t* words) {
  MPI_Mrecv(words, waiting_words, MPI_UINT64_T, &waiting, MPI_STATUS_IGNORE);
}

void finish() { MPI_Finalize(); }

}  // namespace

extern "C" const CromerMpi* cromer_mpi() {
  static const CromerMpi interface {
    cromer::core::mpi_module_version, start, send, sent, arrived, receive, finish
  };
  return &interface;
}
