#include "io/checksum.hpp"

#include <array>

namespace osculate::io {
namespace {

constexpr std::size_t slices = 8;
using Table = std::array<std::array<std::uint64_t, 256>, slices>;

constexpr Table make_table() {
  constexpr std::uint64_t polynomial = 0xC96C5795D7870F42;  // 0x42F0E1EBA9EA3693 with its bits reversed
  Table table{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    std::uint64_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1U) ^ ((value & 1U) != 0 ? polynomial : 0);
    table[0][byte] = value;
  }
  for (std::size_t slice = 1; slice < slices; ++slice)
    for (std::size_t byte = 0; byte < 256; ++byte)
      table[slice][byte] = (table[slice - 1][byte] >> 8U) ^ table[0][table[slice - 1][byte] & 0xFFU];
  return table;
}
constexpr Table table = make_table();

std::uint64_t octet(std::string_view bytes, std::size_t i) {
  return static_cast<unsigned char>(bytes[i]);
}

}  // namespace

std::uint64_t crc64(std::string_view bytes, std::uint64_t before) {
  std::uint64_t crc = ~before;
  std::size_t i = 0;
  // Eight bytes at a time: checkpoints are large.
  for (; i + slices <= bytes.size(); i += slices) {
    std::uint64_t next = 0;
    for (std::size_t k = 0; k < slices; ++k)
      next ^= table[slices - 1 - k][((crc >> (8 * k)) ^ octet(bytes, i + k)) & 0xFFU];
    crc = next;
  }
  for (; i < bytes.size(); ++i) crc = (crc >> 8U) ^ table[0][(crc ^ octet(bytes, i)) & 0xFFU];
  return ~crc;
}

}  // namespace osculate::io
