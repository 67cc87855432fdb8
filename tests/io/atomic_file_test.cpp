#include "io/atomic_file.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "osculate/core/error.hpp"
#include "temporary.hpp"

namespace {

using osculate::io::AtomicFile;
using osculate::test::fresh_folder;

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

}  // namespace

TEST_CASE("A file that is given up leaves the old content and nothing else") {
  const auto folder = fresh_folder("atomic_file_test");
  const auto path = folder / "answer.csv";
  osculate::io::write_atomically(path.string(), "old\n");
  {
    AtomicFile file(path.string());
    file.write("half a li");
  }
  CHECK(content(path) == "old\n");
  CHECK(files_in(folder) == 1);
}

TEST_CASE("A committed file replaces the old content and can be read by whoever may read new files") {
  const auto folder = fresh_folder("atomic_file_test");
  const auto path = folder / "answer.csv";
  osculate::io::write_atomically(path.string(), "old\n");
  AtomicFile file(path.string());
  file.write("new\n");
  CHECK(content(path) == "old\n");
  file.commit();
  CHECK(content(path) == "new\n");
  CHECK(files_in(folder) == 1);

  std::ofstream(folder / "ordinary") << "x";
  CHECK(std::filesystem::status(path).permissions() == std::filesystem::status(folder / "ordinary").permissions());
}

TEST_CASE("A link stays a link: the file it points to is replaced") {
  const auto folder = fresh_folder("atomic_file_test");
  osculate::io::write_atomically((folder / "real.csv").string(), "old\n");
  std::filesystem::create_symlink("real.csv", folder / "link.csv");
  osculate::io::write_atomically((folder / "link.csv").string(), "new\n");
  CHECK(std::filesystem::is_symlink(folder / "link.csv"));
  CHECK(content(folder / "real.csv") == "new\n");
  CHECK(files_in(folder) == 2);
}

TEST_CASE("A pipe is written to and stays a pipe") {
  const auto pipe = fresh_folder("atomic_file_test") / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  // Open for reading and writing, so that neither end waits for the other.
  std::fstream reader(pipe);
  osculate::io::write_atomically(pipe.string(), "through\n");
  std::string line;
  std::getline(reader, line);
  CHECK(line == "through");
  CHECK(std::filesystem::is_fifo(pipe));
}

TEST_CASE("A place where no file can be written is an input error that names it") {
  const auto folder = fresh_folder("atomic_file_test");
  CHECK_THROWS_WITH(AtomicFile((folder / "no_such_folder" / "x.csv").string()),
                    Catch::Contains("no_such_folder/x.csv") && Catch::Contains("No such file or directory"));
  CHECK_THROWS_WITH(AtomicFile(folder.string()), Catch::Contains("directory"));
}
