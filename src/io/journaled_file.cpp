#include "io/journaled_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "io/checksum.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

constexpr std::uint64_t page_size = 16384;
constexpr std::uint64_t magic = 0x4C4E524A43534FULL;  // "OSCJRNL"

std::string& trouble() {
  static thread_local std::string text;
  return text;
}

bool note(const std::string& path, const char* what) {
  trouble() = path + ": " + what + " (" + std::strerror(errno) + ")";
  return false;
}

bool write_all(int file, const char* bytes, std::uint64_t count, std::uint64_t at) {
  while (count > 0) {
    const ssize_t done = ::pwrite(file, bytes, count, static_cast<off_t>(at));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    at += static_cast<std::uint64_t>(done);
    count -= static_cast<std::uint64_t>(done);
  }
  return true;
}

/// Bytes beyond the end of the file read as zero.
bool read_all(int file, char* bytes, std::uint64_t count, std::uint64_t at) {
  while (count > 0) {
    const ssize_t done = ::pread(file, bytes, count, static_cast<off_t>(at));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    if (done == 0) {
      std::memset(bytes, 0, count);
      return true;
    }
    bytes += done;
    at += static_cast<std::uint64_t>(done);
    count -= static_cast<std::uint64_t>(done);
  }
  return true;
}

void append_number(std::string& text, std::uint64_t value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}
std::uint64_t number_at(const std::string& text, std::size_t at) {
  std::uint64_t value = 0;
  std::memcpy(&value, text.data() + at, sizeof value);
  return value;
}

/// Pages by their place in the file.
using Pages = std::map<std::uint64_t, std::vector<char>>;

/// magic, number of pages, pages each after its offset, checksum.
std::string journal_of(const Pages& pages, std::uint64_t below) {
  std::string body;
  std::uint64_t count = 0;
  for (const auto& [at, page] : pages) {
    if (at >= below) break;
    append_number(body, at);
    body.append(page.data(), page.size());
    ++count;
  }
  std::string journal;
  append_number(journal, magic);
  append_number(journal, count);
  journal += body;
  append_number(journal, crc64(journal));
  return journal;
}

bool is_whole(const std::string& journal) {
  constexpr std::size_t frame = 3 * sizeof(std::uint64_t);
  if (journal.size() < frame || number_at(journal, 0) != magic) return false;
  const std::uint64_t pages = (journal.size() - frame) / (page_size + sizeof(std::uint64_t));
  const std::size_t body_end = journal.size() - sizeof(std::uint64_t);
  return number_at(journal, sizeof(std::uint64_t)) == pages &&
         body_end == 2 * sizeof(std::uint64_t) + pages * (page_size + sizeof(std::uint64_t)) &&
         number_at(journal, body_end) == crc64(std::string_view(journal).substr(0, body_end));
}

bool write_pages(int file, const std::string& journal) {
  std::size_t at = 2 * sizeof(std::uint64_t);
  for (std::uint64_t left = number_at(journal, sizeof(std::uint64_t)); left > 0; --left) {
    const std::uint64_t place = number_at(journal, at);
    at += sizeof(std::uint64_t);
    if (!write_all(file, journal.data() + at, page_size, place)) return false;
    at += page_size;
  }
  return ::fsync(file) == 0;
}

struct OpenFile {
  int descriptor;

  explicit OpenFile(int opened) : descriptor(opened) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

/// HDF5's view of such a file; it begins with what HDF5 keeps for itself.
struct JournaledFile {
  H5FD_t common{};
  std::string path;
  int file = -1;
  bool writable = false;
  bool given_up = false;   ///< after the file system refused
  haddr_t allocated = 0;   ///< HDF5's end of the addresses in use
  std::uint64_t size = 0;  ///< of the file as last committed
  std::uint64_t end = 0;   ///< of the file with what is pending
  Pages pending;

  ~JournaledFile() {
    if (file >= 0) ::close(file);
  }

  bool read(std::uint64_t at, std::size_t count, char* bytes) const {
    if (!read_all(file, bytes, count, at)) return note(path, "cannot be read");
    auto page = pending.lower_bound(at - at % page_size);
    for (; page != pending.end() && page->first < at + count; ++page) {
      const std::uint64_t from = std::max(at, page->first), to = std::min(at + count, page->first + page_size);
      std::memcpy(bytes + (from - at), page->second.data() + (from - page->first), to - from);
    }
    return true;
  }

  bool write(std::uint64_t at, std::size_t count, const char* bytes) {
    end = std::max<std::uint64_t>(end, at + count);
    while (count > 0) {
      const std::uint64_t place = at - at % page_size, from = at - place;
      const std::size_t part = static_cast<std::size_t>(std::min<std::uint64_t>(count, page_size - from));
      auto [page, is_new] = pending.try_emplace(place);
      if (is_new) {
        page->second.resize(page_size);
        if (!read_all(file, page->second.data(), page_size, place)) return note(path, "cannot be read");
      }
      std::memcpy(page->second.data() + from, bytes, part);
      at += part;
      bytes += part;
      count -= part;
    }
    return true;
  }

  /// HDF5 does not survive a file that it cannot close. After a refusal nothing more is written, so that closing works
  /// and the file stays as it was committed.
  bool flush() {
    if (!writable || given_up) return true;
    given_up = !commit();
    return !given_up;
  }

  /// Pages that begin beyond the file as it was go straight to it; the others by the journal.
  bool commit() {
    if (pending.empty()) return true;
    for (auto page = pending.lower_bound(size); page != pending.end(); ++page)
      if (!write_all(file, page->second.data(), page_size, page->first)) return note(path, "cannot be written");
    if (::fsync(file) != 0) return note(path, "cannot be written");
    const std::string journal = journal_of(pending, size);
    const std::string beside = journal_path(path).string();
    const OpenFile journal_file(::open(beside.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (journal_file.descriptor < 0 || ::flock(journal_file.descriptor, LOCK_EX) != 0)
      return note(beside, "cannot be created");
    if (::ftruncate(journal_file.descriptor, 0) != 0 ||
        !write_all(journal_file.descriptor, journal.data(), journal.size(), 0) ||
        ::fsync(journal_file.descriptor) != 0) {
      note(beside, "cannot be written");
      ::unlink(beside.c_str());
      return false;
    }
    if (!write_pages(file, journal)) return note(path, "cannot be written");
    ::unlink(beside.c_str());
    // Whole pages: HDF5 knows the end of what is in use by itself.
    size = std::max(size, pending.rbegin()->first + page_size);
    end = size;
    pending.clear();
    return true;
  }
};

JournaledFile& of(H5FD_t* file) {
  return *reinterpret_cast<JournaledFile*>(file);
}
const JournaledFile& of(const H5FD_t* file) {
  return *reinterpret_cast<const JournaledFile*>(file);
}

herr_t as_status(bool good) {
  return good ? 0 : -1;
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t, haddr_t) {
  auto made = std::make_unique<JournaledFile>();
  made->path = name;
  made->writable = (flags & H5F_ACC_RDWR) != 0;
  int how = O_CLOEXEC | (made->writable ? O_RDWR : O_RDONLY);
  if ((flags & H5F_ACC_CREAT) != 0) how |= O_CREAT;
  if ((flags & H5F_ACC_TRUNC) != 0) how |= O_TRUNC;
  if ((flags & H5F_ACC_EXCL) != 0) how |= O_EXCL;
  made->file = ::open(name, how, 0666);
  struct stat status {};
  if (made->file < 0 || ::fstat(made->file, &status) != 0) {
    note(name, "cannot be opened");
    return nullptr;
  }
  made->size = made->end = static_cast<std::uint64_t>(status.st_size);
  return &made.release()->common;
}

herr_t close_file(H5FD_t* file) {
  delete &of(file);
  return 0;
}

int compare_files(const H5FD_t* one, const H5FD_t* two) {
  return of(one).path.compare(of(two).path);
}

herr_t features(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "osculate journal";
  driver.maxaddr = static_cast<haddr_t>(1) << 62U;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.open = open_file;
  driver.close = close_file;
  driver.cmp = compare_files;
  driver.query = features;
  driver.get_eoa = [](const H5FD_t* file, H5FD_mem_t) { return of(file).allocated; };
  driver.set_eoa = [](H5FD_t* file, H5FD_mem_t, haddr_t address) -> herr_t {
    of(file).allocated = address;
    return 0;
  };
  driver.get_eof = [](const H5FD_t* file, H5FD_mem_t) -> haddr_t {
    return std::max<haddr_t>(of(file).end, of(file).size);
  };
  driver.read = [](H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t count, void* bytes) {
    return as_status(of(file).read(at, count, static_cast<char*>(bytes)));
  };
  driver.write = [](H5FD_t* file, H5FD_mem_t, hid_t, haddr_t at, size_t count, const void* bytes) {
    return as_status(of(file).write(at, count, static_cast<const char*>(bytes)));
  };
  driver.flush = [](H5FD_t* file, hid_t, hbool_t) { return as_status(of(file).flush()); };
  const H5FD_mem_t one_list[H5FD_MEM_NTYPES] = {H5FD_MEM_SUPER, H5FD_MEM_SUPER, H5FD_MEM_SUPER, H5FD_MEM_SUPER,
                                                H5FD_MEM_SUPER, H5FD_MEM_SUPER, H5FD_MEM_SUPER};
  std::copy(std::begin(one_list), std::end(one_list), std::begin(driver.fl_map));
  return driver;
}

}  // namespace

hid_t journaled_access() {
  static const H5FD_class_t driver = driver_class();
  static const hid_t driver_id = H5FDregister(&driver);
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_driver(access, driver_id, nullptr);
  return access;
}

std::string take_journal_trouble() {
  return std::exchange(trouble(), {});
}

std::filesystem::path journal_path(const std::filesystem::path& path) {
  return path.string() + ".journal";
}

void apply_journal(const std::filesystem::path& path) {
  const std::string beside = journal_path(path).string();
  const auto refuse = [](const std::string& where, const char* what, const char* expected) {
    throw InputError(where, std::string(what) + " (" + std::strerror(errno) + ")", expected);
  };
  const OpenFile journal_file(::open(beside.c_str(), O_RDONLY | O_CLOEXEC));
  if (journal_file.descriptor < 0) {
    if (errno == ENOENT) return;
    refuse(beside, "a journal that cannot be read", "a readable one: it completes the results");
  }
  // A writer at work holds the lock until the journal has served.
  if (::flock(journal_file.descriptor, LOCK_EX) != 0)
    refuse(beside, "cannot be locked", "a file system with locks (flock)");
  struct stat status {};
  if (::fstat(journal_file.descriptor, &status) == 0 && status.st_nlink == 0) return;
  std::string journal(static_cast<std::size_t>(status.st_size), '\0');
  if (!read_all(journal_file.descriptor, journal.data(), journal.size(), 0))
    refuse(beside, "cannot be read", "a readable journal: it completes the results");
  if (is_whole(journal)) {
    const OpenFile file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (file.descriptor < 0 || !write_pages(file.descriptor, journal))
      refuse(path.string(), "cannot be completed from its journal", "a writable file");
  }
  if (::unlink(beside.c_str()) != 0) refuse(beside, "cannot be removed", "a folder where files can be removed");
}

}  // namespace osculate::io
