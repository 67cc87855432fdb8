#pragma once
// The same work on many things by a number of threads. Which thread does what is left open: the work must not tell.

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace osculate {

class Threads {
 public:
  explicit Threads(int count) : count_(count), arena_(count) {
    // More threads than processors, where someone asks for them.
    if (count > oneapi::tbb::info::default_concurrency())
      allowed_.emplace(oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  }

  int count() const { return count_; }

  /// Calls work(begin, end) for consecutive blocks of [0, size).
  template <class Work>
  void for_blocks(std::size_t size, std::size_t block, const Work& work) {
    const std::size_t blocks = (size + block - 1) / block;
    const auto one = [&](std::size_t b) { work(b * block, std::min(size, (b + 1) * block)); };
    if (count_ == 1) {
      for (std::size_t b = 0; b < blocks; ++b) one(b);
      return;
    }
    arena_.execute([&] { oneapi::tbb::parallel_for(std::size_t{0}, blocks, one); });
  }

  /// Calls work() so that what TBB does in it keeps to these threads.
  template <class Work>
  void run(const Work& work) {
    arena_.execute(work);
  }

  /// The number of the thread that calls, below count().
  static std::size_t current() {
    return static_cast<std::size_t>(std::max(0, oneapi::tbb::this_task_arena::current_thread_index()));
  }

 private:
  int count_;
  std::optional<oneapi::tbb::global_control> allowed_;
  oneapi::tbb::task_arena arena_;
};

}  // namespace osculate
