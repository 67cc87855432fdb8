#include "io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "io/atomic_file.hpp"
#include "io/checksum.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

// magic and version, four numbers, the arrays (name, type, values), checksum of all before it.
constexpr std::string_view magic = "OSCULATE CHECKPOINT 4\n";

class Writer {
 public:
  void number(std::uint64_t value) { bytes(&value, sizeof value); }
  void text(const std::string& value) {
    number(value.size());
    bytes(value.data(), value.size());
  }
  template <class Number>
  void numbers(const std::vector<Number>& values) {
    number(values.size());
    bytes(values.data(), values.size() * sizeof(Number));
  }
  std::string finish() && {
    number(crc64(text_));
    return std::move(text_);
  }
  void bytes(const void* from, std::size_t count) { text_.append(static_cast<const char*>(from), count); }

 private:
  std::string text_;
};

class Reader {
 public:
  Reader(const std::filesystem::path& path, std::string_view text) : path_(path), rest_(text) {}

  std::string_view bytes(std::uint64_t count) {
    if (count > rest_.size()) throw InputError(path_.string(), "found a checkpoint that ends early", "a whole one");
    const std::string_view part = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return part;
  }
  std::uint64_t number() {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes(sizeof value).data(), sizeof value);
    return value;
  }
  template <class Number>
  std::vector<Number> numbers() {
    const std::uint64_t count = number();
    const std::string_view part = bytes(count * sizeof(Number));
    std::vector<Number> values(count);
    if (count > 0) std::memcpy(values.data(), part.data(), part.size());
    return values;
  }

 private:
  const std::filesystem::path& path_;
  std::string_view rest_;
};

StateArray read_array(Reader& reader, const std::filesystem::path& path) {
  const std::string name(reader.bytes(reader.number()));
  switch (reader.number()) {
    case 0:
      return {name, reader.numbers<double>()};
    case 1:
      return {name, reader.numbers<std::int32_t>()};
    case 2:
      return {name, reader.numbers<std::uint64_t>()};
    default:
      throw InputError(path.string(), "found an array of unknown type", "a checkpoint of this program's version");
  }
}

/// Newest first. A kill between the two renames leaves the newest under its first name.
std::array<std::filesystem::path, 3> checkpoints_in(const std::filesystem::path& folder) {
  return {folder / "checkpoint.new.bin", checkpoint_path(folder), earlier_checkpoint_path(folder)};
}

}  // namespace

void remove_checkpoints(const std::filesystem::path& folder) {
  for (const std::filesystem::path& path : checkpoints_in(folder)) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) throw InputError(path.string(), "cannot be removed (" + error.message() + ")", "a writable folder");
  }
}

std::filesystem::path checkpoint_path(const std::filesystem::path& folder) {
  return folder / "checkpoint.bin";
}
std::filesystem::path earlier_checkpoint_path(const std::filesystem::path& folder) {
  return folder / "checkpoint.earlier.bin";
}

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  Writer writer;
  writer.bytes(magic.data(), magic.size());
  writer.number(checkpoint.scene);
  writer.number(checkpoint.frames);
  writer.number(checkpoint.rows);
  writer.number(checkpoint.state.arrays.size());
  for (const StateArray& array : checkpoint.state.arrays) {
    writer.text(array.name);
    writer.number(array.values.index());
    std::visit([&](const auto& values) { writer.numbers(values); }, array.values);
  }
  // The new one is whole on the disk before the old one makes way for it.
  const std::filesystem::path newest = checkpoint_path(folder), fresh = checkpoints_in(folder)[0];
  write_atomically(fresh.string(), std::move(writer).finish());
  const auto rename = [](const std::filesystem::path& from, const std::filesystem::path& to) {
    if (std::rename(from.c_str(), to.c_str()) != 0 && errno != ENOENT)  // ENOENT: the first checkpoint
      throw InputError(from.string(), std::string("cannot be renamed (") + std::strerror(errno) + ")",
                       "a folder where files can be written");
  };
  rename(newest, earlier_checkpoint_path(folder));
  rename(fresh, newest);
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string(), "found a checkpoint that cannot be opened", "a readable file");
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!std::string_view(text).starts_with(magic))
    throw InputError(path.string(), "found no checkpoint, or one of another version", "one this program wrote");
  std::uint64_t checksum = 0;
  const std::size_t end = text.size() - std::min(text.size(), sizeof checksum);
  std::memcpy(&checksum, text.data() + end, text.size() - end);
  const std::string_view content = std::string_view(text).substr(0, end);
  if (crc64(content) != checksum)
    throw InputError(path.string(), "found a damaged checkpoint (its checksum is wrong)", "an undamaged one");
  Reader reader(path, content.substr(magic.size()));
  Checkpoint checkpoint{.scene = reader.number(), .frames = reader.number(), .rows = reader.number(), .state = {}};
  for (std::uint64_t left = reader.number(); left > 0; --left)
    checkpoint.state.arrays.push_back(read_array(reader, path));
  return checkpoint;
}

std::optional<FoundCheckpoint> find_checkpoint(const std::filesystem::path& folder) {
  FoundCheckpoint found;
  bool any = false;
  for (const std::filesystem::path& path : checkpoints_in(folder)) {
    if (!std::filesystem::exists(path)) continue;
    any = true;
    try {
      found.checkpoint = read_checkpoint(path);
      return found;
    } catch (const InputError& error) {
      found.complaints.emplace_back(error.what());
    }
  }
  if (!any) return std::nullopt;
  throw InputError(folder.string(), fmt::format("found no sound checkpoint: {}", fmt::join(found.complaints, "; ")),
                   "an undamaged one, or a folder without any");
}

}  // namespace osculate::io
