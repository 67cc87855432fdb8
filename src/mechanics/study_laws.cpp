#include "osculate/mechanics/study_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mechanics/laws/parameters.hpp"
#include "osculate/core/error.hpp"
#include "osculate/mechanics/brilliantov.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/mechanics/hisakado.hpp"
#include "osculate/mechanics/jeng_wang.hpp"
#include "osculate/mechanics/mindlin.hpp"
#include "osculate/mechanics/polygon_energy.hpp"

namespace osculate {
namespace {

constexpr auto excluded = LawParameter::Bound::excluded;
constexpr double any_sign = -std::numeric_limits<double>::infinity();

class Given {
 public:
  explicit Given(const std::map<std::string, double>& parameters) : parameters_(parameters) {}
  double operator[](const char* name) const { return parameters_.at(name); }
  ElasticMaterial body_1() const { return {.youngs_modulus = (*this)["E"], .poissons_ratio = (*this)["nu"]}; }
  ElasticMaterial body_2() const { return {.youngs_modulus = (*this)["E_2"], .poissons_ratio = (*this)["nu_2"]}; }

 private:
  const std::map<std::string, double>& parameters_;
};
using Numbers = std::map<std::string, double>;

constexpr LawParameter positive(std::string_view name, std::string_view symbol, std::string_view unit,
                                std::string_view meaning, std::optional<double> standard) {
  return {
      .name = name, .symbol = symbol, .unit = unit, .meaning = meaning, .least_bound = excluded, .standard = standard};
}
constexpr LawParameter signed_number(std::string_view name, std::string_view symbol, std::string_view unit,
                                     std::string_view meaning, double standard) {
  return {.name = name, .symbol = symbol, .unit = unit, .meaning = meaning, .least = any_sign, .standard = standard};
}
constexpr LawParameter poisson(std::string_view name, std::string_view symbol, std::string_view meaning) {
  return {.name = name,
          .symbol = symbol,
          .unit = "",
          .meaning = meaning,
          .least = -1.0,
          .least_bound = excluded,
          .most = 0.5,
          .standard = 0.22};
}
constexpr LawParameter E_1 = positive("E", "E", "Pa", "Young's modulus of body 1", 71e9),
                       E_2 = positive("E_2", "E_2", "Pa", "Young's modulus of body 2", 71e9),
                       nu_1 = poisson("nu", "ν", "Poisson's ratio of body 1"),
                       nu_2 = poisson("nu_2", "ν_2", "Poisson's ratio of body 2"),
                       density = positive("density", "χ", "1/m^2", "asperities per area", {}),
                       summit = positive("asperity_radius", "β", "m", "radius of an asperity's summit", {}),
                       deviation = positive("deviation", "σ", "m", "standard deviation of the summits' heights", {}),
                       area = positive("nominal_area", "A", "m^2", "area of the patch", 1e-6),
                       separation =
                           signed_number("h", "h", "", "separation of the mean planes over σ, of either sign", 1.0),
                       friction{.name = "friction", .symbol = "μ", .unit = "", .meaning = "friction coefficient"};

// Greenwood and Williamson, the separation prescribed.

constexpr std::array greenwood_parameters{density, summit, deviation, area, separation, E_1, nu_1, E_2, nu_2};
constexpr std::array greenwood_results{
    StudyResult{"force", "force F", "N"}, StudyResult{"real_area", "area of true contact", "m^2"},
    StudyResult{"touching", "asperities in contact", ""}, StudyResult{"stiffness", "stiffness −dF/dd", "N/m"}};
std::vector<double> greenwood(const Numbers& numbers) {
  const Given at(numbers);
  const greenwood_williamson::Roughness roughness{
      .density = at["density"], .radius = at["asperity_radius"], .deviation = at["deviation"]};
  const auto patch = greenwood_williamson::patch_at(roughness, effective_modulus(at.body_1(), at.body_2()),
                                                    at["nominal_area"], at["h"]);
  return {patch.force, patch.real_area, patch.touching, patch.stiffness};
}
constexpr StudyLaw greenwood_williamson_patch{
    .name = "greenwood_williamson_patch",
    .slot = LawSlot::roughness,
    .title = "Elastic asperities at a prescribed separation",
    .formula = "F = 4/3 χ A Ê β^{1/2} σ^{3/2} ∫ (z − h)^{3/2} φ dz over z > h",
    .equations = "(29)-(36)",
    .source = "GW66",
    .reason = "the separation of its planes is prescribed; greenwood_williamson finds it from the overlap",
    .parameters = greenwood_parameters,
    .results = greenwood_results,
    .shown = "h",
    .shown_from = -2.0,
    .shown_to = 4.0,
    .answer = greenwood};

// Jeng and Wang.

constexpr std::array jeng_wang_parameters{
    density,
    positive("R_i", "R_i", "m", "larger radius of an asperity's summit, at least R_j", {}),
    positive("R_j", "R_j", "m", "smaller radius of an asperity's summit", {}),
    deviation,
    positive("hardness", "H", "Pa", "hardness of the softer body", {}),
    LawParameter{.name = "yield_ratio",
                 .symbol = "k",
                 .unit = "",
                 .meaning = "mean pressure at first yield over H",
                 .least_bound = excluded,
                 .most = 1.0,
                 .standard = 0.4},
    LawParameter{.name = "plastic_ratio",
                 .symbol = "δ_n2/δ_n1",
                 .unit = "",
                 .meaning = "full over first plasticity",
                 .least = 1.0,
                 .least_bound = excluded,
                 .standard = 54.0},
    area,
    separation,
    signed_number("centre", "h_0", "", "separation about which the series (53) is taken", 1.0),
    E_1,
    nu_1,
    E_2,
    nu_2};
constexpr std::array jeng_wang_results{
    StudyResult{"force", "force F", "N"},
    StudyResult{"force_elastic", "of elastic asperities", "N"},
    StudyResult{"force_elastic_plastic", "of elastic-plastic asperities", "N"},
    StudyResult{"force_plastic", "of plastic asperities", "N"},
    StudyResult{"force_series", "by the series (53)", "N"},
    StudyResult{"real_area", "area of true contact", "m^2"},
    StudyResult{"area_elastic", "of elastic asperities", "m^2"},
    StudyResult{"area_elastic_plastic", "of elastic-plastic asperities", "m^2"},
    StudyResult{"area_plastic", "of plastic asperities", "m^2"},
    StudyResult{"area_series", "by the series (53)", "m^2"},
};
std::vector<double> jeng_wang_answer(const Numbers& numbers) {
  const Given at(numbers);
  const jeng_wang::Surface surface{.density = at["density"],
                                   .R_i = at["R_i"],
                                   .R_j = at["R_j"],
                                   .deviation = at["deviation"],
                                   .modulus = effective_modulus(at.body_1(), at.body_2()),
                                   .hardness = at["hardness"],
                                   .yield_ratio = at["yield_ratio"],
                                   .plastic_ratio = at["plastic_ratio"]};
  const jeng_wang::Patch patch = jeng_wang::patch_at(surface, at["nominal_area"], at["h"]);
  const jeng_wang::TaylorSeries series(surface, at["nominal_area"], at["centre"]);
  const auto& [elastic, mixed, plastic] = patch.force_by_regime;
  const auto& [elastic_area, mixed_area, plastic_area] = patch.area_by_regime;
  return {patch.force, elastic,      mixed,      plastic,      series.force(at["h"]),
          patch.area,  elastic_area, mixed_area, plastic_area, series.area(at["h"])};
}
constexpr StudyLaw jeng_wang_patch{
    .name = "jeng_wang",
    .slot = LawSlot::roughness,
    .title = "Elastic, elastic-plastic and plastic asperities at a prescribed separation",
    .formula = "F = χ A ∫ F_k(σ(z − h)) φ dz over z > h, F_k Hertz's to δ_n1, H A_k from δ_n2",
    .equations = "(47)-(53)",
    .source = "JW03, ZMC00",
    .reason =
        "it has no law of unloading, so that a contact pressed and released again would give energy back that "
        "went into flow",
    .parameters = jeng_wang_parameters,
    .results = jeng_wang_results,
    .shown = "h",
    .shown_from = 0.0,
    .shown_to = 2.0,
    .answer = jeng_wang_answer};

// Hisakado and Tsukizoe.

constexpr std::array hisakado_parameters{
    summit,
    deviation,
    positive("asperities", "N", "", "density times nominal area", {}),
    friction,
    separation,
    signed_number("displacement", "δ_t", "m", "tangential displacement", 0.0),
    positive("interference", "w", "m", "of the one asperity whose radius and compliance are given", 1e-7),
    E_1,
    nu_1,
    E_2,
    nu_2};
constexpr std::array hisakado_results{
    StudyResult{"tangential_force", "tangential force F_t", "N"},
    StudyResult{"normal_force", "normal force F_n", "N"},
    StudyResult{"stiffness", "stiffness before slip", "N/m"},
    StudyResult{"sliding_share", "share of touching asperities that slide", ""},
    StudyResult{"sliding_interference", "interference below which an asperity slides", "m"},
    StudyResult{"asperity_contact_radius", "contact radius of an asperity", "m"},
    StudyResult{"asperity_compliance", "compliance of an asperity without slip", "m/N"}};
std::vector<double> hisakado_answer(const Numbers& numbers) {
  const Given at(numbers);
  const auto surface = hisakado::surface(at["asperity_radius"], at["deviation"], at["asperities"], at.body_1(),
                                         at.body_2(), at["friction"]);
  const double h = at["h"], displacement = at["displacement"], interference = at["interference"];
  return {hisakado::tangential_force(surface, h, displacement),
          hisakado::normal_force(surface, h),
          hisakado::stiffness(surface, h),
          hisakado::sliding_share(surface, h, displacement),
          hisakado::sliding_interference(surface, std::fabs(displacement)),
          hisakado::asperity_contact_radius(surface, interference),
          hisakado::asperity_compliance(surface, interference)};
}
constexpr StudyLaw hisakado_tsukizoe{
    .name = "hisakado_tsukizoe",
    .slot = LawSlot::tangential,
    .title = "Partial slip of a rough contact, asperity by asperity",
    .formula = "F_t = μ {F_n(h) − F_n(h + δ_t/(μκσ))}",
    .equations = "(78)-(84)",
    .source = "HT74",
    .reason = "it is the first loading at a constant separation, and says nothing of a displacement that turns",
    .parameters = hisakado_parameters,
    .results = hisakado_results,
    .shown = "displacement",
    .shown_from = 0.0,
    .shown_to = 1e-7,
    .answer = hisakado_answer};

// Tangential dissipation.

constexpr std::array dissipation_parameters{
    positive("shear_viscosity", "η_1", "Pa s", "shear viscosity of the bodies", {}),
    LawParameter{.name = "slip",
                 .symbol = "δ_t/δ_t,max",
                 .unit = "",
                 .meaning = "displacement over that of full slip",
                 .standard = 0.0},
    signed_number("rate", "dδ_t/dt", "m/s", "tangential speed", 0.1),
    positive("R_i", "R_i", "m", "larger radius of relative curvature, at least R_j", 2e-3),
    positive("R_j", "R_j", "m", "smaller radius of relative curvature", 1e-3),
    positive("overlap", "δ", "m", "overlap", 1e-6),
    E_1,
    nu_1};
constexpr std::array dissipation_results{StudyResult{"force", "dissipative force, major axis", "N"},
                                         StudyResult{"force_y", "minor axis", "N"},
                                         StudyResult{"no_slip_stiffness", "stiffness before slip, major axis", "N/m"},
                                         StudyResult{"no_slip_stiffness_y", "minor axis", "N/m"}};
std::vector<double> dissipation_answer(const Numbers& numbers) {
  const Given at(numbers);
  if (!(at["R_i"] >= at["R_j"])) throw InputError("tangential_dissipation", "R_i < R_j", "R_i >= R_j > 0 [m]");
  const ElasticMaterial body = at.body_1();
  const ContactEllipse ellipse = contact_ellipse(at["R_i"], at["R_j"]);
  const auto hertz = hertz::contact(ellipse, effective_modulus(body, body), at["overlap"], at["R_j"]);
  const auto ratio = mindlin::compliance_ratio(ellipse, body, body);
  const double along = hertz.stiffness / ratio.major, across = hertz.stiffness / ratio.minor;
  const double modulus = body.youngs_modulus / (2.0 * (1.0 + body.poissons_ratio));
  const auto force = [&](double stiffness) {
    return brilliantov::tangential_dissipative_force(at["shear_viscosity"], modulus, stiffness, at["slip"], at["rate"]);
  };
  return {force(along), force(across), along, across};
}
constexpr StudyLaw tangential_dissipation{
    .name = "tangential_dissipation",
    .slot = LawSlot::tangential,
    .title = "Viscous tangential force of Mindlin's first loading, two equal bodies",
    .formula = "F_t,dis = (η_1/G) dδ_t/dt dF_t/dδ_t, dF_t/dδ_t ∝ {1 − δ_t/δ_t,max}^{1/2}",
    .equations = "(85)",
    .source = "KDY23",
    .reason =
        "δ_t/δ_t,max is known in a first loading alone; langston and zheng have a spring and a dashpot for any path",
    .parameters = dissipation_parameters,
    .results = dissipation_results,
    .shown = "slip",
    .shown_from = 0.0,
    .shown_to = 1.0,
    .answer = dissipation_answer};

// Feng and Owen's polygons, regular ones here.

constexpr LawParameter sides(std::string_view name, std::string_view symbol, std::string_view meaning) {
  return {.name = name,
          .symbol = symbol,
          .unit = "",
          .meaning = meaning,
          .least = 3.0,
          .most = 1000.0,
          .most_bound = LawParameter::Bound::included,
          .standard = 4.0};
}
constexpr std::array polygon_parameters{
    positive("coefficient", "k", "J/m^{2m}", "of the energy W = k A^m", {}),
    LawParameter{.name = "exponent",
                 .symbol = "m",
                 .unit = "",
                 .meaning = "of the energy; 1 is the linear function",
                 .least = 1.0,
                 .standard = 1.0},
    sides("sides_1", "n_1", "sides of body 1, whole"),
    sides("sides_2", "n_2", "sides of body 2, whole"),
    positive("radius_1", "r_1", "m", "circumradius of body 1", 1e-3),
    positive("radius_2", "r_2", "m", "circumradius of body 2", 1e-3),
    signed_number("x", "x", "m", "place x of body 2; body 1 stands at 0, a vertex on the x axis", 1.7e-3),
    signed_number("y", "y", "m", "place y of body 2", 2e-4),
    signed_number("turn", "θ", "rad", "turn of body 2", 0.2)};
constexpr std::array polygon_results{StudyResult{"force_x", "force on body 2 along x", "N"},
                                     StudyResult{"force_y", "force on body 2 along y", "N"},
                                     StudyResult{"moment_1", "moment on body 1", "N m"},
                                     StudyResult{"moment_2", "moment on body 2", "N m"},
                                     StudyResult{"area", "overlap A", "m^2"},
                                     StudyResult{"energy", "energy W", "J"}};

polygon_energy::Polygon regular(double count, double radius, const polygon_energy::Vec2& centre, double turn) {
  if (count != std::floor(count))
    throw InputError("polygon_energy", "sides that are no whole number", "a whole number");
  polygon_energy::Polygon polygon;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / count;
    polygon.emplace_back(centre + radius * polygon_energy::Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}
std::vector<double> polygon_answer(const Numbers& numbers) {
  const Given at(numbers);
  const polygon_energy::Vec2 centre_1(0.0, 0.0), centre_2(at["x"], at["y"]);
  const auto body_1 = regular(at["sides_1"], at["radius_1"], centre_1, 0.0);
  const auto body_2 = regular(at["sides_2"], at["radius_2"], centre_2, at["turn"]);
  const polygon_energy::EnergyFunction function{.coefficient = at["coefficient"], .exponent = at["exponent"]};
  const auto contact = polygon_energy::contact(body_1, centre_1, body_2, centre_2, function);
  return {contact.force_on_2.x(), contact.force_on_2.y(), contact.moment_on_1,
          contact.moment_on_2,    contact.area,           contact.energy};
}
constexpr StudyLaw polygons{.name = "polygon_energy",
                            .slot = LawSlot::normal,
                            .title = "Energy-conserving contact of regular polygons in the plane",
                            .formula = "F = −W'(A) ∂A/∂x, M = −W'(A) ∂A/∂θ, W = k A^m",
                            .equations = "(54),(55)",
                            .source = "FO04",
                            .reason =
                                "it is a theory of two dimensions: its force comes from an area of overlap, not "
                                "from a common normal and radii of curvature",
                            .parameters = polygon_parameters,
                            .results = polygon_results,
                            .shown = "x",
                            .shown_from = 1.2e-3,
                            .shown_to = 2e-3,
                            .answer = polygon_answer};

constexpr std::array all{&polygons, &greenwood_williamson_patch, &jeng_wang_patch, &hisakado_tsukizoe,
                         &tangential_dissipation};

}  // namespace

std::span<const StudyLaw* const> study_laws() {
  return all;
}

const StudyLaw* study_law(std::string_view name) {
  const auto* const found = std::ranges::find_if(all, [&](const StudyLaw* law) { return law->name == name; });
  return found == all.end() ? nullptr : *found;
}

std::vector<double> evaluate(const StudyLaw& law, const std::map<std::string, double>& parameters) {
  return law.answer(laws::completed(parameters, law.parameters, "law " + std::string(law.name)));
}

}  // namespace osculate
