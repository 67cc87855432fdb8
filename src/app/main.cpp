#include <fmt/core.h>

#include <exception>

#include "app/commands.hpp"
#include "osculate/core/error.hpp"

int main(int argc, char** argv) {
  CLI::App program{"Osculate: contact mechanics and the discrete element method of non-spherical particles"};
  program.name("osculate");
  program.require_subcommand(1);
  osculate::app::add_shape(program);
  osculate::app::add_validate(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error);
  } catch (const osculate::InputError& error) {
    fmt::print(stderr, "osculate: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "osculate: internal error: {}\n", error.what());
    return 3;
  }
  return 0;
}
