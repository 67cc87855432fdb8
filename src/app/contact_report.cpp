// The contact as text and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/contact_analysis.hpp"
#include "io/quantity_text.hpp"
#include "io/table.hpp"

namespace osculate::app {
namespace {

using io::quantity_text;
using io::vector_text;
using json = nlohmann::ordered_json;

std::string line(std::string_view label, std::string_view value, std::string_view remark = "") {
  // The label's column is counted in code points: Greek letters take two bytes.
  const auto letters = std::count_if(label.begin(), label.end(),
                                     [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  constexpr std::ptrdiff_t label_width = 28;
  const auto padding = static_cast<int>(std::max<std::ptrdiff_t>(label_width - letters, 1));
  return fmt::format("  {}{:{}}{}{}{}\n", label, "", padding, value, remark.empty() ? "" : "   ", remark);
}

std::string describe(const io::ContactFileBody& body, double volume_radius) {
  const std::string material =
      fmt::format("{}{}E = {:g} GPa, ν = {:g}", body.material_name, body.material_name.empty() ? "" : ", ",
                  body.material.youngs_modulus * 1e-9, body.material.poissons_ratio);
  const std::string size =
      std::isfinite(volume_radius) ? fmt::format("R_vol = {}", quantity_text(volume_radius, "m")) : "wall";
  const std::string kind(osculate::kind(body.shape));
  const std::string named =
      body.shape_name.empty() || body.shape_name == kind ? kind : fmt::format("{} ({})", body.shape_name, kind);
  return fmt::format("{};  {};  {}", named, size, material);
}

std::string heading(const ContactAnalysis& analysis) {
  const io::ContactFile& input = analysis.input;
  return fmt::format("{}{}Bodies\n", input.title, input.title.empty() ? "" : "\n\n") +
         line("body 1", describe(input.body_1, analysis.volume_radius_1)) +
         line("body 2", describe(input.body_2, analysis.volume_radius_2));
}

std::string geometry_text(const ContactAnalysis& analysis) {
  const ContactGeometry& contact = analysis.geometry;
  std::string text = "\nContact\n" + line("status", name(contact.status));
  if (!is_resolved(contact.status)) return text;
  const double size = analysis.volume_radius();
  const io::PrefixedUnit unit = io::prefixed_unit(size, "m");
  constexpr int digits = 6;
  text += line(contact.overlap < 0.0 ? "gap −δ" : "overlap δ", quantity_text(std::fabs(contact.overlap), "m"),
               fmt::format("{:.4g} % of R_vol", 100.0 * std::fabs(contact.overlap) / size));
  text += line("normal, body 1 → 2", vector_text(contact.normal, 1.0, digits));
  const auto point_text = [&](const Vec3& point) {
    return fmt::format("{} {}", vector_text(point, unit.size, digits), unit.symbol);
  };
  text += line("point on body 1", point_text(contact.on_1));
  text += line("point on body 2", point_text(contact.on_2));
  text += line("contact point", point_text(contact.point()), "midway");
  return text;
}

std::string curvature_text(const ContactAnalysis& analysis) {
  const ContactGeometry& contact = analysis.geometry;
  if (!is_resolved(contact.status)) return "";
  constexpr int digits = 6;
  const auto number = [](double value) { return fmt::format("{:#.6g}", value); };
  io::Table table{{"Principal curvatures", "k_max [1/m]", "k_min [1/m]", "direction of k_max", "direction of k_min"},
                  {}};
  const auto add = [&](const char* body, const PrincipalCurvatures& curvature, const Vec3& outward) {
    const Vec3 other = outward.cross(curvature.max_direction);
    table.rows.push_back({body, number(curvature.max), number(curvature.min),
                          vector_text(curvature.max_direction, 1.0, digits), vector_text(other, 1.0, digits)});
  };
  add("  body 1", contact.curvature_1, contact.normal);
  add("  body 2", contact.curvature_2, -contact.normal);
  const RelativeCurvature& relative = contact.relative;
  std::string text = fmt::format("\n{}\nRelative curvature\n", io::to_text(table));
  text += line("R_i, along the major axis", quantity_text(relative.R_i, "m"),
               relative.capped ? fmt::format("capped at {:g} R_vol", analysis.input.radius_cap) : "");
  text += line("R_j, across", quantity_text(relative.R_j, "m"));
  text += line("major axis", vector_text(relative.major_axis, 1.0, digits));
  return text;
}

std::string hertz_text(const ContactAnalysis& analysis) {
  const ContactGeometry& contact = analysis.geometry;
  if (!analysis.hertz) {
    if (!is_resolved(contact.status)) return "\nNo force: the contact is not resolved.\n";
    if (contact.overlap < 0.0) return "\nNo force: the bodies are apart.\n";
    return "\nNo force: the bodies are flat along the major axis (R_i = ∞). With radius_cap in the contact file the\n"
           "radius is capped; 10 is the review's choice.\n";
  }
  const ContactEllipse& ellipse = analysis.hertz->ellipse;
  const hertz::Contact& hertz = analysis.hertz->contact;
  const auto number = [](double value) { return fmt::format("{:.9f}", value); };
  std::string text = "\nElliptical Hertz\n";
  text += line("effective modulus Ê", quantity_text(analysis.effective_modulus, "Pa"));
  text += line("e² = 1 − (b_c/a_c)²", number(ellipse.e2));
  text += line("γ (force)", number(ellipse.gamma()));
  text += line("β (contact area)", number(ellipse.beta()));
  text += line("force F", quantity_text(hertz.force, "N"));
  text += line("major semi-axis a_c", quantity_text(hertz.a_c, "m"));
  text += line("minor semi-axis b_c", quantity_text(hertz.b_c, "m"));
  text += line("peak pressure p_0", quantity_text(hertz.peak_pressure, "Pa"));
  text += line("stiffness dF/dδ", quantity_text(hertz.stiffness, "N/m"));
  text += line("elastic energy", quantity_text(hertz.strain_energy, "J"));
  text += line("validity", name(hertz.validity),
               fmt::format("a_c/R_min = {:.3g}, to be below 0.5", hertz.a_c / analysis.hertz->smallest_radius));
  return text;
}

std::string error_text(double relative_error) {
  constexpr double smallest_written = 5e-6;
  if (std::fabs(relative_error) < smallest_written) return "0.000 %";
  return fmt::format("{:+.3f} %", 100.0 * relative_error);
}

std::string models_text(const ContactAnalysis& analysis) {
  if (analysis.models.empty()) return "";
  io::Table table{{"Same overlap, by model", "R_i", "R_j", "force", "error"}, {}};
  const auto row = [&](const std::string& model, const RelativeCurvature& relative,
                       const std::optional<double>& force) {
    const double exact = analysis.hertz->contact.force;
    table.rows.push_back({fmt::format("  {}", model), quantity_text(relative.R_i, "m"),
                          quantity_text(relative.R_j, "m"), force ? quantity_text(*force, "N") : "-",
                          force ? error_text(*force / exact - 1.0) : "-"});
  };
  for (const ModelForce& model : analysis.models) row(model.model, model.relative, model.force);
  return fmt::format("\n{}", io::to_text(table));
}

json number_of(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

json vector_of(const Vec3& vector) {
  return {number_of(vector.x()), number_of(vector.y()), number_of(vector.z())};
}

json body_of(const io::ContactFileBody& body, double volume_radius) {
  const Quat& q = body.pose.orientation;
  return {{"shape", body.shape_name},
          {"kind", kind(body.shape)},
          {"volume_radius", number_of(volume_radius)},
          {"position", vector_of(body.pose.position)},
          {"orientation", {q.w(), q.x(), q.y(), q.z()}},
          {"youngs_modulus", body.material.youngs_modulus},
          {"poissons_ratio", body.material.poissons_ratio}};
}

json curvature_of(const PrincipalCurvatures& curvature) {
  return {{"max", number_of(curvature.max)},
          {"min", number_of(curvature.min)},
          {"max_direction", vector_of(curvature.max_direction)}};
}

json relative_of(const RelativeCurvature& relative) {
  return {{"R_i", number_of(relative.R_i)},
          {"R_j", number_of(relative.R_j)},
          {"major_axis", vector_of(relative.major_axis)},
          {"capped", relative.capped}};
}

}  // namespace

std::string to_text(const ContactAnalysis& analysis) {
  return heading(analysis) + geometry_text(analysis) + curvature_text(analysis) + hertz_text(analysis) +
         models_text(analysis);
}

std::string to_json(const ContactAnalysis& analysis) {
  const ContactGeometry& contact = analysis.geometry;
  json report{{"title", analysis.input.title},
              {"body_1", body_of(analysis.input.body_1, analysis.volume_radius_1)},
              {"body_2", body_of(analysis.input.body_2, analysis.volume_radius_2)},
              {"radius_cap_over_volume_radius", number_of(analysis.input.radius_cap)},
              {"status", name(contact.status)},
              {"normal", vector_of(contact.normal)},
              {"overlap", number_of(contact.overlap)},
              {"on_1", vector_of(contact.on_1)},
              {"on_2", vector_of(contact.on_2)},
              {"curvature_1", curvature_of(contact.curvature_1)},
              {"curvature_2", curvature_of(contact.curvature_2)},
              {"relative", relative_of(contact.relative)},
              {"effective_modulus", number_of(analysis.effective_modulus)},
              {"hertz", nullptr},
              {"models", json::array()}};
  if (analysis.hertz) {
    const ContactEllipse& ellipse = analysis.hertz->ellipse;
    const hertz::Contact& hertz = analysis.hertz->contact;
    report["hertz"] = {{"e2", number_of(ellipse.e2)},
                       {"gamma", number_of(ellipse.gamma())},
                       {"beta", number_of(ellipse.beta())},
                       {"force", number_of(hertz.force)},
                       {"a_c", number_of(hertz.a_c)},
                       {"b_c", number_of(hertz.b_c)},
                       {"p_0", number_of(hertz.peak_pressure)},
                       {"stiffness", number_of(hertz.stiffness)},
                       {"energy", number_of(hertz.strain_energy)},
                       {"smallest_radius", number_of(analysis.hertz->smallest_radius)},
                       {"validity", name(hertz.validity)}};
  }
  for (const ModelForce& model : analysis.models) {
    json entry{
        {"model", model.model}, {"relative", relative_of(model.relative)}, {"force", nullptr}, {"error", nullptr}};
    if (model.force) {
      entry["force"] = number_of(*model.force);
      entry["error"] = number_of(*model.force / analysis.hertz->contact.force - 1.0);
    }
    report["models"].push_back(entry);
  }
  return report.dump(2) + "\n";
}

}  // namespace osculate::app
