#include "mpi_messages.hpp"

namespace graze {

namespace {
constexpr int kTag = 0;
}

MpiMessages::MpiMessages() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
}

void MpiMessages::send(int to, std::string bytes) {
  const std::lock_guard lock(mutex_);
  forget_complete();
  Sent& sent = sent_.emplace_back();
  sent.bytes = std::move(bytes);
  MPI_Isend(sent.bytes.data(), static_cast<int>(sent.bytes.size()), MPI_BYTE, to, kTag,
            MPI_COMM_WORLD, &sent.request);
}

std::optional<RankMessages::Received> MpiMessages::receive() {
  const std::lock_guard lock(mutex_);
  int has_arrived = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &has_arrived, &status);
  if (!has_arrived) return {};
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Received received{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(received.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, kTag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return received;
}

bool MpiMessages::has_left() {
  const std::lock_guard lock(mutex_);
  forget_complete();
  return sent_.empty();
}

void MpiMessages::forget_complete() {
  for (auto sent = sent_.begin(); sent != sent_.end();) {
    int is_complete = 0;
    MPI_Test(&sent->request, &is_complete, MPI_STATUS_IGNORE);
    sent = is_complete ? sent_.erase(sent) : std::next(sent);
  }
}

}  // namespace graze
