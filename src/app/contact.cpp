#include <fmt/core.h>

#include <memory>

#include "app/commands.hpp"
#include "app/contact_analysis.hpp"
#include "app/contact_pairs.hpp"
#include "app/contact_picture.hpp"
#include "io/contact_file.hpp"
#include "io/pair_table.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

struct ContactOptions {
  std::string file;
  std::string picture;
  bool json = false;
  PairsRequest pairs;
  bool scalar = false;
  bool warm = false;
};

std::string help_text() {
  std::string columns;
  for (const std::string_view column : io::pair_columns) {
    columns += columns.empty() ? "  " : column == "a2" ? ",\n  " : ",";
    columns += column;
  }
  return std::string(
             "Examples:\n"
             "  osculate contact examples/contacts/two-ellipsoids.toml\n"
             "  osculate contact examples/contacts/rice-on-floor.toml --json --picture rice.png\n"
             "  osculate contact --pairs pairs.csv --out contacts.csv\n"
             "  osculate contact --pairs tests/data/superquadric_common_normal.csv --compare --warm\n\n"
             "Keys of a contact file (TOML; docs/contact-files.md tells more):\n") +
         io::contact_file_keys() +
         "\n\nColumns of a table of pairs, named in its first line, in any order; others are ignored:\n" + columns +
         "\n  half-axes and centres [m], exponents n1 (z) and n2 (x, y), unit quaternions (body to world)\n"
         "Columns written:\n"
         "  status,nx,ny,nz,depth,p1x,p1y,p1z,p2x,p2y,p2z,k1max,k1min,k2max,k2min,Ri,Rj";
}

void run_contact(const ContactOptions& options) {
  const ContactAnalysis analysis = analyse(io::read_contact_file(options.file));
  fmt::print("{}", options.json ? to_json(analysis) : to_text(analysis));
  if (!options.picture.empty()) write_contact_picture(analysis, options.picture);
}

void run_table(const ContactOptions& options) {
  PairsRequest request = options.pairs;
  if (options.scalar) request.evaluation = Evaluation::scalar;
  if (options.warm) request.start = Start::warm;
  if (const int code = run_pairs(request); code != 0) throw CLI::RuntimeError(code);
}

}  // namespace

void add_contact(CLI::App& program) {
  CLI::App* contact = program.add_subcommand("contact", "The exact contact of two bodies, or of a table of pairs");
  contact->footer(help_text);
  const auto options = std::make_shared<ContactOptions>();
  CLI::Option* file = contact->add_option("file", options->file, "Contact file: two shapes, poses and materials");
  contact->add_flag("--json", options->json, "Print every number as JSON")->needs(file);
  contact->add_option("--picture", options->picture, "Picture to write (PNG): bodies, normal, points, contact ellipse")
      ->needs(file);
  CLI::Option* pairs = contact->add_option("--pairs", options->pairs.input, "Table of superquadric pairs (CSV)");
  pairs->excludes(file);
  contact->add_option("--out", options->pairs.output, "Table of contacts to write (CSV)")->needs(pairs);
  contact->add_flag("--scalar", options->scalar, "One pair after another instead of vector batches")->needs(pairs);
  contact->add_flag("--warm", options->warm, "Start each line from its own answer at a pose 1e-4 away")->needs(pairs);
  contact
      ->add_flag("--compare", options->pairs.compare,
                 "Print the worst differences from the reference columns; exit code 1 when a bar is missed")
      ->needs(pairs);
  contact->callback([options] {
    if (!options->pairs.input.empty()) return run_table(*options);
    if (options->file.empty()) throw InputError("contact", "nothing to do", "a contact file, or --pairs with a table");
    run_contact(*options);
  });
}

}  // namespace osculate::app
