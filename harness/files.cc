#include "harness/files.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "harness/errors.h"

namespace mda {
namespace {

constexpr std::size_t kLargest = std::size_t{1} << 31;

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError(fmt::format("cannot read '{}': there is no such file", path));
  }
  if (std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("cannot read '{}': it is a directory", path));
  }
  // Pipes are welcome, but not what never ends, as /dev/zero.
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status)) {
    throw InputError(fmt::format("cannot read '{}': it is not a file", path));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  for (std::array<char, 1 << 16> part; file.read(part.data(), part.size()), file.gcount() > 0;) {
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > kLargest) {
      throw InputError(fmt::format("cannot read '{}': it is larger than 2 GiB", path));
    }
  }
  if (!file.is_open() || file.bad()) {
    throw InputError(fmt::format("cannot read '{}': {}", path, std::strerror(errno)));
  }
  return text;
}

std::string read_regular_file(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_fifo(path, error)) {
    throw InputError(fmt::format("cannot read '{}': it is a pipe, not a file", path));
  }
  return read_file(path);
}

namespace {

/// Writes to `place`; messages speak of `path`.
void write_to(const std::string& place, const std::string& path, std::string_view text) {
  errno = 0;
  std::ofstream file(place, std::ios::binary | std::ios::trunc);
  if (!file) throw InputError(fmt::format("cannot make '{}': {}", path, std::strerror(errno)));
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) throw DiskError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

}  // namespace

void write_file(const std::string& path, std::string_view text) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("cannot make '{}': it is a directory", path));
  }
  // A rename would put a plain file in the place of a device such as /dev/null, or of a link.
  const bool is_special =
      std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (is_special || std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) {
    write_to(path, path, text);
    return;
  }
  const std::string neighbour = path + ".part";
  try {
    write_to(neighbour, path, text);
    std::filesystem::rename(neighbour, path, error);
    if (error) throw DiskError(fmt::format("cannot write '{}': {}", path, error.message()));
  } catch (const DiskError&) {
    std::filesystem::remove(neighbour, error);
    throw;
  }
}

}  // namespace mda
