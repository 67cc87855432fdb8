#pragma once
// Pictures without a display: shaded bodies, lines, arrows and points seen along parallel rays, with title, colour bar,
// labels, scale bar and axes, on white, as a PNG file.
//
//   io::Picture picture{.title = "Rice"};
//   picture.bodies.push_back({.mesh = surface_mesh(shape, 96)});
//   io::write_png(picture, "rice.png");

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/colour.hpp"
#include "osculate/core/types.hpp"
#include "osculate/shapes/mesh.hpp"

namespace osculate::io {

/// Whether bodies in front hide a thing.
enum class Depth {
  hidden_by_bodies,
  always_seen,
};

struct PictureBody {
  TriangleMesh mesh = {};
  Pose pose = {};
  Colour colour = palette::grey;
  std::vector<double> scalars = {};  ///< one a vertex: drawn by the colour bar instead of `colour`
  double opacity = 1.0;              ///< in (0, 1]; translucent bodies show their front only
};

/// Many opaque bodies of one form; `scalars` as for a body, but one a body.
struct PictureSwarm {
  TriangleMesh mesh = {};
  std::vector<Pose> poses = {};
  std::vector<Colour> colours = {};  ///< one a body, or none where there are scalars
  std::vector<double> scalars = {};
};

/// World frame [m]; widths and diameters in pixels of the picture.
struct PictureLine {
  std::vector<Vec3> points = {};
  Colour colour = palette::black;
  double width = 3.0;
  Depth depth = Depth::hidden_by_bodies;
};

struct PictureArrow {
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  Colour colour = palette::black;
  double width = 4.0;
  Depth depth = Depth::always_seen;
};

struct PicturePoint {
  Vec3 position = Vec3::Zero();
  Colour colour = palette::black;
  double diameter = 12.0;
  Depth depth = Depth::always_seen;
};

struct PictureLabel {
  Vec3 position = Vec3::Zero();
  std::string text = {};
  Colour colour = palette::black;
  double right = 10.0;  ///< how far the text stands from the position [px]
  double up = 6.0;
};

/// Colours of scalars: `lower` and `upper` are the ends of the map, values beyond keep the end's colour and the bar
/// says so by a pointed end. The scalars are in the unit of the title.
struct ColourBar {
  std::string title = {};  ///< with its unit, e.g. "mean curvature (1/mm)"
  double lower = 0.0;
  double upper = 1.0;
};

/// Seen from infinity. What is not given is chosen so that all bodies fit.
struct PictureView {
  Vec3 towards_viewer = Vec3(1.0, -1.7, 0.9);  ///< any length; not parallel to `up`
  Vec3 up = Vec3::UnitZ();
  std::optional<Vec3> centre = {};         ///< [m], drawn in the middle
  std::optional<double> half_height = {};  ///< of the part of the world that fills the free height [m]
  std::vector<Vec3> shows = {};            ///< points that shall fit instead of the bodies [m]
};

struct Picture {
  std::string title = {};
  std::vector<std::string> notes = {};  ///< lines below the title
  std::vector<PictureBody> bodies = {};
  std::vector<PictureSwarm> swarms = {};
  std::vector<PictureLine> lines = {};
  std::vector<PictureArrow> arrows = {};
  std::vector<PicturePoint> points = {};
  std::vector<PictureLabel> labels = {};
  std::optional<ColourBar> colour_bar = {};
  PictureView view = {};
  int width = 1200;  ///< [px]
  int height = 900;
  double shade_radius = 0.0;  ///< how far bodies darken the gaps between them [m]; 0: not at all
};

/// Throws InputError if there is no body to show, a body with scalars but no colour bar, a size outside 200 to 5000 px,
/// a view along `up`, or a file that cannot be written.
void write_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace osculate::io
