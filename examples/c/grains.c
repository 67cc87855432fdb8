/* Osculate in a C program: two grains on a floor, their contacts and forces over a few time steps.
 *   make && ./grains        (PKG_CONFIG_PATH: where osculate.pc is) */
#include <math.h>
#include <osculate/osculate.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { bodies = 3, pairs = 3, steps = 3 };

static void check(int error) {
  if (error == OSCULATE_OK) return;
  fprintf(stderr, "%s\n", osculate_error_message());
  exit(EXIT_FAILURE);
}

/* Component c of a x b. */
static double cross(const double a[3], const double b[3], int c) {
  return a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

int main(void) {
  if (osculate_abi_version() != OSCULATE_ABI_VERSION) {
    fprintf(stderr, "compiled for another libosculate_c\n");
    return EXIT_FAILURE;
  }

  /* Bodies: a floor, a blocky grain that lies on it, an ellipsoid that slides and rolls over the grain. */
  const double blocky_axes[3] = {5e-3, 3e-3, 2e-3}, ellipsoid_axes[3] = {4e-3, 3e-3, 2.5e-3}; /* [m] */
  osculate_shape *floor_shape, *blocky, *ellipsoid;
  check(osculate_new_half_space(&floor_shape));
  check(osculate_new_superquadric(blocky_axes, 2.5, 3.0, &blocky));
  check(osculate_new_ellipsoid(ellipsoid_axes, &ellipsoid));
  const osculate_shape* shape[bodies] = {floor_shape, blocky, ellipsoid};
  const double mass[bodies] = {INFINITY, 4e-4, 3e-4};                                     /* [kg] */
  double x[3][bodies] = {{0.0, 0.0, 2e-3}, {0.0, 0.0, 1e-3}, {0.0, 2.703e-3, 7.6662e-3}}; /* [m] */
  const double v[3][bodies] = {{0.0, 0.0, 0.05}, {0.0, 0.0, 0.02}, {0.0, 0.0, -0.01}};    /* [m/s] */
  const double w[3][bodies] = {{0.0, 1.0, 0.0}, {0.0, 2.0, 10.0}, {0.0, -1.0, 5.0}};      /* [rad/s] */
  const double q[4][bodies] = {{1.0, 0.9822618062296308, 0.8660254037844386},             /* w, x, y, z */
                               {0.0, 0.10023079655404396, 0.0},
                               {0.0, 0.15034619483106593, 0.5},
                               {0.0, 0.05011539827702198, 0.0}};
  const osculate_bodies placed = {bodies, shape, {x[0], x[1], x[2]}, {q[0], q[1], q[2], q[3]}};

  /* The law by the names of its parts, bound to the materials of both bodies. */
  const osculate_material glass = {71e9, 0.22};
  const osculate_law_setting parts[] = {
      {"hertz", NULL, 0.0}, {"tsuji", "restitution", 0.8}, {"mindlin", "friction", 0.4}};
  osculate_law* law;
  check(osculate_new_law(sizeof parts / sizeof *parts, parts, &glass, &glass, &law));

  /* Pairs that may touch, and what each of them remembers: zeros at first. A pair that leaves the list takes its bytes
   * with it, one that comes brings zeros. */
  const int32_t body_1[pairs] = {0, 1, 0}, body_2[pairs] = {1, 2, 2};
  void* const caches = calloc(pairs, osculate_cache_size());
  void* const memories = calloc(pairs, osculate_memory_size(law));

  /* Columns: what contacts say goes to the law as it is. */
  int32_t status[pairs], law_status[pairs];
  double normal[3][pairs], overlap[pairs], on_1[3][pairs], on_2[3][pairs], R_i[pairs], R_j[pairs], major[3][pairs];
  double velocity[3][pairs], rotation[3][pairs], reduced_mass[pairs], force[3][pairs], normal_force[pairs];
  const osculate_contact_columns contacts = {.status = status,
                                             .normal = {normal[0], normal[1], normal[2]},
                                             .overlap = overlap,
                                             .on_1 = {on_1[0], on_1[1], on_1[2]},
                                             .on_2 = {on_2[0], on_2[1], on_2[2]},
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

  double body_force[bodies][3], torque[bodies][3];
  for (int step = 0; step < steps; ++step) {
    check(osculate_find_contacts(&placed, pairs, body_1, body_2, OSCULATE_GAP_SKIP, caches, &contacts));

    double arm_1[pairs][3], arm_2[pairs][3];
    for (int k = 0; k < pairs; ++k) {
      const int i = body_1[k], j = body_2[k];
      const double w_i[3] = {w[0][i], w[1][i], w[2][i]}, w_j[3] = {w[0][j], w[1][j], w[2][j]};
      for (int c = 0; c < 3; ++c) {
        const double point = 0.5 * (on_1[c][k] + on_2[c][k]);
        arm_1[k][c] = point - x[c][i], arm_2[k][c] = point - x[c][j];
      }
      for (int c = 0; c < 3; ++c) {
        velocity[c][k] = v[c][j] + cross(w_j, arm_2[k], c) - v[c][i] - cross(w_i, arm_1[k], c);
        rotation[c][k] = 0.5 * (w_i[c] + w_j[c]);
      }
      reduced_mass[k] = 1.0 / (1.0 / mass[i] + 1.0 / mass[j]);
    }
    check(osculate_evaluate_forces(law, &approach, memories, &forces));

    memset(body_force, 0, sizeof body_force);
    memset(torque, 0, sizeof torque);
    for (int k = 0; k < pairs; ++k) {
      const int i = body_1[k], j = body_2[k];
      const double on_i[3] = {force[0][k], force[1][k], force[2][k]};
      for (int c = 0; c < 3; ++c) {
        body_force[i][c] += on_i[c], torque[i][c] += cross(arm_1[k], on_i, c);
        body_force[j][c] -= on_i[c], torque[j][c] -= cross(arm_2[k], on_i, c);
      }
    }

    /* Here a host moves its bodies by its own integrator; these go on as they go. */
    for (int c = 0; c < 3; ++c)
      for (int i = 0; i < bodies; ++i) x[c][i] += v[c][i] * approach.time_step;
  }

  for (int k = 0; k < pairs; ++k) {
    if (status[k] != OSCULATE_TOUCHING) continue;
    printf("contact %d %d %.16e %.16e %.16e %.16e %.16e %.16e %.16e %.16e %.16e\n", (int)body_1[k], (int)body_2[k],
           normal[0][k], normal[1][k], normal[2][k], overlap[k], R_i[k], R_j[k], force[0][k], force[1][k], force[2][k]);
  }
  for (int i = 1; i < bodies; ++i)
    printf("body %d %.16e %.16e %.16e %.16e %.16e %.16e\n", i, body_force[i][0], body_force[i][1], body_force[i][2],
           torque[i][0], torque[i][1], torque[i][2]);

  free(memories);
  free(caches);
  osculate_free_law(law);
  osculate_free_shape(ellipsoid);
  osculate_free_shape(blocky);
  osculate_free_shape(floor_shape);
  return EXIT_SUCCESS;
}
