#include "io/contact_file.hpp"

#include <fmt/format.h>

#include "io/body_keys.hpp"
#include "io/shape_file.hpp"
#include "io/toml_reader.hpp"

namespace osculate::io {
namespace {

// Centres this many bounding radii apart are no contact to analyse but a slip of the unit.
constexpr double implausible_distance = 1000.0;

void read_material(const TomlTable& table, ContactFileBody& body) {
  if (!table.is_table("material")) {
    body.material_name = table.text("material");
    body.material = read_preset(table, "material");
    return;
  }
  const TomlTable material = table.table("material");
  body.material = read_elastic_constants(material);
  material.reject_unknown_keys();
}

ContactFileBody read_body(const TomlTable& table, std::string_view length_unit) {
  ContactFileBody body;
  const ShapeFile named = parse_shape_of(table, "shape", length_unit);
  body.shape_name = named.name;
  body.shape = named.shape;
  if (table.has("position")) body.pose.position = table.vector("position", length(), Range::any(), length_unit);
  body.pose.orientation = read_orientation(table);
  read_material(table, body);
  table.reject_unknown_keys();
  return body;
}

void check_together(const TomlTable& file, const TomlTable& table_2, const ContactFile& contact) {
  const Shape& shape_1 = contact.body_1.shape;
  const Shape& shape_2 = contact.body_2.shape;
  if (!is_particle(shape_1) && !is_particle(shape_2))
    throw InputError(file.where(), fmt::format("two walls ({} and {})", kind(shape_1), kind(shape_2)),
                     "at least one particle");
  if (!is_particle(shape_1) || !is_particle(shape_2)) return;
  const double reach = bounding_radius(shape_1) + bounding_radius(shape_2);
  const double distance = (contact.body_2.pose.position - contact.body_1.pose.position).norm();
  if (distance > implausible_distance * reach)
    throw table_2.error(
        "position", fmt::format("centres {:.3g} m apart, with bodies that reach {:.3g} m together", distance, reach),
        "bodies near each other (positions without a unit are in length_unit, m if there is none)");
}

}  // namespace

ContactFile read_contact_file(const std::filesystem::path& path) {
  const TomlTable file = read_toml(path);
  ContactFile contact;
  contact.title = file.text_or("title", "");
  const std::string length_unit = file.text_or("length_unit", "");
  if (!length_unit.empty() && !length().in_si(length_unit))
    throw file.error("length_unit", "\"" + length_unit + "\"", "one of " + length().symbols());
  if (file.has("radius_cap")) contact.radius_cap = file.number("radius_cap", Range::positive());
  const TomlTable table_1 = file.table("body_1");
  const TomlTable table_2 = file.table("body_2");
  contact.body_1 = read_body(table_1, length_unit);
  contact.body_2 = read_body(table_2, length_unit);
  file.reject_unknown_keys();
  check_together(file, table_2, contact);
  return contact;
}

const char* contact_file_keys() {
  return R"(  title         a line about the contact                                     optional
  length_unit   unit of lengths written without one: m, mm, um, ...          optional, m
  radius_cap    largest radius of relative curvature, in R_vol of the        optional, none
                smaller particle: bounds the force of flat contacts
  [body_1] and [body_2]
  shape         a name of the catalogue, a shape file, or an inline shape
                {kind = "superquadric", unit = "mm", half_axes = [3, 2, 1], n = [4, 2]}
  position      [x, y, z] of the centre: numbers, or "2.5 mm"                optional, origin
  orientation   unit quaternion [w, x, y, z] (body to world), or
                {axis = [x, y, z], angle = degrees}                          optional, none
  material      glass, steel, aluminium, nylon, or
                {youngs_modulus = "70 GPa", poissons_ratio = 0.22})";
}

}  // namespace osculate::io
