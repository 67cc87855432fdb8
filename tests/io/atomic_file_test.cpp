#include "io/atomic_file.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "osculate/core/error.hpp"

namespace {

using osculate::io::AtomicFile;

std::filesystem::path fresh_folder() {
  const auto folder = std::filesystem::temp_directory_path() / "osculate_atomic_file_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

}  // namespace

TEST_CASE("A file that is given up leaves the old content and nothing else") {
  const auto folder = fresh_folder();
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
  const auto folder = fresh_folder();
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

TEST_CASE("A place where no file can be written is an input error that names it") {
  const auto folder = fresh_folder();
  CHECK_THROWS_WITH(AtomicFile((folder / "no_such_folder" / "x.csv").string()),
                    Catch::Contains("no_such_folder/x.csv") && Catch::Contains("No such file or directory"));
  CHECK_THROWS_WITH(AtomicFile(folder.string()), Catch::Contains("directory"));
}
