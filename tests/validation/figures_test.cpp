#include "validation/kildashti2023/figures.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/plot_layout.hpp"
#include "osculate/mechanics/law_registry.hpp"
#include "osculate/mechanics/study_laws.hpp"
#include "validation/kildashti2023/models.hpp"

namespace kildashti2023 = osculate::validation::kildashti2023;
namespace io = osculate::io;

namespace {

const io::Curve& curve(const io::Plot& plot, const std::string& panel, const std::string& name) {
  for (const auto& candidate : plot.panels) {
    if (candidate.title != panel) continue;
    for (const auto& found : candidate.curves)
      if (found.name == name) return found;
  }
  throw std::runtime_error("no curve " + name + " in " + panel);
}

}  // namespace

TEST_CASE("Every figure can be drawn, names its axes and says what was inferred") {
  for (const auto& entry : kildashti2023::figures()) {
    const kildashti2023::Figure figure = entry.compute();
    INFO(entry.name);
    CHECK_NOTHROW(io::validate(figure.plot));
    CHECK(figure.caption.find("Inferred") != std::string::npos);
    for (const auto& panel : figure.plot.panels) {
      CHECK_FALSE(panel.title.empty());
      CHECK_FALSE(panel.x.label.empty());
      CHECK_FALSE(panel.y.label.empty());
    }
  }
}

TEST_CASE("Fig. 4 ends at the normalised forces of Table 1") {
  const io::Plot plot = kildashti2023::figure4().plot;
  const double unit = 1e3 * 4.0 / 3.0 * std::pow(0.02, 1.5);  // 4/3 Ê R_vol^½ δ^{3/2} at 2 % in the figure's 10^{-3}
  const std::string panel = plot.panels[0].title;
  // Five digits are printed; the accurate one is Table 2's, by the exact ellipse.
  CHECK(curve(plot, panel, "accurate: elliptical Hertz").y.back() / unit == Approx(1.5872).margin(5e-5));
  CHECK(curve(plot, panel, "simplified: Gaussian curvature, capped").y.back() / unit == Approx(2.2361).margin(5e-5));
}

TEST_CASE("Fig. 6: a circular contact pulls off at half of 3 pi R W, and every curve bends back at snap-off") {
  const io::Plot plot = kildashti2023::figure6().plot;
  const auto& circle = curve(plot, "Force and overlap", "R_{i}/R_{j} = 1");
  // Sampled every 2 % of the axis: the minimum is flat, so 1e-3 is generous.
  CHECK(*std::min_element(circle.y.begin(), circle.y.end()) == Approx(-0.5).margin(1e-3));
  for (const auto& panel : plot.panels[0].curves) {
    if (panel.name.empty()) continue;
    CHECK(std::min_element(panel.x.begin(), panel.x.end()) == panel.x.begin());
  }
}

TEST_CASE("Fig. 7: the Bessel form of (35) lies on the integral") {
  const io::Plot plot = kildashti2023::figure7().plot;
  const auto& bessel = curve(plot, "Height integrals, any h", "F_{3/2} by (35), h > 0");
  const auto& integral = curve(plot, "Height integrals, any h", "F_{3/2}, force: integral");
  CHECK(bessel.y.back() == Approx(integral.y.back()).epsilon(1e-9));  // both at h = 4; the Bessel form cancels there
  CHECK(bessel.x.back() == integral.x.back());
}

TEST_CASE("Fig. 8: adhesive collisions stick when slow and are viscous when fast") {
  const io::Plot plot = kildashti2023::figure8().plot;
  const auto& adhesive = curve(plot, "Restitution", "viscous, with adhesion (39)");
  const auto& viscous = curve(plot, "Restitution", "viscous (37)");
  CHECK(adhesive.y.front() == 0.0);
  CHECK(adhesive.y.back() == Approx(viscous.y.back()).margin(3e-3));  // what is left of the adhesive energy at 30 m/s
  CHECK(std::is_sorted(viscous.y.rbegin(), viscous.y.rend()));
}

TEST_CASE("Tables 4 to 6 hold every law of the registry and every theory for studies once") {
  std::size_t rows = 0;
  for (const auto& models : kildashti2023::model_tables()) {
    rows += models.table.rows.size();
    CHECK_FALSE(models.table.rows.empty());
  }
  CHECK(rows == osculate::law_registry().size() + osculate::study_laws().size());
}
