#include "io/checksum.hpp"

#include <catch2/catch.hpp>
#include <string>

namespace osculate::io {

TEST_CASE("The checksum is CRC-64/XZ") {
  // The check value of the catalogue of parametrised CRC algorithms.
  CHECK(crc64("123456789") == 0x995DC9BBDF1939FA);
  CHECK(crc64("") == 0);
}

TEST_CASE("A checksum taken in parts is that of the whole") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += static_cast<char>(i * 37 % 251);
  for (const std::size_t cut : {0U, 1U, 7U, 8U, 500U, 1000U})
    CHECK(crc64(text.substr(cut), crc64(text.substr(0, cut))) == crc64(text));
}

}  // namespace osculate::io
