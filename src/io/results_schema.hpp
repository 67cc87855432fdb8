#pragma once
// What writer and reader of results files agree on.

#include <cstdint>

#include "io/hdf5_columns.hpp"
#include "io/results_file.hpp"

namespace osculate::io {

inline constexpr const char* results_format = "osculate results";
inline constexpr std::uint64_t results_version = 1;

void write_head(hid_t file, const ResultsHead& head);
/// Throws std::runtime_error where something is missing or damaged.
ResultsHead read_head(hid_t file);

/// The columns of the series, empty, in their order.
void write_series_names(hid_t file, const std::vector<std::string>& names);
std::vector<std::string> read_series_names(hid_t file);

NumberTable read_series(hid_t file);

/// Frames are counted by an attribute of /frames that is written after all of a frame.
std::size_t read_frame_count(hid_t file);

}  // namespace osculate::io
