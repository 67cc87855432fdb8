/* Osculate in a C program: two grains on a floor, their contacts and forces over a few time steps.
 *   make && ./grains        (PKG_CONFIG_PATH: where osculate.pc is) */
#include <math.h>
#include <osculate/osculate.h>
#include <stdio.h>
#include <stdlib.h>

enum { bodies = 3, pairs = 3, steps = 3 };

static void check(int error) {
  if (error == OSCULATE_OK) return;
  fprintf(stderr, "%s\n", osculate_error_message());
  exit(EXIT_FAILURE);
}

int main(void) {
  if (osculate_abi_version() != OSCULATE_ABI_VERSION) {
    fprintf(stderr, "compiled for another libosculate_c\n");
    return EXIT_FAILURE;
  }

  /* Bodies: a floor, a blocky grain that lies on it, an ellipsoid that slides over the grain. */
  const double blocky_axes[3] = {5e-3, 3e-3, 2e-3}, ellipsoid_axes[3] = {4e-3, 3e-3, 2.5e-3}; /* [m] */
  osculate_shape *floor_shape, *blocky, *ellipsoid;
  check(osculate_new_half_space(&floor_shape));
  check(osculate_new_superquadric(blocky_axes, 2.5, 3.0, &blocky));
  check(osculate_new_ellipsoid(ellipsoid_axes, &ellipsoid));
  const osculate_shape* shape[bodies] = {floor_shape, blocky, ellipsoid};
  double x[bodies] = {0.0, 0.0, 2e-3}, y[bodies] = {0.0, 0.0, 1e-3}, z[bodies] = {0.0, 2.703e-3, 7.6662e-3};
  const double qw[bodies] = {1.0, 0.9822618062296308, 0.8660254037844386}, qx[bodies] = {0.0, 0.10023079655404396, 0.0},
               qy[bodies] = {0.0, 0.15034619483106593, 0.5}, qz[bodies] = {0.0, 0.05011539827702198, 0.0};
  const double mass[bodies] = {INFINITY, 4e-4, 3e-4}; /* [kg] */
  const double vx[bodies] = {0.0, 0.0, 0.05}, vy[bodies] = {0.0, 0.0, 0.02}, vz[bodies] = {0.0, 0.0, -0.01};
  const osculate_bodies placed = {bodies, shape, {x, y, z}, {qw, qx, qy, qz}};

  /* The law by the names of its parts, bound to the materials of both bodies. */
  const osculate_material glass = {71e9, 0.22};
  const osculate_law_setting parts[] = {
      {"hertz", NULL, 0.0}, {"tsuji", "restitution", 0.8}, {"mindlin", "friction", 0.4}};
  osculate_law* law;
  check(osculate_new_law(sizeof parts / sizeof *parts, parts, &glass, &glass, &law));

  /* Pairs that may touch, and what each of them remembers: zeros at first. */
  const int32_t body_1[pairs] = {0, 1, 0}, body_2[pairs] = {1, 2, 2};
  void* const caches = calloc(pairs, osculate_cache_size());
  void* const memories = calloc(pairs, osculate_memory_size(law));

  int32_t status[pairs], law_status[pairs];
  double normal[3][pairs], overlap[pairs], R_i[pairs], R_j[pairs], major[3][pairs];
  double velocity[3][pairs], rotation[3][pairs], reduced_mass[pairs], force[3][pairs], normal_force[pairs];
  const osculate_contact_columns contacts = {.status = status,
                                             .normal = {normal[0], normal[1], normal[2]},
                                             .overlap = overlap,
                                             .R_i = R_i,
                                             .R_j = R_j,
                                             .major_axis = {major[0], major[1], major[2]}};
  const osculate_approach_columns approach = {.size = pairs,
                                              .R_i = R_i,
                                              .R_j = R_j,
                                              .overlap = overlap,
                                              .normal = {normal[0], normal[1], normal[2]},
                                              .major_axis = {major[0], major[1], major[2]},
                                              .velocity = {velocity[0], velocity[1], velocity[2]},
                                              .mean_angular_velocity = {rotation[0], rotation[1], rotation[2]},
                                              .reduced_mass = reduced_mass,
                                              .time_step = 1e-6};
  const osculate_force_columns forces = {
      .status = law_status, .force = {force[0], force[1], force[2]}, .normal_force = normal_force};

  for (int step = 0; step < steps; ++step) {
    check(osculate_find_contacts(&placed, pairs, body_1, body_2, OSCULATE_GAP_SKIP, caches, &contacts));
    for (int k = 0; k < pairs; ++k) {
      const int i = body_1[k], j = body_2[k];
      /* Nothing rotates here; otherwise omega x arm is added for both bodies. */
      velocity[0][k] = vx[j] - vx[i], velocity[1][k] = vy[j] - vy[i], velocity[2][k] = vz[j] - vz[i];
      rotation[0][k] = rotation[1][k] = rotation[2][k] = 0.0;
      reduced_mass[k] = 1.0 / (1.0 / mass[i] + 1.0 / mass[j]);
    }
    check(osculate_evaluate_forces(law, &approach, memories, &forces));
    for (int i = 0; i < bodies; ++i) {
      x[i] += vx[i] * approach.time_step, y[i] += vy[i] * approach.time_step, z[i] += vz[i] * approach.time_step;
    }
  }

  for (int k = 0; k < pairs; ++k) {
    if (status[k] != OSCULATE_TOUCHING) continue;
    printf("%d %d %.16e %.16e %.16e %.16e %.16e %.16e %.16e %.16e %.16e\n", (int)body_1[k], (int)body_2[k],
           normal[0][k], normal[1][k], normal[2][k], overlap[k], R_i[k], R_j[k], force[0][k], force[1][k], force[2][k]);
  }

  free(memories);
  free(caches);
  osculate_free_law(law);
  osculate_free_shape(ellipsoid);
  osculate_free_shape(blocky);
  osculate_free_shape(floor_shape);
  return EXIT_SUCCESS;
}
