#include "app/contact_pairs.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "app/pair_comparison.hpp"
#include "io/atomic_file.hpp"
#include "io/pair_table.hpp"
#include "io/progress.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate::app {
namespace {

constexpr std::size_t pairs_per_block = 4096;
constexpr double warm_displacement = 1e-4;
constexpr std::string_view output_header =
    "status,nx,ny,nz,depth,p1x,p1y,p1z,p2x,p2y,p2z,k1max,k1min,k2max,k2min,Ri,Rj\n";

/// Appends ",value" with 17 significant digits: every double comes back as itself.
void append_number(std::string& line, double value) {
  constexpr int digits = 17;
  std::array<char, 32> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  line += ',';
  line.append(text.data(), end);
}

void append_contact(std::string& text, const ContactGeometry& contact) {
  text += name(contact.status);
  for (const double value : contact.normal) append_number(text, value);
  append_number(text, contact.overlap);
  for (const Vec3* point : {&contact.on_1, &contact.on_2})
    for (const double value : *point) append_number(text, value);
  for (const PrincipalCurvatures* curvature : {&contact.curvature_1, &contact.curvature_2}) {
    append_number(text, curvature->max);
    append_number(text, curvature->min);
  }
  append_number(text, contact.relative.R_i);
  append_number(text, contact.relative.R_j);
  text += '\n';
}

/// The pose from which a warm start comes: turned and moved by a small amount in directions that vary from line to
/// line.
Pose displaced(const Pose& pose, const Superquadric& shape, std::size_t line) {
  // Golden-angle spiral: directions spread over the sphere whatever the number of lines.
  constexpr double golden_angle = 2.399963229728653;
  constexpr double golden_fraction = 0.6180339887498949;
  const auto direction = [&](double index) {
    const double z = 2.0 * std::fmod(index * golden_fraction, 1.0) - 1.0;
    const double ring = std::sqrt(1.0 - z * z);
    return Vec3(ring * std::cos(index * golden_angle), ring * std::sin(index * golden_angle), z);
  };
  const auto index = static_cast<double>(line);
  const Eigen::AngleAxisd turn(warm_displacement, direction(index));
  const double distance = warm_displacement * shape.half_axes.minCoeff();
  return {.position = pose.position + distance * direction(index + 0.5),
          .orientation = (turn * pose.orientation).normalized()};
}

/// One block at a time; keeps its memory between blocks.
class PairEvaluator {
 public:
  PairEvaluator(Evaluation evaluation, Start start)
      : solve_(evaluation == Evaluation::batched ? &common_normals : &common_normals_scalar), start_(start) {}

  const ContactColumns& evaluate(const io::PairBlock& block) {
    caches_.resize(0);
    caches_.resize(block.size());
    if (start_ == Start::warm) {
      nearby_.resize(block.size());
      for (std::size_t i = 0; i < block.size(); ++i) {
        const Superquadric shape_2 = block.shape_2(i);
        nearby_.set(i, block.shape_1(i), block.pose_1(i), shape_2, displaced(block.pose_2(i), shape_2, block.lines[i]));
      }
      solve_(nearby_, caches_, contacts_, Gap::resolve, Curvatures::all);
    }
    solve_(block.pairs, caches_, contacts_, Gap::resolve, Curvatures::all);
    return contacts_;
  }

 private:
  decltype(&common_normals) solve_;
  Start start_;
  SuperquadricPairs nearby_;
  ContactCaches caches_;
  ContactColumns contacts_;
};

std::string summary(const std::map<ContactStatus, std::size_t>& counts, double seconds) {
  std::size_t total = 0;
  for (const auto& [status, count] : counts) total += count;
  std::string text = fmt::format("{} pairs in {:.2f} s:", total, seconds);
  for (const auto& [status, count] : counts)
    text += fmt::format("{} {} {}", text.back() == ':' ? "" : ",", count, name(status));
  return text + "\n";
}

}  // namespace

int run_pairs(const PairsRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  io::PairTableReader reader(request.input,
                             request.compare ? io::ReferenceColumns::require : io::ReferenceColumns::ignore);
  std::optional<io::AtomicFile> output;
  if (!request.output.empty()) {
    output.emplace(request.output);
    output->write(output_header);
  }
  PairEvaluator evaluator(request.evaluation, request.start);
  PairComparison comparison;
  std::map<ContactStatus, std::size_t> counts;
  std::string text;
  io::PairBlock block;
  {
    io::Progress progress(request.input);
    while (reader.read(block, pairs_per_block)) {
      const ContactColumns& contacts = evaluator.evaluate(block);
      for (const ContactStatus status : contacts.statuses) ++counts[status];
      if (output) {
        text.clear();
        for (std::size_t i = 0; i < contacts.size(); ++i) append_contact(text, contacts.get(i));
        output->write(text);
      }
      if (request.compare) comparison.add(block, contacts);
      progress.update(reader.progress());
    }
  }
  if (output) output->commit();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  fmt::print("{}", summary(counts, spent.count()));
  if (!request.compare) return 0;
  fmt::print("\n{}", to_text(comparison));
  return comparison.passed() ? 0 : 1;
}

}  // namespace osculate::app
