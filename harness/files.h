// Reading input and opening output, with errors that name the file.
#pragma once

#include <string>
#include <string_view>

namespace mda {

/// The whole file, which may be a pipe. Throws InputError if it is absent, a directory or a device,
/// unreadable, or larger than 2 GiB.
[[nodiscard]] std::string read_file(const std::string& path);

/// The same of what cannot be a pipe, which may wait for ever for somebody to write into it.
[[nodiscard]] std::string read_regular_file(const std::string& path);

/// Writes a new file or replaces one as a whole (through a neighbour and a rename, so that no
/// reader ever sees half of it); writes straight to a device or pipe, and through a symbolic link.
/// Throws InputError if there cannot be such a file, DiskError if writing to it fails; then
/// nothing is left behind but, through a link, what had been written by then.
void write_file(const std::string& path, std::string_view text);

}  // namespace mda
