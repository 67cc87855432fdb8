#include "io/scratch_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "osculate/core/error.hpp"

namespace osculate::io {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "osculate-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw InputError(name, std::string("cannot be created (") + std::strerror(errno) + ")",
                     "a folder for temporary files, named by TMPDIR");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace osculate::io
