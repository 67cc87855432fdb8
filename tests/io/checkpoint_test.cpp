#include "io/checkpoint.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "osculate/core/error.hpp"
#include "temporary.hpp"

namespace osculate::io {
namespace {

using test::fresh_folder;

Checkpoint checkpoint_of(std::uint64_t frames) {
  return {.scene = 0x123456789ABCDEF0,
          .frames = frames,
          .rows = 7 * frames,
          .state = {{{"positions", std::vector<double>{0.1, -0.0, 1e-310, 3.0}},
                     {"pairs", std::vector<std::int32_t>{-1, 2}},
                     {"none", std::vector<double>{}},
                     {"steps", std::vector<std::uint64_t>{~0ULL}}}}};
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("A checkpoint gives back what it was made of") {
  const auto folder = fresh_folder("checkpoint");
  CHECK_FALSE(find_checkpoint(folder).has_value());
  write_checkpoint(folder, checkpoint_of(3));
  const auto found = find_checkpoint(folder);
  REQUIRE(found.has_value());
  CHECK(found->complaints.empty());
  CHECK(found->checkpoint.scene == 0x123456789ABCDEF0);
  CHECK(found->checkpoint.frames == 3);
  CHECK(found->checkpoint.rows == 21);
  REQUIRE(found->checkpoint.state.arrays.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(found->checkpoint.state.arrays[i].name == checkpoint_of(3).state.arrays[i].name);
    CHECK(found->checkpoint.state.arrays[i].values == checkpoint_of(3).state.arrays[i].values);
  }
}

TEST_CASE("A damaged checkpoint is told, and the one before it serves") {
  const auto folder = fresh_folder("checkpoint");
  write_checkpoint(folder, checkpoint_of(1));
  write_checkpoint(folder, checkpoint_of(2));
  const std::string sound = bytes_of(checkpoint_path(folder));
  const auto put = [&](const std::string& bytes) { std::ofstream(checkpoint_path(folder), std::ios::binary) << bytes; };
  // Every single byte counts, and so does the length.
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string damaged = sound;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    put(damaged);
    CHECK_THROWS_AS(read_checkpoint(checkpoint_path(folder)), InputError);
  }
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, std::size_t{30}, sound.size() - 1}) {
    put(sound.substr(0, length));
    const auto found = find_checkpoint(folder);
    REQUIRE(found.has_value());
    CHECK(found->checkpoint.frames == 1);
    REQUIRE(found->complaints.size() == 1);
    CHECK_THAT(found->complaints[0], Catch::Contains("checkpoint.bin"));
  }
  std::filesystem::copy_file(checkpoint_path(folder), earlier_checkpoint_path(folder),
                             std::filesystem::copy_options::overwrite_existing);
  CHECK_THROWS_WITH(find_checkpoint(folder), Catch::Contains("no sound checkpoint"));
}

TEST_CASE("A kill between the two renames of a checkpoint loses nothing") {
  const auto folder = fresh_folder("checkpoint");
  write_checkpoint(folder, checkpoint_of(1));
  write_checkpoint(folder, checkpoint_of(2));
  std::filesystem::rename(checkpoint_path(folder), folder / "checkpoint.new.bin");
  CHECK(find_checkpoint(folder)->checkpoint.frames == 2);
}

TEST_CASE("A checkpoint that cannot be written leaves the earlier ones") {
  CHECK_THROWS_AS(write_checkpoint("/proc/nowhere", checkpoint_of(1)), InputError);
}

}  // namespace osculate::io
