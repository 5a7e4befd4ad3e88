#define OMPI_SKIP_MPICXX 1  // the header without C++ bindings
#include "cli/mpi/ranks.hpp"

#include <climits>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <mpi.h>
#include <stdexcept>
#include <thread>

namespace loadpath::cli {

Ranks::Ranks() {
  // MPI's own threads block signals, which are for the program's clean-up and message.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &own_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() { MPI_Finalize(); }

std::string Ranks::name() const {
  std::array<char, MPI_MAX_PROCESSOR_NAME> host{};
  int length = 0;
  MPI_Get_processor_name(host.data(), &length);
  return "rank " + std::to_string(own_) + " on " + std::string(host.data(), static_cast<std::size_t>(length));
}

void Ranks::send(int to, Kind kind, const std::string& bytes) const {
  if (bytes.size() > INT_MAX) throw std::length_error("a part has more bytes than a message of MPI holds");
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, static_cast<int>(kind), MPI_COMM_WORLD);
}

std::optional<RankMessage> Ranks::look() const {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  RankMessage message{status.MPI_SOURCE, static_cast<Kind>(status.MPI_TAG),
                      std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

RankMessage Ranks::wait() const {
  for (;;) {
    if (auto message = look()) return std::move(*message);
    sleep();
  }
}

void Ranks::sleep() { std::this_thread::sleep_for(std::chrono::microseconds(200)); }

void Ranks::abort(int code) {
  MPI_Abort(MPI_COMM_WORLD, code);
  std::_Exit(code);
}

}  // namespace loadpath::cli
