#pragma once
// Memory that is wanted soon, asked for a little at a time while something else is worked on: asked for at once it
// would hold up what is in hand, asked for where it is needed each line would be waited for.

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace osculate {

class ReadAhead {
 public:
  void clear() {
    pieces_.clear();
    next_ = end_ = nullptr;
    lines_ = piece_ = 0;
  }
  template <class T>
  void add(const T* first, std::size_t count) {
    const auto* begin = reinterpret_cast<const char*>(first);
    pieces_.push_back({begin, begin + count * sizeof(T)});
    lines_ += count * sizeof(T) / line + 1;
  }
  template <class T>
  void add(const std::vector<T>& items) {
    add(items.data(), items.size());
  }

  /// What was added is asked for while so many rows are worked on, or a few less.
  void spread_over(std::size_t rows) { pace_ = part * lines_ / std::max<std::size_t>(rows, 1) + 1; }
  /// Goes on as far as belongs to so many rows.
  void proceed(std::size_t rows) {
    for (std::size_t due = rows * pace_ / part; due > 0; --due) {
      while (next_ >= end_) {
        if (piece_ == pieces_.size()) return;
        next_ = pieces_[piece_].begin;
        end_ = pieces_[piece_++].end;
      }
      hwy::Prefetch(next_);
      next_ += line;
    }
  }

 private:
  static constexpr std::size_t line = 64, part = 16;
  struct Piece {
    const char *begin, *end;
  };
  std::vector<Piece> pieces_;
  std::size_t lines_ = 0, piece_ = 0;
  std::size_t pace_ = 0;  ///< in parts of a line per row
  const char *next_ = nullptr, *end_ = nullptr;
};

}  // namespace osculate
