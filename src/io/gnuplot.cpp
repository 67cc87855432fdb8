#include "io/gnuplot.hpp"

#include <fstream>

#include "io/child_program.hpp"
#include "io/scratch_folder.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {

std::string run_gnuplot(const std::string& script) {
  const ScratchFolder folder;
  const std::string input = folder.file("plot.gp");
  std::ofstream file(input, std::ios::binary);
  file << script;
  if (!file.flush()) throw InputError(input, "cannot be written", "room for temporary files, in the folder TMPDIR");
  return run({.name = "gnuplot", .needed_for = "plot", .debian_package = "gnuplot-nox"}, {input});
}

}  // namespace osculate::io
