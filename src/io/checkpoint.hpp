#pragma once
// Checkpoints: from one, a run goes on bit by bit. The newest two are kept, each written whole or not at all and told
// sound by a checksum.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "osculate/dynamics/state.hpp"

namespace osculate::io {

struct Checkpoint {
  std::uint64_t scene = 0;   ///< crc64 of the scene file's text
  std::uint64_t frames = 0;  ///< in the results so far
  std::uint64_t rows = 0;    ///< of the series so far
  State state;
};

/// Where a folder's checkpoints stand: the newest, and the one before it.
std::filesystem::path checkpoint_path(const std::filesystem::path& folder);
std::filesystem::path earlier_checkpoint_path(const std::filesystem::path& folder);

/// Throws InputError if it cannot be written; the checkpoints that were there stay.
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// Throws InputError if there is one that cannot be removed.
void remove_checkpoints(const std::filesystem::path& folder);

/// The newest sound checkpoint, and what is wrong with a newer one.
struct FoundCheckpoint {
  Checkpoint checkpoint;
  std::vector<std::string> complaints;
};
/// Nothing if the folder has no checkpoint; throws InputError if none of those it has is sound.
std::optional<FoundCheckpoint> find_checkpoint(const std::filesystem::path& folder);

/// Throws InputError, saying how the file is damaged.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace osculate::io
