#ifndef OSCULATE_OSCULATE_H
#define OSCULATE_OSCULATE_H
/**
 * @file
 * Osculate from C (C99) and from every language that can call C; src/fortran/osculate.f90 is the same in Fortran.
 *
 * Shapes and laws are made once, behind opaque handles; contacts and forces are evaluated one at a time or in columns.
 * What a contact remembers is the caller's: bytes that may be copied, moved, stored and sent like any others.
 *
 * - SI units, right-handed frames; normals point from body 1 to body 2; indices count from 0.
 * - Every function that can fail returns an error code, OSCULATE_OK = 0 when it did not; osculate_error_message() says
 *   what was wrong, where, and what was expected.
 * - A pointer may be NULL only where its description says so.
 * - Handles do not change once they are made: any number of threads may use one. Calls that write to the same memory
 *   must not run at once.
 */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define OSCULATE_API __attribute__((visibility("default")))
#else
#define OSCULATE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** Changes whenever a compiled host would have to be compiled again. */
#define OSCULATE_ABI_VERSION 1

/** The ABI version of the library that is running: compare it with OSCULATE_ABI_VERSION. */
OSCULATE_API int osculate_abi_version(void);

/** The release, "0.1.0". */
OSCULATE_API const char* osculate_version(void);

/** What a function returns. */
enum {
  OSCULATE_OK = 0,
  OSCULATE_NULL_POINTER = 1,  /**< a pointer that is needed is NULL */
  OSCULATE_INVALID_INPUT = 2, /**< a number, name or index out of its range, or not finite */
  OSCULATE_OUT_OF_MEMORY = 3,
  OSCULATE_INTERNAL_ERROR = 4 /**< a fault of the library: please report it */
};

/** What the last failing call of this thread found, in one line of at most 1023 bytes; "" if none has failed. Valid
 * until the thread's next failing call. */
OSCULATE_API const char* osculate_error_message(void);

/* ---- Shapes ------------------------------------------------------------------------------------------------------ */

/** A body's shape in its own frame. */
typedef struct osculate_shape osculate_shape;

/** On which side of its surface a cylinder is solid. */
enum {
  OSCULATE_SOLID_INSIDE = 0, /**< a rod: particles are outside */
  OSCULATE_SOLID_OUTSIDE = 1 /**< a drum: particles are inside */
};

/** Sphere of a radius > 0 [m]. `*shape` is set only on success, here and below. */
OSCULATE_API int osculate_new_sphere(double radius, osculate_shape** shape);

/** Ellipsoid of half-axes a, b, c > 0 [m]. */
OSCULATE_API int osculate_new_ellipsoid(const double half_axes[3], osculate_shape** shape);

/** Superquadric (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 of half-axes a, b, c > 0 [m] and exponents in
 * (1, 64]. */
OSCULATE_API int osculate_new_superquadric(const double half_axes[3], double n1, double n2, osculate_shape** shape);

/** Potential particle: a rounded convex polyhedron of `planes` face planes around the origin. [Houlsby09]
 * @param normals        outward unit normals, x, y, z of one plane after another
 * @param distances      of the planes from the origin, > 0 [m]
 * @param sphericity     k in (0, 1]; 1 is the sphere
 * @param edge_radius    r > 0 [m]
 * @param sphere_radius  R > 0 [m], of the sphere that is blended in */
OSCULATE_API int osculate_new_potential_particle(size_t planes, const double* normals, const double* distances,
                                                 double sphericity, double edge_radius, double sphere_radius,
                                                 osculate_shape** shape);

/** Wall: solid z <= 0 of its frame. */
OSCULATE_API int osculate_new_half_space(osculate_shape** shape);

/** Wall: infinite circular cylinder about z of its frame.
 * @param radius  > 0 [m]
 * @param solid   OSCULATE_SOLID_INSIDE or OSCULATE_SOLID_OUTSIDE */
OSCULATE_API int osculate_new_cylinder(double radius, int solid, osculate_shape** shape);

/** Wall: the solid outside a sphere of a radius > 0 [m]. */
OSCULATE_API int osculate_new_sphere_container(double radius, osculate_shape** shape);

/** Frees a shape; NULL is allowed. No osculate_bodies may refer to it any more. */
OSCULATE_API void osculate_free_shape(osculate_shape* shape);

/** Radius of a sphere about the frame's origin that holds the body [m]; infinite for walls. */
OSCULATE_API int osculate_bounding_radius(const osculate_shape* shape, double* radius);

/** Volume [m^3], centroid [m] in the body's frame, and inertia about it for unit density [m^5], row by row. Not for
 * walls. Pointers to what is not wanted may be NULL. A potential particle takes a quarter of a second. */
OSCULATE_API int osculate_mass_properties(const osculate_shape* shape, double* volume, double centroid[3],
                                          double inertia[9]);

/* ---- Contacts ---------------------------------------------------------------------------------------------------- */

/** Where a body is: x_world = orientation * x_body + position. */
typedef struct osculate_pose {
  double position[3];    /**< [m] */
  double orientation[4]; /**< w, x, y, z of a quaternion, body to world, of unit length to 1e-6 */
} osculate_pose;

/** What is known of a contact. */
enum {
  OSCULATE_TOUCHING = 0,      /**< overlap >= 0 */
  OSCULATE_SEPARATED = 1,     /**< overlap < 0: a gap */
  OSCULATE_AMBIGUOUS = 2,     /**< another common normal is as good within round-off: only the overlap is meaningful */
  OSCULATE_FLAT = 3,          /**< the bodies meet over a flat set: the point is its centre as nearly as can be */
  OSCULATE_NOT_CONVERGED = 4, /**< the normal is the best found, the overlap an upper bound of the true one */
  OSCULATE_DEGENERATE = 5     /**< no answer exists, for instance of numbers that overflow: every number is 0 */
};

/** How far to go when the bodies do not touch. */
enum {
  OSCULATE_GAP_RESOLVE = 0, /**< find the common normal and the gap */
  OSCULATE_GAP_SKIP = 1 /**< stop at the first proof of a gap: `overlap` is minus a lower bound of it, the normal the
                             direction that proves it; points, curvatures and radii are 0 unless they were found */
};

/** Bytes of the cache that the caller keeps beside a pair so that its next contact is found faster. All zero is a new
 * pair. It holds for the same two shapes in the same order. Any alignment will do. */
OSCULATE_API size_t osculate_cache_size(void);

/** One contact between two convex bodies. World frame. */
typedef struct osculate_contact {
  int32_t status;        /**< OSCULATE_TOUCHING, ... */
  double normal[3];      /**< unit, from body 1 to body 2 */
  double overlap;        /**< (on_1 - on_2) along the normal [m]; negative is a gap */
  double on_1[3];        /**< body 1's surface point with outward normal `normal` [m] */
  double on_2[3];        /**< body 2's surface point with outward normal -`normal` [m]; contact point: their mean */
  double curvature_1[2]; /**< principal curvatures of body 1 there, the larger one first, > 0 where convex [1/m] */
  double direction_1[3]; /**< unit tangent of body 1's larger one */
  double curvature_2[2]; /**< principal curvatures of body 2, the larger one first [1/m] */
  double direction_2[3]; /**< unit tangent of body 2's larger one */
  double R_i;            /**< larger radius of relative curvature [m]; infinite along a flat direction */
  double R_j;            /**< smaller radius [m] */
  double major_axis[3];  /**< unit tangent along R_i, the contact ellipse's major axis */
} osculate_contact;

/** The contact of two shapes, at most one of them a wall.
 * @param gap      OSCULATE_GAP_RESOLVE or OSCULATE_GAP_SKIP
 * @param cache    osculate_cache_size() bytes, read and brought up to date; NULL: from nothing
 * @param contact  set only on success */
OSCULATE_API int osculate_find_contact(const osculate_shape* shape_1, const osculate_pose* pose_1,
                                       const osculate_shape* shape_2, const osculate_pose* pose_2, int gap, void* cache,
                                       osculate_contact* contact);

/** Bodies in columns of `size` entries; walls are bodies as any others. */
typedef struct osculate_bodies {
  size_t size;
  const osculate_shape* const* shape; /**< one handle a body; bodies may share them */
  const double* position[3];          /**< x, y, z [m] */
  const double* orientation[4];       /**< w, x, y, z of unit quaternions, body to world */
} osculate_bodies;

/** Columns of contacts, one entry a pair, each as the member of osculate_contact with its name. Only `status` is
 * needed; what is not wanted is NULL, a vector with all of its components. */
typedef struct osculate_contact_columns {
  int32_t* status;
  double* normal[3];
  double* overlap;
  double* on_1[3];
  double* on_2[3];
  double* curvature_1[2];
  double* direction_1[3];
  double* curvature_2[2];
  double* direction_2[3];
  double* R_i;
  double* R_j;
  double* major_axis[3];
} osculate_contact_columns;

/** The contacts of many pairs, in SIMD batches. A pair's answer does not depend on the others.
 * @param body_1,body_2  `pairs` indices of bodies each
 * @param caches         pairs * osculate_cache_size() bytes, one cache after another; NULL: from nothing
 * On failure the message names the pair; the contacts and caches of pairs before it may be up to date already, the
 * others are as they were. */
OSCULATE_API int osculate_find_contacts(const osculate_bodies* bodies, size_t pairs, const int32_t* body_1,
                                        const int32_t* body_2, int gap, void* caches,
                                        const osculate_contact_columns* contacts);

/* ---- Laws -------------------------------------------------------------------------------------------------------- */

/** Isotropic linear elastic solid. */
typedef struct osculate_material {
  double youngs_modulus; /**< E > 0 [Pa] */
  double poissons_ratio; /**< in (-1, 0.5] */
} osculate_material;

/** One parameter of one law, by name: {"tsuji", "restitution", 0.7}. A law without a parameter to set is named once
 * with `parameter` NULL: {"hertz", NULL, 0}. Parameters left out take their standard value. `osculate law` lists all
 * laws. */
typedef struct osculate_law_setting {
  const char* law;
  const char* parameter;
  double value; /**< SI */
} osculate_law_setting;

/** A contact law, composed of parts and bound to two materials. */
typedef struct osculate_law osculate_law;

/** Which optional columns a law reads or writes; see osculate_law_needs. */
enum {
  OSCULATE_NEEDS_ANGULAR_VELOCITY = 1,
  OSCULATE_NEEDS_MEAN_ANGULAR_VELOCITY = 2,
  OSCULATE_NEEDS_REDUCED_MASS = 4,
  OSCULATE_NEEDS_EFFECTIVE_RADIUS = 8,
  OSCULATE_MAKES_COUPLES = 16
};

/** The law composed of all that `settings` name, in any order: a normal law, and at most one of each other slot.
 * Fails for unknown names (the message has the nearest), missing parameters or those out of range, laws that do not go
 * together (with the reason), and bad materials. */
OSCULATE_API int osculate_new_law(size_t count, const osculate_law_setting* settings,
                                  const osculate_material* material_1, const osculate_material* material_2,
                                  osculate_law** law);

/** Frees a law; NULL is allowed. */
OSCULATE_API void osculate_free_law(osculate_law* law);

/** Bytes that a contact remembers between two steps, a multiple of 8, possibly 0. All zero is a contact not yet made.
 * Any alignment will do. Bytes of one law mean nothing to another. 0 for a NULL law. */
OSCULATE_API size_t osculate_memory_size(const osculate_law* law);

/** The sum of OSCULATE_NEEDS_... and OSCULATE_MAKES_COUPLES that hold; 0 for a NULL law. */
OSCULATE_API int osculate_law_needs(const osculate_law* law);

/** The largest gap at which a contact of radii R_i >= R_j > 0 [m] may still act [m]: 0 without adhesion or roughness.
 */
OSCULATE_API int osculate_interaction_range(const osculate_law* law, double R_i, double R_j, double* range);

/** What a law said of a contact. */
enum {
  OSCULATE_OPEN = 0,          /**< no contact: no force, nothing remembered */
  OSCULATE_CLOSED = 1,        /**< in contact; an adhesive one may pull, also across a gap */
  OSCULATE_LARGE_CONTACT = 2, /**< closed, and a_c is at least half the smallest radius: beyond the theory  [FO57] */
  OSCULATE_LAW_NOT_CONVERGED = 3, /**< an inner search ran out of steps; the numbers are its last */
  OSCULATE_BAD_NUMBER = 4         /**< a number was not finite or of the wrong sign: no force, the memory as it was */
};

/** One contact at one step, as the law sees it. World frame. */
typedef struct osculate_approach {
  double R_i;                      /**< R_i >= R_j > 0 [m], may be infinite; both 0 at a gap that was skipped */
  double R_j;                      /**< [m] */
  double overlap;                  /**< [m]; <= 0 is a gap */
  double normal[3];                /**< unit, from body 1 to body 2 */
  double major_axis[3];            /**< unit tangent along R_i, sign free */
  double velocity[3];              /**< of body 2 against body 1 at the contact point [m/s] */
  double angular_velocity[3];      /**< of body 2 against body 1 [rad/s]; read if the law needs it, as the next three */
  double mean_angular_velocity[3]; /**< half the sum of both bodies' [rad/s]: turns the memory */
  double reduced_mass;             /**< m1 m2/(m1 + m2) > 0 [kg] */
  double effective_radius;         /**< R1 R2/(R1 + R2) > 0 of the volume-equivalent spheres [m] */
  double smallest_radius;          /**< least principal radius of both bodies [m], for OSCULATE_LARGE_CONTACT; 0: not
                                        asked */
  double time_step;                /**< since the last evaluation [s], >= 0 */
} osculate_approach;

/** What the law says. */
typedef struct osculate_force {
  int32_t status;           /**< OSCULATE_OPEN, ... */
  double force[3];          /**< on body 1 at the contact point [N]; body 2 feels the opposite */
  double couple[3];         /**< on body 1 [N m], of twisting and rolling, or 0; body 2 feels the opposite */
  double normal_force;      /**< elastic and viscous [N]; > 0 pushes the bodies apart */
  double a_c;               /**< major semi-axis of the contact ellipse [m] */
  double axis_ratio;        /**< minor over major semi-axis; 0 where there is no contact */
  double stiffness;         /**< dF_n/d(overlap) of the elastic part [N/m] */
  double stored_normal;     /**< energy that unloading gives back [J] */
  double stored_tangential; /**< of the tangential, twisting and rolling springs [J] */
  double viscous_loss;      /**< energy lost in this step [J] */
  double friction_loss;     /**< slip in all directions, in this step [J]; less what springs gained by stiffening */
  double hysteresis_loss;   /**< plastic flow, adhesive snap-off, in this step [J] */
} osculate_force;

/** One step of one contact.
 * @param memory  osculate_memory_size(law) bytes, read and brought up to date; NULL only if that is 0
 * @param force   set also when a number was bad: then to no force
 * A gap that was skipped (R_i = R_j = 0, overlap < 0) is open; a law with an interaction range takes none such: resolve
 * the gaps for it. */
OSCULATE_API int osculate_evaluate_force(const osculate_law* law, const osculate_approach* approach, void* memory,
                                         osculate_force* force);

/** Columns of contacts of one law at one step, one entry a contact, each as the member of osculate_approach with its
 * name. What the law does not need may be NULL, a vector with all of its components; so may `smallest_radius`. */
typedef struct osculate_approach_columns {
  size_t size;
  const double* R_i;
  const double* R_j;
  const double* overlap;
  const double* normal[3];
  const double* major_axis[3];
  const double* velocity[3];
  const double* angular_velocity[3];
  const double* mean_angular_velocity[3];
  const double* reduced_mass;
  const double* effective_radius;
  const double* smallest_radius;
  double time_step; /**< of all [s] */
} osculate_approach_columns;

/** Columns of forces, one entry a contact, each as the member of osculate_force with its name. Needed: `status`,
 * `force`, `normal_force`, and `couple` if the law makes couples. What is not wanted is NULL. */
typedef struct osculate_force_columns {
  int32_t* status;
  double* force[3];
  double* couple[3];
  double* normal_force;
  double* a_c;
  double* axis_ratio;
  double* stiffness;
  double* stored_normal;
  double* stored_tangential;
  double* viscous_loss;
  double* friction_loss;
  double* hysteresis_loss;
} osculate_force_columns;

/** One step of many contacts, in SIMD batches where the law has them. A contact's answer does not depend on the others.
 * @param memories  size * osculate_memory_size(law) bytes, one contact after another; NULL only if that is 0
 * If a contact's number is bad its status says so, all others are evaluated, and the call fails with a message that
 * names the first. After any other failure nothing has been written. */
OSCULATE_API int osculate_evaluate_forces(const osculate_law* law, const osculate_approach_columns* approach,
                                          void* memories, const osculate_force_columns* forces);

#ifdef __cplusplus
}
#endif

#endif
