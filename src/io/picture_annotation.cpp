#include "io/picture_annotation.hpp"

#include <cairo/cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/atomic_file.hpp"
#include "io/units.hpp"

namespace osculate::io {
namespace {

constexpr double margin = 48.0;
constexpr double title_size = 28.0, text_size = 19.0;
constexpr double bar_width = 26.0, bar_room = 170.0;
constexpr double foot = 84.0;  // scale bar and its margin
constexpr double axis_length = 44.0;
constexpr double side = margin + axis_length;  // keeps wide bodies off the axes

double note_height() {
  return 1.45 * text_size;
}

double title_height(const Picture& picture) {
  return margin + (picture.title.empty() ? 0.0 : title_size) +
         note_height() * static_cast<double>(picture.notes.size());
}

/// Where the axes' origin stands, and the view they share.
Projection axes_projection(const Projection& projection) {
  return {.to_view = projection.to_view,
          .centre = Vec3::Zero(),
          .scale = axis_length,
          .middle = Vec3(margin + axis_length, margin + axis_length, 0.0)};
}

constexpr std::pair<const char*, Colour> axes[3] = {{"x", palette::red}, {"y", palette::green}, {"z", palette::blue}};

/// A cairo drawing over an image.
class Drawing {
 public:
  explicit Drawing(const Image& image)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height), &cairo_surface_destroy),
        cairo_(cairo_create(surface_.get()), &cairo_destroy) {
    cairo_surface_flush(surface_.get());
    unsigned char* const data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < image.height; ++y) {
      auto* const row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(stride) * y);
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* const rgb = image.pixels.data() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
        row[x] = static_cast<std::uint32_t>(rgb[0] << 16 | rgb[1] << 8 | rgb[2]);
      }
    }
    cairo_surface_mark_dirty(surface_.get());
    cairo_set_line_cap(cairo_.get(), CAIRO_LINE_CAP_BUTT);
  }

  void colour(const Colour& colour) { cairo_set_source_rgb(cairo_.get(), colour.red, colour.green, colour.blue); }

  /// Text with its baseline at y; `align` is the fraction of its width left of x. A white rim keeps it readable.
  void text(const std::string& text, double x, double y, double size, double align, const Colour& ink) {
    cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), text.c_str(), &extents);
    cairo_move_to(cairo_.get(), x - align * extents.x_advance, y);
    cairo_text_path(cairo_.get(), text.c_str());
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo_.get(), 4.0);
    colour({1.0, 1.0, 1.0});
    cairo_stroke_preserve(cairo_.get());
    colour(ink);
    cairo_fill(cairo_.get());
  }

  void rectangle(double x, double y, double width, double height, const Colour& ink) {
    cairo_rectangle(cairo_.get(), x, y, width, height);
    colour(ink);
    cairo_fill(cairo_.get());
  }

  void triangle(double x1, double y1, double x2, double y2, double x3, double y3, const Colour& ink) {
    cairo_move_to(cairo_.get(), x1, y1);
    cairo_line_to(cairo_.get(), x2, y2);
    cairo_line_to(cairo_.get(), x3, y3);
    cairo_close_path(cairo_.get());
    colour(ink);
    cairo_fill(cairo_.get());
  }

  /// viridis from 0 at the lower edge to 1 at the upper.
  void colour_ramp(double x, double y, double width, double height) {
    const std::unique_ptr<cairo_pattern_t, decltype(&cairo_pattern_destroy)> ramp(
        cairo_pattern_create_linear(0.0, y + height, 0.0, y), &cairo_pattern_destroy);
    constexpr int stops = 64;
    for (int i = 0; i <= stops; ++i) {
      const double value = static_cast<double>(i) / stops;
      const Colour c = viridis(value);
      cairo_pattern_add_color_stop_rgb(ramp.get(), value, c.red, c.green, c.blue);
    }
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_set_source(cairo_.get(), ramp.get());
    cairo_fill(cairo_.get());
  }

  /// The drawing as a PNG file.
  std::string png() {
    const auto append = [](void* target, const unsigned char* data, unsigned int length) {
      static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
      return CAIRO_STATUS_SUCCESS;
    };
    std::string file;
    cairo_surface_flush(surface_.get());
    const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &file);
    if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
    return file;
  }

 private:
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

/// The largest of 1, 2 and 5 times a power of ten that is not above `value`.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= value * (1.0 + 1e-12)) return digit * power;
  }
  return power;
}

std::string length_text(double metres) {
  const Unit unit = suitable_length(metres);
  return fmt::format("{:.6g} {}", metres / unit.in_si, unit.symbol);
}

void draw_scale_bar(Drawing& drawing, const Picture& picture, const Projection& projection) {
  const double metres = round_down(0.2 * picture.width / projection.scale);
  const double length = metres * projection.scale, thickness = 5.0;
  const double x = projection.middle.x() - 0.5 * length, y = picture.height - margin;
  drawing.rectangle(x, y, length, thickness, palette::black);
  drawing.text(length_text(metres), projection.middle.x(), y - 9.0, text_size, 0.5, palette::black);
}

void draw_colour_bar(Drawing& drawing, const Picture& picture, const ColourBar& bar) {
  bool below = false, above = false;
  const double span = bar.upper - bar.lower;
  const auto look = [&](const std::vector<double>& scalars) {
    for (const double value : scalars) {
      below = below || value < bar.lower - 1e-6 * span;
      above = above || value > bar.upper + 1e-6 * span;
    }
  };
  for (const PictureBody& body : picture.bodies) look(body.scalars);
  for (const PictureSwarm& swarm : picture.swarms) look(swarm.scalars);
  const Frame frame = free_frame(picture);
  const double x = picture.width - margin - bar_room + 60.0, height = 0.78 * frame.height;
  const double top = frame.top + 0.5 * (frame.height - height) + 14.0, bottom = top + height;
  drawing.colour_ramp(x, top, bar_width, height);
  const double tip = 0.8 * bar_width;
  if (above) drawing.triangle(x, top, x + bar_width, top, x + 0.5 * bar_width, top - tip, viridis(1.0));
  if (below) drawing.triangle(x, bottom, x + bar_width, bottom, x + 0.5 * bar_width, bottom + tip, viridis(0.0));

  const double step = round_down(span / 4.0);
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const auto first = static_cast<long>(std::ceil(bar.lower / step - 1e-9));
  const auto last = static_cast<long>(std::floor(bar.upper / step + 1e-9));
  for (long i = first; i <= last; ++i) {
    const double tick = static_cast<double>(i) * step, y = bottom - height * (tick - bar.lower) / span;
    const std::string label =
        decimals > 5 || std::fabs(tick) >= 1e6 ? fmt::format("{:.3g}", tick) : fmt::format("{:.{}f}", tick, decimals);
    drawing.rectangle(x + bar_width, y - 0.75, 7.0, 1.5, palette::black);
    drawing.text(label, x + bar_width + 12.0, y + 0.36 * text_size, text_size, 0.0, palette::black);
  }
  drawing.text(bar.title, picture.width - margin, top - tip - 16.0, text_size, 1.0, palette::black);
}

}  // namespace

Frame free_frame(const Picture& picture) {
  const double top = title_height(picture) + 26.0;
  const double right = picture.colour_bar ? bar_room + 20.0 : 0.0;
  return {side, top, picture.width - side - margin - right, picture.height - top - foot - 20.0};
}

void add_axes(PictureTriangles& triangles, const Projection& projection) {
  const Projection corner = axes_projection(projection);
  for (int i = 0; i < 3; ++i) {
    add_arrow(triangles, {.from = Vec3::Zero(), .to = Vec3::Unit(i), .colour = axes[i].second, .width = 4.0}, corner);
  }
}

void write_annotated(const Image& image, const Picture& picture, const Projection& projection,
                     const std::filesystem::path& path) {
  Drawing drawing(image);
  double y = margin + 0.75 * title_size;
  drawing.text(picture.title, margin, y, title_size, 0.0, palette::black);
  for (const std::string& note : picture.notes) {
    y += note_height();
    drawing.text(note, margin, y, text_size, 0.0, {0.35, 0.36, 0.40});
  }
  if (picture.colour_bar) draw_colour_bar(drawing, picture, *picture.colour_bar);
  draw_scale_bar(drawing, picture, projection);
  const Projection corner = axes_projection(projection);
  for (int i = 0; i < 3; ++i) {
    const Vec3 end = corner.point(1.28 * Vec3::Unit(i));
    drawing.text(axes[i].first, end.x(), picture.height - end.y() + 6.0, text_size, 0.5, axes[i].second);
  }
  for (const PictureLabel& label : picture.labels) {
    const Vec3 at = projection.point(label.position);
    drawing.text(label.text, at.x() + label.right, picture.height - at.y() - label.up, text_size, 0.0, label.colour);
  }
  write_atomically(path.string(), drawing.png());
}

}  // namespace osculate::io
