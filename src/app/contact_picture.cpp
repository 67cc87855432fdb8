#include "app/contact_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/wall_patch.hpp"
#include "io/picture.hpp"
#include "io/quantity_text.hpp"

namespace osculate::app {
namespace {

constexpr int mesh_resolution = 64;
constexpr double body_opacity = 0.45;
constexpr double wall_opacity = 0.25;

/// 1, 2 or 5 times a power of ten, not above `value`; at least 1.
double round_factor(double value) {
  if (!(value > 1.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

double reach_of(const ContactAnalysis& analysis) {
  return std::min(bounding_radius(analysis.input.body_1.shape), bounding_radius(analysis.input.body_2.shape));
}

io::PictureBody body_of(const io::ContactFileBody& body, const Vec3& contact_point, double reach, io::Colour colour) {
  constexpr double patch_size = 1.5;
  if (is_particle(body.shape))
    return {.mesh = surface_mesh(body.shape, mesh_resolution),
            .pose = body.pose,
            .colour = colour,
            .opacity = body_opacity};
  return {.mesh = wall_patch(body.shape, body.pose.to_body(contact_point), patch_size * reach),
          .pose = body.pose,
          .colour = colour,
          .opacity = wall_opacity};
}

void add_ellipse(const ContactAnalysis& analysis, io::Picture& picture) {
  const hertz::Contact& hertz = analysis.hertz->contact;
  const ContactGeometry& contact = analysis.geometry;
  constexpr double wanted_size = 0.3;
  const double factor = round_factor(wanted_size * analysis.volume_radius() / hertz.a_c);
  const Vec3 major = factor * hertz.a_c * contact.relative.major_axis;
  const Vec3 minor = factor * hertz.b_c * contact.normal.cross(contact.relative.major_axis);
  io::PictureLine ellipse{.colour = io::palette::black, .depth = io::Depth::always_seen};
  constexpr int pieces = 96;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / pieces;
    ellipse.points.push_back(contact.point() + std::cos(angle) * major + std::sin(angle) * minor);
  }
  picture.lines.push_back(ellipse);
  picture.notes.push_back(fmt::format("a_c = {}, b_c = {}; the contact ellipse is drawn {}",
                                      io::quantity_text(hertz.a_c, "m"), io::quantity_text(hertz.b_c, "m"),
                                      factor > 1.0 ? fmt::format("{:g} times its size", factor) : "to scale"));
}

/// From the side, so that the overlap shows, a little from above, so that the ellipse does; the normal upright.
io::PictureView view_of(const ContactGeometry& contact) {
  constexpr double from_above = 0.45;
  io::PictureView view;
  view.up = contact.normal.z() < 0.0 ? Vec3(-contact.normal) : contact.normal;
  view.towards_viewer = contact.normal.cross(contact.relative.major_axis) + from_above * view.up;
  return view;
}

}  // namespace

void write_contact_picture(const ContactAnalysis& analysis, const std::filesystem::path& path) {
  const ContactGeometry& contact = analysis.geometry;
  const double reach = reach_of(analysis);
  io::Picture picture;
  picture.title = analysis.input.title.empty() ? "Contact" : analysis.input.title;
  const Vec3 centre = is_resolved(contact.status) ? contact.point() : analysis.input.body_1.pose.position;
  picture.bodies.push_back(body_of(analysis.input.body_1, centre, reach, io::palette::blue));
  picture.bodies.push_back(body_of(analysis.input.body_2, centre, reach, io::palette::orange));
  if (is_resolved(contact.status)) {
    picture.notes.push_back(fmt::format("{}: {} = {}", name(contact.status),
                                        contact.overlap < 0.0 ? "gap" : "overlap δ",
                                        io::quantity_text(std::fabs(contact.overlap), "m")) +
                            (analysis.hertz ? ", force " + io::quantity_text(analysis.hertz->contact.force, "N") : ""));
    const Vec3 tip = contact.point() + analysis.volume_radius() * contact.normal;
    picture.arrows.push_back({.from = contact.point(), .to = tip});
    picture.labels.push_back({.position = tip, .text = "n"});
    picture.points.push_back({.position = contact.on_1, .colour = io::palette::blue});
    picture.points.push_back({.position = contact.on_2, .colour = io::palette::orange});
    if (analysis.hertz) add_ellipse(analysis, picture);
    picture.view = view_of(contact);
  } else {
    picture.notes.emplace_back(name(contact.status));
  }
  io::write_png(picture, path);
}

}  // namespace osculate::app
