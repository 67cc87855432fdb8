#include <cstdio>
#include <exception>
#include <string_view>

#include "app/commands.hpp"
#include "app/huge_pages.hpp"
#include "osculate/core/error.hpp"

namespace {

constexpr const char* introduction =
    R"(Osculate: contact mechanics and the discrete element method of non-spherical particles.

Two convex bodies that touch share a common normal. Osculate finds it exactly, with the overlap, the points of both
surfaces and their principal curvatures there, and from these the elliptical contact of Hertz: force, contact ellipse,
pressure, stiffness. Bodies are superquadrics (grains, tablets, boxes, cylinders with rounded edges), potential
particles (rounded polyhedra) and walls.
)";

constexpr const char* first_steps =
    R"(First steps:
  osculate shape rice --picture rice.png                   a shape of the catalogue in numbers and as a picture
  osculate contact examples/contacts/two-ellipsoids.toml   two shapes, poses and materials: their contact in full
  osculate contact --pairs pairs.csv --out contacts.csv    a table of superquadric pairs
  osculate law mindlin --set friction=0.3 --picture loop.png   a law of contact, along a cycle of slip
  osculate run examples/scenes/settling-box.toml           a scene: particles, walls, laws; results as HDF5 and CSV
  mpirun -n 4 osculate run SCENE.toml --engine lammps      a scene on LAMMPS, over MPI
  osculate render results.h5 --animation run.mp4           pictures and a film of a simulation, without a display
  osculate export results.h5 --paraview run.pvd            its particles for ParaView, or OVITO
  osculate review --html review                            the review's tables and figures anew, on one page
  osculate validate curvature                              curvatures against jets fitted to the surface
  osculate validate narrow                                 random and nasty pairs through the narrow phase, checked
  osculate validate impact                                 single impacts through the engine, against closed forms
  osculate validate flow --picture flow.png                a hopper's discharge and angles of repose, against trends
  osculate study halfspace                                 where two radii of curvature are not enough
  osculate study curvature                                 what one radius a body costs
  osculate bench narrow                                    what a contact costs on this machine
  osculate bench laws                                      what its force law costs
  osculate bench scenes                                    what a step of particles at rest costs

`osculate COMMAND --help` explains a command and the files it reads.
Exit codes: 0 done, 1 a comparison missed its bar, 2 wrong input (the message says where), 3 an internal error.)";

int run(int argc, char** argv) {
  CLI::App program{introduction};
  program.name("osculate");
  program.footer(first_steps);
  program.require_subcommand(1);
  osculate::app::add_contact(program);
  osculate::app::add_shape(program);
  osculate::app::add_law(program);
  osculate::app::add_run(program);
  osculate::app::add_check(program);
  osculate::app::add_info(program);
  osculate::app::add_render(program);
  osculate::app::add_export(program);
  osculate::app::add_review(program);
  osculate::app::add_validate(program);
  osculate::app::add_study(program);
  osculate::app::add_bench(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (const std::string_view command = argc > 1 ? argv[1] : ""; command == "run" || command == "bench")
    osculate::app::use_huge_pages(argv);
  try {
    return run(argc, argv);
  } catch (const osculate::InputError& error) {
    std::fprintf(stderr, "osculate: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "osculate: internal error: %s\n", error.what());
    return 3;
  }
}
