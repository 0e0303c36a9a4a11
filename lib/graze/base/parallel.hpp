// Independent pieces of work on several cores.
#pragma once

#include <cstddef>
#include <functional>

namespace graze {

// As many as `threads` asks for (0: as many as there are cores), at most one a core that this
// process may use.
int thread_count(int threads);

// Calls work(0) .. work(count - 1), each once, in any order, on up to `threads` threads (0: as many
// as there are cores), and returns when all are done; the first exception is thrown on. Each call
// writes to a place of its own, so that results do not depend on the number of threads.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace graze
