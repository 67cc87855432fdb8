#include "validation/independent_cases.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <thread>

namespace osculate::validation {

int processors() {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void run_independent(const std::vector<Case>& cases, int threads, const Done& done) {
  constexpr std::chrono::milliseconds between_looks{100};
  std::vector<std::atomic<double>> parts(cases.size());
  std::vector<std::exception_ptr> errors(cases.size());
  std::atomic<std::size_t> next = 0, at_work = 0;
  std::atomic<bool> failed = false;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size() && !failed; i = next++) {
      try {
        cases[i]([&](double part) { parts[i] = part; });
        parts[i] = 1.0;
      } catch (...) {
        errors[i] = std::current_exception();
        failed = true;
      }
    }
    --at_work;
  };
  std::vector<std::jthread> workers;
  at_work = std::min(cases.size(), static_cast<std::size_t>(threads));
  for (std::size_t t = at_work; t > 0; --t) workers.emplace_back(work);
  const auto tell = [&] {
    double sum = 0.0;
    for (const std::atomic<double>& part : parts) sum += part;
    if (done && !cases.empty()) done(sum / static_cast<double>(cases.size()));
  };
  while (at_work > 0) {
    std::this_thread::sleep_for(between_looks);
    tell();
  }
  workers.clear();
  tell();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace osculate::validation
