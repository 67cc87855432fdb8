#include "io/gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

/// A folder that is gone, with all that is in it, when this is.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "osculate-plot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw InputError(name, std::string("cannot be created (") + std::strerror(errno) + ")",
                       "a folder for temporary files, named by TMPDIR");
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const ScratchFolder folder;
  std::string input = folder.file("plot.gp");
  const std::string output = folder.file("output"), messages = folder.file("messages");
  {
    std::ofstream file(input, std::ios::binary);
    file << script;
    if (!file.flush()) throw InputError(input, "cannot be written", "room for temporary files, in the folder TMPDIR");
  }
  std::string program = "gnuplot";
  char* const arguments[] = {program.data(), input.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t process = 0;
  const int trouble = ::posix_spawnp(&process, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (trouble != 0)
    throw InputError("plot", std::string("gnuplot cannot be run (") + std::strerror(trouble) + ")",
                     "the program gnuplot on the PATH (Debian: apt-get install gnuplot-nox)");
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waiting for gnuplot");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("gnuplot failed: " + content(messages));
  return content(output);
}

}  // namespace osculate::io
