#pragma once
// How HDF5 writes a file that a crash cannot spoil: what changes between two flushes reaches the file whole or not at
// all.
//
// Between flushes changed pages stay in memory. A flush first appends what lies beyond the end of the file, where
// nobody looks yet; then it writes the changed pages of the older part into a journal beside the file, with a checksum,
// and only when that is on the disk into the file itself; then it removes the journal. A whole journal found later is
// applied, one that ends early is dropped: the file was not yet touched.
// After the first flush that the file system refuses nothing more is written: the file stays as it was before.
// The file is plain HDF5. No lock is taken: others may read it meanwhile, and see the frames that were there when they
// opened it.

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace osculate::io {

/// File access properties that make HDF5 write so. The caller closes them (H5Pclose).
hid_t journaled_access();

/// The reason of the last refusal of the file system since the last call, or an empty text.
std::string take_journal_trouble();

/// Applies or drops what a crash left beside `path`. Throws InputError if the file system refuses.
void apply_journal(const std::filesystem::path& path);

/// Where the journal of a file stands while there is one.
std::filesystem::path journal_path(const std::filesystem::path& path);

}  // namespace osculate::io
