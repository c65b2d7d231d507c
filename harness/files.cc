#include "harness/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "harness/errors.h"

namespace mda {

std::string read_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError(fmt::format("cannot read '{}': there is no such file", path));
  }
  if (std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("cannot read '{}': it is a directory", path));
  }
  constexpr std::uintmax_t kLargest = 1ULL << 31;
  if (std::filesystem::is_regular_file(status) &&
      std::filesystem::file_size(path, error) > kLargest) {
    throw InputError(fmt::format("cannot read '{}': it is larger than 2 GiB", path));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.is_open() || file.bad()) {
    throw InputError(fmt::format("cannot read '{}': {}", path, std::strerror(errno)));
  }
  return text;
}

void write_file(const std::string& path, std::string_view text) {
  const std::string neighbour = path + ".part";
  errno = 0;
  std::ofstream file(neighbour, std::ios::binary | std::ios::trunc);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::error_code error;
  if (file) {
    std::filesystem::rename(neighbour, path, error);
  }
  if (!file || error) {
    const std::string why = error ? error.message() : std::strerror(errno);
    std::filesystem::remove(neighbour, error);
    throw DiskError(fmt::format("cannot write '{}': {}", path, why));
  }
}

}  // namespace mda
