#pragma once
// CRC-64 of ECMA-182, reflected ("CRC-64/XZ"): tells a damaged file from a sound one.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace osculate::io {

/// Of `bytes`, going on from the checksum of what stands before them (0 for nothing).
std::uint64_t crc64(std::string_view bytes, std::uint64_t before = 0);

}  // namespace osculate::io
