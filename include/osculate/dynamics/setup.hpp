#pragma once
// What a simulation is made of. Plain values; `validate` says what does not fit together.

#include <cstdint>
#include <string>
#include <vector>

#include "osculate/dynamics/bodies.hpp"
#include "osculate/dynamics/motion.hpp"
#include "osculate/dynamics/periodic_box.hpp"
#include "osculate/dynamics/pour.hpp"
#include "osculate/geometry/curvature_models.hpp"
#include "osculate/geometry/mesh_surface.hpp"
#include "osculate/mechanics/contact_law.hpp"
#include "osculate/mechanics/material.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

struct Material {
  std::string name;
  ElasticMaterial elastic;
  double density;  ///< > 0 [kg/m³]
};

/// The law between two materials, in either order.
struct Interaction {
  std::int32_t material_1;  ///< index into Setup::materials
  std::int32_t material_2;
  ContactLaw law;
};

/// A body at time 0.
struct BodyStart {
  std::int32_t shape;                    ///< index into Setup::shapes
  std::int32_t material;                 ///< index into Setup::materials
  std::int32_t motion = Bodies::free;    ///< index into Setup::motions, or free; walls must have one
  Pose pose;                             ///< of the body's frame: centroid and principal axes, see BodyShape
  Vec3 velocity = Vec3::Zero();          ///< [m/s], free bodies only
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s], world, free bodies only
};

/// A surface of triangles at time 0. In a simulation each of its faces is a body.
struct MeshStart {
  SurfaceTriangles triangles;
  std::int32_t material;  ///< index into Setup::materials
  std::int32_t motion;    ///< index into Setup::motions
  Pose pose;              ///< of the surface's frame
};

struct Setup {
  std::vector<Shape> shapes;
  std::vector<Material> materials;
  std::vector<Interaction> interactions;  ///< one for every two materials whose bodies may meet
  std::vector<Motion> motions;
  std::vector<BodyStart> bodies;
  std::vector<MeshStart> meshes;  ///< their faces are the bodies after `bodies`, in the same order
  std::vector<Pour> pours;        ///< their particles come after those
  Vec3 gravity = Vec3::Zero();    ///< [m/s²]
  PeriodicBox box;
  double time_step = 0.0;          ///< > 0 [s], see time_step.hpp
  double radius_cap = review_cap;  ///< no relative radius of curvature above this times the smaller R_vol
  double skin = 0.1;               ///< > 0: pairs are kept to this at least, in bounding radii of the smallest particle
  int threads = 1;                 ///< ≥ 1; results do not depend on it
};

/// Throws InputError, naming the body or other entry, for indices out of range, a body without mass or with numbers
/// that are not finite, an orientation that is not a unit quaternion to 1e-6, a free wall, a missing or doubled
/// interaction, a scene without free bodies, and a periodic box in which a particle could meet another one twice.
void validate(const Setup& setup);

}  // namespace osculate
