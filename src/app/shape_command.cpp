#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "io/curvature_scale.hpp"
#include "io/mesh_writer.hpp"
#include "io/picture.hpp"
#include "io/shape_file.hpp"
#include "io/shape_properties.hpp"
#include "io/table.hpp"

namespace osculate::app {
namespace {

using nlohmann::json;

struct ShapeOptions {
  std::string shape;
  std::string out;
  std::string picture;
  std::string colour = "mean";
  std::optional<int> resolution;
  bool as_json = false;
};

io::CurvatureKind curvature_kind(const ShapeOptions& options) {
  return options.colour == "gaussian" ? io::CurvatureKind::gaussian
         : options.colour == "max"    ? io::CurvatureKind::max
                                      : io::CurvatureKind::mean;
}

constexpr const char* help = R"(A shape is a catalogue name or the path of a shape file (with a '/' or ending in .toml):

  osculate shape                                     the catalogue
  osculate shape rice                                its properties
  osculate shape rice --picture rice.png             a picture, coloured by mean curvature
  osculate shape my/grain.toml --out grain           grain.obj and grain.vtp (ParaView)

A shape file:
  title = "Rice grain"
  source = "where the dimensions come from"
  unit = "mm"                      # m, cm, mm, um, nm, in
  kind = "superquadric"            # then
  half_axes = [1.45, 1.05, 2.8]    #   a, b, c
  n = [2.4, 2.0]                   #   n1, n2 in (1, 64]; or eta = [eta1, eta2], n = 2/eta
  # kind = "ellipsoid"               half_axes
  # kind = "sphere"                  radius
  # kind = "potential_particle"      planes = [[nx, ny, nz, d], ...] or polyhedron = "file.off|stl|obj"; k, r, R
  # kind = "half_space"              solid z <= 0, no keys and no unit
  # kind = "cylinder"                radius, side = "rod" | "drum", axis z
  # kind = "sphere_container"        radius
All keys: docs/shape-files.md)";

bool is_infinite(double curvature, double size) {
  return curvature * size > 1e50;
}

json json_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

json json_of(const io::ShapeProperties& p) {
  const Mat3& inertia = p.mass.inertia;
  return {{"volume_m3", p.mass.volume},
          {"centroid_m", json_of(p.mass.centroid)},
          {"inertia_m5", {json_of(inertia.row(0)), json_of(inertia.row(1)), json_of(inertia.row(2))}},
          {"mass_relative_error", p.mass.relative_error},
          {"equivalent_radius_m", p.equivalent_radius},
          {"bounding_radius_m", p.bounding_radius},
          {"box_centre_m", json_of(p.box.centre)},
          {"box_half_extents_m", json_of(p.box.half_extents)},
          {"area_m2", p.area},
          {"area_error_m2", p.area_error},
          {"sphericity", p.sphericity},
          {"smallest_curvature_per_m", p.smallest_curvature},
          {"largest_curvature_per_m",
           is_infinite(p.largest_curvature, p.equivalent_radius) ? json(nullptr) : json(p.largest_curvature)}};
}

/// The numbers that define the shape, in SI.
json parameters_json(const Shape& shape) {
  return std::visit(
      [](const auto& s) -> json {
        json found = json::object();
        if constexpr (requires { s.half_axes; }) found["half_axes_m"] = json_of(s.half_axes);
        if constexpr (requires { s.exponents; }) {
          found["n"] = {s.exponents.n1, s.exponents.n2};
          found["eta"] = {2.0 / s.exponents.n1, 2.0 / s.exponents.n2};
        }
        if constexpr (requires { s.radius; }) found["radius_m"] = s.radius;
        if constexpr (requires { s.solid; }) found["side"] = s.solid == Cylinder::Solid::inside ? "rod" : "drum";
        if constexpr (requires { s.planes; }) {
          for (const FacePlane& p : s.planes) {
            found["planes"].push_back({p.normal.x(), p.normal.y(), p.normal.z(), p.distance});
          }
          found["k"] = s.sphericity;
          found["r_m"] = s.edge_radius;
          found["R_m"] = s.sphere_radius;
        }
        return found;
      },
      shape);
}

/// Numbers in the unit that suits the body.
struct Writer {
  io::Unit unit;
  double zero;  ///< a length that is nothing beside the body's: rounding or the error of a quadrature [m]

  std::string length(double metres) const { return fmt::format("{:.6g} {}", metres / unit.in_si, unit.symbol); }

  std::string lengths(const Vec3& metres) const {
    const Vec3 v = (metres.array().abs() < zero).select(0.0, metres) / unit.in_si;
    return fmt::format("{:.6g}, {:.6g}, {:.6g} {}", v.x(), v.y(), v.z(), unit.symbol);
  }

  std::string power(double si, int exponent, const char* superscript) const {
    return fmt::format("{:.6g} {}{}", si / std::pow(unit.in_si, exponent), unit.symbol, superscript);
  }

  std::string curvature(double per_metre) const { return fmt::format("{:.6g}", per_metre * unit.in_si); }
};

void add_parameters(std::vector<io::Property>& rows, const Shape& shape, const Writer& write) {
  std::visit(
      [&](const auto& s) {
        if constexpr (requires { s.half_axes; }) rows.push_back({"half-axes a, b, c", write.lengths(s.half_axes)});
        if constexpr (requires { s.exponents; }) {
          rows.push_back({"exponents n1, n2", fmt::format("{:.6g}, {:.6g}", s.exponents.n1, s.exponents.n2)});
          rows.push_back(
              {"exponents η1, η2", fmt::format("{:.6g}, {:.6g}", 2.0 / s.exponents.n1, 2.0 / s.exponents.n2)});
        }
        if constexpr (requires { s.radius; }) rows.push_back({"radius", write.length(s.radius)});
        if constexpr (requires { s.solid; }) {
          rows.push_back(
              {"side", s.solid == Cylinder::Solid::inside ? "rod, particles outside" : "drum, particles inside"});
        }
        if constexpr (requires { s.planes; }) {
          rows.push_back({"face planes", fmt::format("{}", s.planes.size())});
          rows.push_back({"sphericity parameter k", fmt::format("{:.6g}", s.sphericity)});
          rows.push_back({"edge radius r", write.length(s.edge_radius)});
          rows.push_back({"sphere radius R", write.length(s.sphere_radius)});
        }
      },
      shape);
}

std::string exactness(double relative_error) {
  return relative_error == 0.0 ? "closed form, exact to round-off"
                               : fmt::format("quadrature, relative error below {:.1g}", relative_error);
}

void add_measures(std::vector<io::Property>& rows, const io::ShapeProperties& p, const Writer& write) {
  const Mat3& inertia = p.mass.inertia;
  rows.push_back({"volume V", write.power(p.mass.volume, 3, "³")});
  rows.push_back({"radius of equal sphere R_vol", write.length(p.equivalent_radius)});
  rows.push_back({"centroid", write.lengths(p.mass.centroid)});
  const double fifth = std::pow(write.unit.in_si, 5);
  const double zero = std::max(1e-12, p.mass.relative_error) * inertia.diagonal().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    const auto entry = [&](int j) { return std::fabs(inertia(i, j)) < zero ? 0.0 : inertia(i, j) / fifth; };
    const std::string value = fmt::format("{:>12.6g} {:>12.6g} {:>12.6g}", entry(0), entry(1), entry(2));
    rows.push_back({i == 0 ? fmt::format("inertia / density ({}⁵)", write.unit.symbol) : "", value});
  }
  rows.push_back({"volume and inertia by", exactness(p.mass.relative_error)});
  rows.push_back({"bounding radius", write.length(p.bounding_radius)});
  rows.push_back({"box, half extents", write.lengths(p.box.half_extents)});
  rows.push_back({"surface area A", fmt::format("{} ± {:.1g}", write.power(p.area, 2, "²"),
                                                p.area_error / (write.unit.in_si * write.unit.in_si))});
  rows.push_back({"sphericity Ψ", fmt::format("{:.4f}", p.sphericity)});
  const bool sharp = is_infinite(p.largest_curvature, p.equivalent_radius);
  rows.push_back({fmt::format("curvatures k_min … k_max (1/{})", write.unit.symbol),
                  fmt::format("{} … {}", write.curvature(p.smallest_curvature),
                              sharp ? "∞ (a sharp rim or pole)" : write.curvature(p.largest_curvature))});
}

/// "13.4 × 13.4 × 6.93 mm"
std::string across(const Shape& shape) {
  const Vec3 size = 2.0 * oriented_box(shape).half_extents;
  const io::Unit unit = io::suitable_length(size.maxCoeff());
  return fmt::format("{:.4g} × {:.4g} × {:.4g} {}", size.x() / unit.in_si, size.y() / unit.in_si, size.z() / unit.in_si,
                     unit.symbol);
}

void write_picture(const io::ShapeFile& file, const io::CurvedSurface& surface, const ShapeOptions& options) {
  io::CurvaturePicture curvature = io::picture_of(surface, curvature_kind(options));
  io::Picture picture;
  picture.title = file.title.empty() ? file.name : file.title;
  picture.notes = {fmt::format("{}, {}", kind(file.shape), across(file.shape))};
  picture.bodies.push_back(std::move(curvature.body));
  picture.colour_bar = curvature.colour_bar;
  io::write_png(picture, options.picture);
}

/// Writes the surface and says which files there are.
std::vector<std::string> write_surface(const io::CurvedSurface& surface, const ShapeOptions& options) {
  const std::filesystem::path out = options.out;
  if (out.extension() == ".obj") {
    io::write_obj(surface, curvature_kind(options), out);
    return {out};
  }
  if (out.extension() == ".vtp") {
    io::write_vtp(surface, curvature_kind(options), out);
    return {out};
  }
  const std::string obj = options.out + ".obj", vtp = options.out + ".vtp";
  io::write_obj(surface, curvature_kind(options), obj);
  io::write_vtp(surface, curvature_kind(options), vtp);
  return {obj, vtp};
}

void list_catalogue(const ShapeOptions& options) {
  json all = json::array();
  std::vector<io::Property> rows;
  for (const io::CatalogueEntry& entry : io::catalogue()) {
    const io::TomlTable table = io::read_toml(entry.file);
    const std::string title = table.text_or("title", ""), kind = table.text_or("kind", "");
    all.push_back({{"name", entry.name}, {"title", title}, {"kind", kind}, {"file", entry.file.string()}});
    rows.push_back({entry.name, title});
  }
  if (options.as_json) {
    fmt::print("{}\n", all.dump(2));
  } else {
    fmt::print("{}\n'osculate shape NAME' shows one; 'osculate shape --help' says what a shape file holds.\n",
               io::to_text(rows));
  }
}

void show(const ShapeOptions& options) {
  const io::ShapeFile file = io::find_shape(options.shape);
  const bool particle = is_particle(file.shape);
  if (!particle && !(options.out.empty() && options.picture.empty())) {
    throw InputError(options.shape, fmt::format("found a wall ({})", kind(file.shape)),
                     "a particle for a surface or a picture");
  }
  std::optional<io::CurvedSurface> surface;
  std::optional<io::ShapeProperties> properties;
  if (particle) {
    // The curvature of a potential particle jumps along lines that run across the mesh: finer cells keep them clean.
    const int resolution =
        options.resolution.value_or(std::holds_alternative<PotentialParticle>(file.shape) ? 192 : 96);
    surface = io::curved_surface(file.shape, resolution);
    properties = io::measure(file.shape, *surface, resolution);
  }
  std::vector<std::string> written;
  if (!options.out.empty()) written = write_surface(*surface, options);
  if (!options.picture.empty()) {
    write_picture(file, *surface, options);
    written.push_back(options.picture);
  }

  if (options.as_json) {
    json out = {{"name", file.name},          {"title", file.title},      {"source", file.source},
                {"file", file.file.string()}, {"kind", kind(file.shape)}, {"parameters", parameters_json(file.shape)}};
    if (properties) out["properties"] = json_of(*properties);
    if (!written.empty()) out["written"] = written;
    fmt::print("{}\n", out.dump(2));
    return;
  }
  const double size = properties ? properties->equivalent_radius : 1.0;
  const double error = properties ? properties->mass.relative_error : 0.0;
  const Writer write{.unit = io::suitable_length(size), .zero = std::max(1e-12, error) * size};
  std::vector<io::Property> rows{{"kind", std::string(kind(file.shape))}};
  add_parameters(rows, file.shape, write);
  if (properties) add_measures(rows, *properties, write);
  fmt::print("{}{}{}\n", file.name, file.title.empty() ? "" : ": ", file.title);
  fmt::print("source: {}\nfile: {}\n\n", file.source.empty() ? "not given" : file.source, file.file.string());
  fmt::print("{}", io::to_text(rows));
  for (const std::string& path : written) fmt::print("\nwrote {}", path);
  if (!written.empty()) fmt::print("\n");
}

}  // namespace

void add_shape(CLI::App& program) {
  CLI::App* command = program.add_subcommand("shape", "Properties, surface files and pictures of a particle shape");
  const auto options = std::make_shared<ShapeOptions>();
  command->add_option("shape", options->shape, "catalogue name or shape file; none lists the catalogue");
  command->add_option("--out", options->out, "write the surface: FILE.obj, FILE.vtp, or a prefix for both");
  command->add_option("--picture", options->picture, "write a picture (PNG)");
  command->add_option("--colour,--color", options->colour, "curvature shown in colours")
      ->check(CLI::IsMember({"mean", "gaussian", "max"}))
      ->capture_default_str();
  command
      ->add_option("--resolution", options->resolution,
                   "cells along each edge of the cube mapped to the surface (96; potential particles 192)")
      ->check(CLI::Range(2, 1024));
  command->add_flag("--json", options->as_json, "print JSON, in SI units");
  command->footer(help);
  command->callback([options] {
    if (options->shape.empty()) {
      list_catalogue(*options);
    } else {
      show(*options);
    }
  });
}

}  // namespace osculate::app
