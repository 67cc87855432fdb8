#pragma once
// What stands around the bodies of a picture: title, notes, colour bar, scale bar, labels and axes.

#include <filesystem>

#include "io/picture.hpp"
#include "io/picture_triangles.hpp"
#include "io/renderer.hpp"

namespace osculate::io {

/// A part of the picture [px].
struct Frame {
  double left, top, width, height;
};

/// The part that title, bars and axes leave to the bodies.
Frame free_frame(const Picture& picture);

/// The world's axes in the lower left corner.
void add_axes(PictureTriangles& triangles, const Projection& projection);

/// Writes the annotations over the image and the whole as PNG.
void write_annotated(const Image& image, const Picture& picture, const Projection& projection,
                     const std::filesystem::path& path);

}  // namespace osculate::io
