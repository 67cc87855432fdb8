#include "osculate/mechanics/law_registry.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "mechanics/law_bed.hpp"
#include "mechanics/law_choices.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;
using Catch::Matchers::Contains;

namespace {

void refused(const LawChoice& choice, const std::string& reason, const ElasticMaterial& material = glass) {
  REQUIRE_THROWS_AS(make_contact_law(choice, material, material), InputError);
  CHECK_THROWS_WITH(make_contact_law(choice, material, material), Contains(reason));
}

const ChosenLaw hertz{"hertz", {}}, linear{"linear", {{"stiffness", 1e6}}};
const ChosenLaw jkr{"jkr", {{"work_of_adhesion", 0.1}}};
const ChosenLaw plastic{"jamari_schipper",
                        {{"hardness", 2e9}, {"yield_factor", 0.6}, {"plastic_factor", 0.9}, {"area_ratio", 120.0}}};
const ChosenLaw rough{"greenwood_williamson", {{"density", 1e11}, {"asperity_radius", 1e-5}, {"deviation", 1e-7}}};

}  // namespace

TEST_CASE("Every law of the registry is described") {
  std::set<std::string_view> names;
  LawSlot last = LawSlot::normal;
  for (const LawDescription* law : law_registry()) {
    INFO(law->name);
    CHECK(names.insert(law->name).second);
    CHECK(law->slot >= last);
    last = law->slot;
    CHECK(!law->title.empty());
    CHECK(!law->formula.empty());
    CHECK(!law->source.empty());
    CHECK(&law_named(law->name) == law);
    for (const LawParameter& parameter : law->parameters) {
      INFO(parameter.name);
      CHECK(!parameter.meaning.empty());
      CHECK(!parameter.symbol.empty());
      if (parameter.standard) CHECK(parameter.allows(*parameter.standard));
    }
    for (const LawConflict& conflict : law->conflicts) {
      CHECK(!conflict.reason.empty());
      const bool is_slot = [&] {
        for (std::size_t s = 0; s < law_slots; ++s)
          if (name(static_cast<LawSlot>(s)) == conflict.other) return true;
        return false;
      }();
      if (!is_slot) CHECK_NOTHROW(law_named(conflict.other));
      for (const std::string_view but : conflict.but) CHECK_NOTHROW(law_named(but));
    }
  }
}

TEST_CASE("The memory that the registry tells is the memory that a law takes") {
  for (const NamedChoice& one : law_choices()) {
    INFO(one.name);
    std::size_t told = 0;
    for (const ChosenLaw& law : one.choice) told += law_named(law.name).memory;
    const ContactLaw law = make_contact_law(one.choice, glass, glass);
    CHECK(law.memory_size() == told);
    CHECK(law.memory_length(0) == 0);
    CHECK(law.memory_length(9) == 16 * told);
  }
}

TEST_CASE("A choice that is none is refused with what was expected") {
  refused({{"herz", {}}}, "hertz");
  refused({}, "no normal law");
  refused({{"mindlin", {{"friction", 0.3}}}}, "no normal law");
  refused({hertz, linear}, "one law of the slot");
  refused({hertz, {"mindlin", {}}}, "friction coefficient");
  refused({hertz, {"mindlin", {{"friction", 0.3}, {"mu", 0.3}}}}, "one of friction");
  refused({{"hertz", {{"modulus", 1e9}}}}, "no parameters");
}

TEST_CASE("Laws that do not go together are refused with the reason") {
  refused({hertz, jkr, plastic}, "peels");
  refused({hertz, rough, jkr}, "tension");
  refused({hertz, rough, plastic}, "asperities are elastic");
  refused({linear, jkr}, "elliptical");
  refused({{"hertz_sphere", {}}, plastic}, "elliptical");
  refused({linear, {"mindlin", {{"friction", 0.3}}}}, "Hertz pressure");
  refused({hertz, jkr, {"mindlin", {{"friction", 0.3}}}}, "Hertz pressure");
  refused({hertz, plastic, {"di_renzo", {{"friction", 0.3}}}}, "cundall_strack");
  refused({linear, {"tsuji", {{"restitution", 0.9}}}}, "Hertz");
  refused({hertz, {"linear_dashpot", {{"restitution", 0.9}}}}, "linear spring");
  refused({hertz, jkr, {"tsuji", {{"restitution", 0.9}}}}, "without adhesion");
  refused({hertz, {"vermeulen_johnson", {{"friction", 0.3}}}, {"sliding", {{"friction", 0.3}}}}, "creepage");
  refused({hertz, {"vermeulen_johnson", {{"friction", 0.3}}}, {"twisting", {{"friction", 0.3}}}}, "spin moment");
}

TEST_CASE("Bad parameters are refused at set-up") {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double friction : {-0.1, nan, infinity}) refused({hertz, {"mindlin", {{"friction", friction}}}}, ">= 0");
  refused({hertz, {"jkr", {{"work_of_adhesion", -0.1}}}}, "J/m^2");
  for (const double restitution : {0.0, -0.5, 1.1})
    refused({hertz, {"tsuji", {{"restitution", restitution}}}}, "in (0, 1]");
  ChosenLaw bad = plastic;
  bad.parameters["plastic_factor"] = 0.0;
  refused({hertz, bad}, "> 0");
  bad.parameters["plastic_factor"] = 0.1;  // below 2/3 K_v
  refused({hertz, bad}, "2/3");
  bad = plastic;
  bad.parameters["area_ratio"] = 5.0;
  bad.parameters["plastic_factor"] = 3.0;
  refused({hertz, bad}, "energy");
  bad = rough;
  bad.parameters["deviation"] = 0.0;
  refused({hertz, bad}, "> 0");
  bad = rough;
  bad.parameters["asperity_radius"] = -1e-6;
  refused({hertz, bad}, "> 0");
  refused({hertz, {"twisting", {{"friction", 0.3}}}}, "Poisson", {.youngs_modulus = 1e7, .poissons_ratio = 0.5});
  refused({hertz}, "Young's modulus", {.youngs_modulus = 0.0, .poissons_ratio = 0.3});
  refused({{"walton_braun", {{"loading_stiffness", 2e6}, {"unloading_stiffness", 1e6}}}}, "at least the loading");
}

TEST_CASE("The interaction range is the gap up to which the law acts") {
  const double R_i = 2e-3, R_j = 1e-3;
  CHECK(make_contact_law({hertz}, glass, glass).interaction_range(R_i, R_j) == 0.0);
  for (const ChosenLaw& part : {jkr, rough}) {
    INFO(part.name);
    const ContactLaw law = make_contact_law({hertz, part}, glass, glass);
    const double range = law.interaction_range(R_i, R_j);
    REQUIRE(range > 0.0);
    LawBed bed(law, 1);
    bed.set(0, {.R_i = R_i, .R_j = R_j, .overlap = 0.1 * range});
    bed.evaluate(law);
    REQUIRE(bed.status[0] == LawStatus::closed);
    bed.set(0, {.R_i = R_i, .R_j = R_j, .overlap = -0.999 * range});
    bed.evaluate(law);
    CHECK(bed.status[0] == LawStatus::closed);
    CHECK(bed.normal_force[0] != 0.0);
    bed.set(0, {.R_i = R_i, .R_j = R_j, .overlap = -1.001 * range});
    bed.evaluate(law);
    CHECK(bed.status[0] == LawStatus::open);
    CHECK(bed.normal_force[0] == 0.0);
  }
  CHECK_THROWS_AS(make_contact_law({hertz}, glass, glass).interaction_range(1e-3, 2e-3), InputError);
}
