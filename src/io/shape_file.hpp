#pragma once
// Particle shapes as TOML files, one a shape, and the catalogue of them. The keys are explained in docs/shape-files.md.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/toml_reader.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate::io {

/// A shape and what a person wants to know of it.
struct ShapeFile {
  std::string name;    ///< as in the catalogue, or the file's stem
  std::string title;   ///< one line; empty if none was given
  std::string source;  ///< where the dimensions come from; empty if none was given
  std::string unit;    ///< of the file's lengths; empty for a half-space
  Shape shape;         ///< in SI, validated
  std::filesystem::path file;
};

/// Reads one shape file. Throws InputError "file:line:col: key …: found …; expected …".
ShapeFile read_shape(const std::filesystem::path& path);

/// The shape in a table of any file, e.g. shape = {kind = "sphere", unit = "mm", radius = 2.0}. All keys of the table
/// must belong to the shape. Lengths without a unit of their own are in the table's `unit`, else in `default_unit`; if
/// that is empty too, the table must have one.
ShapeFile parse_shape(const TomlTable& table, std::string_view default_unit = "");

/// The shape that a key of a table asks for: a catalogue name, the path of a shape file (relative to the table's own
/// file), or an inline table.
ShapeFile parse_shape_of(const TomlTable& table, std::string_view key, std::string_view default_unit = "");

/// Where the catalogue is looked for, in this order: the folders in $OSCULATE_SHAPES (separated by ':'), the installed
/// data folder, the source tree. Only folders that exist.
std::vector<std::filesystem::path> catalogue_folders();

struct CatalogueEntry {
  std::string name;
  std::filesystem::path file;
};

/// Every shape of the catalogue by name; of two with one name, the one in the earlier folder.
std::vector<CatalogueEntry> catalogue();

/// Reads a shape by catalogue name, or by path if `name_or_path` has a '/' or ends in ".toml"; relative paths start
/// at `base`. Throws InputError with the nearest names if there is none such.
ShapeFile find_shape(std::string_view name_or_path, const std::filesystem::path& base = {});

}  // namespace osculate::io
