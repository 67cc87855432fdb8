#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/commands.hpp"
#include "io/quantity_text.hpp"
#include "io/results_file.hpp"
#include "io/table.hpp"

namespace osculate::app {
namespace {

constexpr const char* help = R"(  osculate info settling-box/results.h5

docs/results-files.md describes the file itself. A run may still be writing it.)";

void print_shapes(const io::ResultsFile& file, const io::ParticleFrame* last) {
  std::map<std::uint32_t, std::size_t> particles;
  if (last != nullptr)
    for (const std::uint32_t shape : last->shape) ++particles[shape];
  io::Table table{{"shape", "kind", "material", "particles", "R_vol"}, {}, 3};
  for (std::uint32_t i = 0; i < file.shapes().size(); ++i) {
    const io::ResultsShape& shape = file.shapes()[i];
    const double radius = volume_equivalent_radius(mass_properties(shape.shape).volume);
    table.rows.push_back({shape.name, std::string(kind(shape.shape)), shape.material,
                          last == nullptr ? "" : fmt::format("{}", particles[i]), io::quantity_text(radius, "m")});
  }
  fmt::print("\n{}", io::to_text(table));
}

void print_walls(const io::ResultsFile& file) {
  if (file.walls().empty() && file.head().meshes.empty()) return;
  io::Table table{{"wall", "kind", "id"}, {}, 2};
  for (const io::ResultsWall& wall : file.walls())
    table.rows.push_back({wall.name, std::string(kind(wall.shape)), fmt::format("{}", wall.id)});
  for (const io::ResultsMesh& mesh : file.head().meshes)
    table.rows.push_back({mesh.name, fmt::format("mesh of {} triangles", mesh.triangles.triangles.size()),
                          fmt::format("{} and on", mesh.id)});
  fmt::print("\n{}", io::to_text(table));
}

void print_series(const io::ResultsFile& file) {
  const io::NumberTable series = file.series();
  if (series.rows() == 0) return;
  io::Table table{{"series", "first", "last"}, {}, 1};
  for (std::size_t k = 0; k < series.names.size(); ++k)
    table.rows.push_back({series.names[k], fmt::format("{:.6g}", series.columns[k].front()),
                          fmt::format("{:.6g}", series.columns[k].back())});
  fmt::print("\n{}", io::to_text(table));
}

void info(const std::string& path) {
  const io::ResultsFile file(path);
  std::vector<io::Property> lines{
      {"title", file.head().title},
      {"size", io::quantity_text(static_cast<double>(std::filesystem::file_size(path)), "B")},
      {"time step", io::quantity_text(file.head().time_step, "s")},
      {"frames", fmt::format("{}", file.frame_count())}};
  std::optional<io::ParticleFrame> last;
  if (file.frame_count() > 0) {
    last = file.frame(file.frame_count() - 1);
    lines.push_back({"from", io::quantity_text(file.frame(0).time, "s")});
    lines.push_back({"to", fmt::format("{}   step {}", io::quantity_text(last->time, "s"), last->step)});
    lines.push_back({"particles", fmt::format("{}", last->size())});
    lines.push_back({"contacts", file.has_contacts(file.frame_count() - 1)
                                     ? fmt::format("{}", file.contacts(file.frame_count() - 1).size())
                                     : "not kept"});
  }
  fmt::print("{}", io::to_text(lines));
  print_shapes(file, last ? &*last : nullptr);
  print_walls(file);
  print_series(file);
}

}  // namespace

void add_info(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "What is in a results file");
  command->footer(help);
  const auto path = std::make_shared<std::string>();
  command->add_option("RESULTS", *path, "A results file (.h5)")->required();
  command->callback([path] { info(*path); });
}

}  // namespace osculate::app
