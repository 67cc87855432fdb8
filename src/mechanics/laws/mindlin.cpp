// Partial slip with memory.

#include <algorithm>
#include <array>
#include <cmath>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/mindlin_contacts.hpp"

namespace osculate::laws {
namespace {

constexpr std::size_t memory_size = sizeof(mindlin::MemoryBlock) / sizeof(double) / mindlin::MemoryBlock::width;
static_assert(mindlin::MemoryBlock::width == law_lanes);

constexpr std::array parameters{friction_parameter};
constexpr std::array<std::string_view, 2> hertzian{"hertz", "hertz_sphere"};
constexpr std::string_view reason = "its springs are those of a Hertz pressure; take a law with one spring instead";
constexpr std::array conflicts{LawConflict{"normal", reason, hertzian}, LawConflict{"adhesion", reason},
                               LawConflict{"roughness", reason}, LawConflict{"plasticity", reason}};

// Entries in the order of mindlin::MemoryBlock.
mindlin::Memory read(const Memory& memory) {
  constexpr std::size_t count = mindlin::layers;
  mindlin::Memory result;
  result.springs.overlap = memory[0];
  result.springs.count = static_cast<std::int64_t>(memory[1]);
  for (std::size_t k = 0; k < 3; ++k) result.normal[k] = memory[2 + k], result.axis[k] = memory[5 + k];
  for (std::size_t k = 0; k < count; ++k)
    result.springs.at[k] = {memory[8 + k] * memory[8 + k], memory[8 + count + k], memory[8 + 2 * count + k]};
  return result;
}

void write(const mindlin::Memory& from, const Memory& memory) {
  constexpr std::size_t count = mindlin::layers;
  memory[0] = from.springs.overlap;
  memory[1] = static_cast<double>(from.springs.count);
  for (std::size_t k = 0; k < 3; ++k) memory[2 + k] = from.normal[k], memory[5 + k] = from.axis[k];
  for (std::size_t k = 0; k < count; ++k) {
    const mindlin::Layer& layer = from.springs.at[k];
    memory[8 + k] = std::sqrt(layer.depth), memory[8 + count + k] = layer.x, memory[8 + 2 * count + k] = layer.y;
  }
}

Part bind(const Binding& binding) {
  const double friction = binding["friction"];
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  const auto step = [friction, modulus, material_1 = binding.material_1, material_2 = binding.material_2](
                        Contact& contact, Memory memory) {
    mindlin::Memory springs = read(memory);
    if (!contact.closed && springs.springs.count == 0) return;
    const ContactEllipse& ellipse = contact.ellipse();
    const auto ratio = mindlin::compliance_ratio(ellipse, material_1, material_2);
    const double coefficient = hertz::force(ellipse, modulus, 1.0);
    const mindlin::Step motion{
        .normal = contact.normal,
        .major_axis = contact.major,
        .overlap = contact.overlap,
        .displacement = contact.displacement().x * contact.major + contact.displacement().y * contact.minor,
        .spin = contact.spin};
    // Every spring slides at the same share of its limit as the load is of the elastic one; held finite for δ → 0.
    constexpr double unlimited = 1e30;
    const double load =
        contact.elastic > 0.0 ? std::min(friction_load(contact) / contact.elastic, unlimited) : unlimited;
    const mindlin::Law law{.coefficient = coefficient, .compliance_ratio = ratio, .friction = friction * load};
    const mindlin::Springs turned = mindlin::carried(springs, motion);
    const double stored_before = turned.count > 0 ? mindlin::stored_energy(turned, coefficient, ratio) : 0.0;
    if (!contact.closed) {
      contact.friction_loss += stored_before;
      write({}, memory);
      return;
    }
    const mindlin::Planar before = turned.count > 0 ? mindlin::traction(turned) : mindlin::Planar{0.0, 0.0};
    const Vec3 force = mindlin::advance(springs, law, motion);
    write(springs, memory);
    contact.force = {force.dot(contact.major), force.dot(contact.minor)};
    contact.stored_tangential = mindlin::stored_energy(springs.springs, coefficient, ratio);
    contact.friction_loss += work(contact, {coefficient * before.x, coefficient * before.y}, contact.force) -
                             (contact.stored_tangential - stored_before);
  };
  return {.step = step, .needs = {.mean_angular_velocity = true}};
}

}  // namespace

const Law mindlin{{.name = "mindlin",
                   .slot = LawSlot::tangential,
                   .title = "Cattaneo-Mindlin-Deresiewicz partial slip along any path",
                   .formula = "F_t = ∫ s(η) F''(η) dη, |s(η)| ≤ μ(δ − η)",
                   .equations = "(56)-(76)",
                   .source = "Jaeger93, Ciavarella98, PH15",
                   .parameters = parameters,
                   .memory = memory_size,
                   .conflicts = conflicts},
                  bind};

}  // namespace osculate::laws
