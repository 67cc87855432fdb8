#define GL_GLEXT_PROTOTYPES
#include "io/renderer.hpp"

#include <GL/osmesa.h>
// After osmesa.h, which brings in gl.h.
#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "io/ambient_occlusion.hpp"

namespace osculate::io {
namespace {

constexpr int samples = 3;  // along each side of a pixel

// Body to pixels by the model matrix, pixels to clip space; z is clipped at ±depth.
constexpr const char* vertex_shader = R"(
#version 120
uniform vec2 size;
uniform float depth;
varying vec3 normal;
varying vec4 colour;
void main() {
  normal = mat3(gl_ModelViewMatrix) * gl_Normal;
  colour = gl_Color;
  vec3 at = (gl_ModelViewMatrix * gl_Vertex).xyz;
  gl_Position = vec4(2.0 * at.x / size.x - 1.0, 2.0 * at.y / size.y - 1.0, -at.z / depth, 1.0);
}
)";

// Sky light, a key light from the upper left and a weak fill; the eye is at infinity along +z.
constexpr const char* fragment_shader = R"(
#version 120
varying vec3 normal;
varying vec4 colour;
void main() {
  vec3 n = normalize(normal);
  vec3 key = normalize(vec3(-0.45, 0.75, 0.85));
  vec3 fill = normalize(vec3(0.9, -0.1, 0.5));
  float light = 0.60 + 0.10 * n.y + 0.42 * max(dot(n, key), 0.0) + 0.14 * max(dot(n, fill), 0.0);
  float gloss = 0.05 * (0.5 + 0.5 * dot(n, key)) + 0.16 * pow(max(dot(n, normalize(key + vec3(0.0, 0.0, 1.0))), 0.0), 40.0);
  gl_FragColor = vec4(colour.rgb * light + gloss, colour.a);
}
)";

/// A program of the two shaders, for the current context.
GLuint compile_shaders() {
  const GLuint program = glCreateProgram();
  const auto attach = [&](GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    // A leading line break would come before #version.
    const char* const text = source + 1;
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  };
  attach(GL_VERTEX_SHADER, vertex_shader);
  attach(GL_FRAGMENT_SHADER, fragment_shader);
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) throw std::runtime_error("the software renderer cannot compile its shaders");
  return program;
}

void draw(const PictureTriangles& triangles) {
  if (triangles.triangles.empty()) return;
  constexpr auto stride = static_cast<GLsizei>(sizeof(PictureVertex));
  const PictureVertex& first = triangles.vertices.front();
  glVertexPointer(3, GL_FLOAT, stride, first.position.data());
  glNormalPointer(GL_FLOAT, stride, first.normal.data());
  glColorPointer(4, GL_FLOAT, stride, first.colour.data());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles.triangles.size()), GL_UNSIGNED_INT,
                 triangles.triangles.front().data());
}

/// A mesh as OpenGL takes it.
struct FloatMesh {
  std::vector<std::array<float, 6>> vertices;  ///< position, normal
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

FloatMesh float_mesh(const TriangleMesh& mesh) {
  FloatMesh result;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3f x = mesh.vertices[i].cast<float>(), n = mesh.normals[i].cast<float>();
    result.vertices.push_back({x.x(), x.y(), x.z(), n.x(), n.y(), n.z()});
  }
  for (const auto& t : mesh.triangles) {
    result.triangles.push_back(
        {static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  }
  return result;
}

/// Leaves the model matrix as it was: the identity.
void draw(const RenderSwarm& swarm) {
  if (swarm.instances.empty()) return;
  const FloatMesh mesh = float_mesh(swarm.mesh);
  constexpr auto stride = static_cast<GLsizei>(sizeof(mesh.vertices.front()));
  glDisableClientState(GL_COLOR_ARRAY);
  glVertexPointer(3, GL_FLOAT, stride, mesh.vertices.front().data());
  glNormalPointer(GL_FLOAT, stride, mesh.vertices.front().data() + 3);
  // Compiled once: the vertices are not read again for every instance.
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangles.size()), GL_UNSIGNED_INT,
                 mesh.triangles.front().data());
  glEndList();
  glMatrixMode(GL_MODELVIEW);
  for (const RenderInstance& instance : swarm.instances) {
    Eigen::Matrix4d to_picture = Eigen::Matrix4d::Identity();
    to_picture.topLeftCorner<3, 3>() = swarm.scale * instance.rotation;
    to_picture.topRightCorner<3, 1>() = instance.position;
    glLoadMatrixd(to_picture.data());
    glColor3d(instance.colour.red, instance.colour.green, instance.colour.blue);
    glCallList(list);
  }
  glLoadIdentity();
  glDeleteLists(list, 1);
  glEnableClientState(GL_COLOR_ARRAY);
}

double largest_depth(const RenderScene& scene) {
  double largest = 1.0;
  for (const auto* part : {&scene.opaque, &scene.translucent, &scene.on_top}) {
    for (const auto& vertex : part->vertices) largest = std::max<double>(largest, std::fabs(vertex.position[2]));
  }
  for (const RenderSwarm& swarm : scene.swarms) {
    double reach = 0.0;
    for (const Vec3& vertex : swarm.mesh.vertices) reach = std::max(reach, swarm.scale * vertex.norm());
    for (const RenderInstance& instance : swarm.instances) {
      largest = std::max(largest, std::fabs(instance.position.z()) + reach);
    }
  }
  return 1.01 * largest;
}

/// What is nearest in the middle of every pixel.
DepthMap depth_map(const RenderScene& scene, double depth) {
  const int width = samples * scene.width, height = samples * scene.height;
  std::vector<float> fine(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, fine.data());
  DepthMap map{scene.width, scene.height, {}};
  map.depth.reserve(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height));
  for (int y = 0; y < scene.height; ++y) {
    const int row = height - 1 - (samples * y + samples / 2);
    for (int x = 0; x < scene.width; ++x) {
      const float value = fine[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(samples * x + samples / 2)];
      map.depth.push_back(value < 1.0F ? static_cast<float>((1.0 - 2.0 * value) * depth)
                                       : -std::numeric_limits<float>::infinity());
    }
  }
  return map;
}

/// Leaves the depths of the opaque things for the shade in their gaps.
DepthMap draw_scene(const RenderScene& scene, int width, int height) {
  const GLuint program = compile_shaders();
  glUseProgram(program);
  const double depth = largest_depth(scene);
  glUniform2f(glGetUniformLocation(program, "size"), static_cast<float>(scene.width), static_cast<float>(scene.height));
  glUniform1f(glGetUniformLocation(program, "depth"), static_cast<float>(depth));
  glViewport(0, 0, width, height);
  glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);

  draw(scene.opaque);
  for (const RenderSwarm& swarm : scene.swarms) draw(swarm);
  const DepthMap depths = scene.shade_radius > 0.0 ? depth_map(scene, depth) : DepthMap{};
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw(scene.translucent);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  draw(scene.on_top);
  glFinish();
  return depths;
}

void shade(Image& image, const std::vector<float>& sky) {
  for (std::size_t i = 0; i < sky.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      std::uint8_t& value = image.pixels[3 * i + channel];
      value = static_cast<std::uint8_t>(std::lround(sky[i] * static_cast<float>(value)));
    }
  }
}

/// OpenGL's rows run from the bottom, four bytes a sample.
Image average(const std::vector<std::uint8_t>& fine, int width, int height) {
  Image image{width, height,
              std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
  const std::size_t row_samples = static_cast<std::size_t>(width) * samples;
  const auto rows = static_cast<std::size_t>(height) * samples;
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        unsigned sum = 0;
        for (std::size_t j = 0; j < samples; ++j) {
          const std::size_t row = rows - 1 - (samples * y + j);
          for (std::size_t i = 0; i < samples; ++i) sum += fine[4 * (row * row_samples + samples * x + i) + channel];
        }
        constexpr unsigned all = samples * samples;
        image.pixels[3 * (y * static_cast<std::size_t>(width) + x) + channel] =
            static_cast<std::uint8_t>((sum + all / 2) / all);
      }
    }
  }
  return image;
}

}  // namespace

Image render(const RenderScene& scene) {
  constexpr int depth_bits = 24;
  const std::unique_ptr<std::remove_pointer_t<OSMesaContext>, decltype(&OSMesaDestroyContext)> context(
      OSMesaCreateContextExt(OSMESA_RGBA, depth_bits, 0, 0, nullptr), &OSMesaDestroyContext);
  const int width = samples * scene.width, height = samples * scene.height;
  std::vector<std::uint8_t> fine(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  if (!context || OSMesaMakeCurrent(context.get(), fine.data(), GL_UNSIGNED_BYTE, width, height) != GL_TRUE) {
    throw std::runtime_error("the software renderer cannot start");
  }
  const DepthMap depths = draw_scene(scene, width, height);
  Image image = average(fine, scene.width, scene.height);
  if (scene.shade_radius > 0.0) shade(image, seen_sky(depths, scene.shade_radius));
  return image;
}

}  // namespace osculate::io
