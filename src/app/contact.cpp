#include <memory>

#include "app/commands.hpp"
#include "app/contact_pairs.hpp"
#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

struct ContactOptions {
  PairsRequest pairs;
  bool scalar = false;
  bool warm = false;
};

}  // namespace

void add_contact(CLI::App& program) {
  CLI::App* contact = program.add_subcommand("contact", "The exact contact of two bodies, or of a table of pairs");
  const auto options = std::make_shared<ContactOptions>();
  CLI::Option* pairs = contact->add_option("--pairs", options->pairs.input, "Table of superquadric pairs");
  contact->add_option("--out", options->pairs.output, "Table of contacts to write")->needs(pairs);
  contact->add_flag("--scalar", options->scalar, "One pair after another instead of vector batches")->needs(pairs);
  contact->add_flag("--warm", options->warm, "Start each line from the answer of the same line 1e-4 away")->needs(pairs);
  contact->add_flag("--compare", options->pairs.compare, "Compare with the reference columns")->needs(pairs);
  contact->callback([options] {
    PairsRequest& request = options->pairs;
    if (request.input.empty()) throw InputError("contact", "nothing to do", "a contact file, or --pairs with a table");
    if (options->scalar) request.evaluation = Evaluation::scalar;
    if (options->warm) request.start = Start::warm;
    if (const int code = run_pairs(request); code != 0) throw CLI::RuntimeError(code);
  });
}

}  // namespace osculate::app
