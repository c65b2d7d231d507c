// Reading input and opening output, with errors that name the file.
#pragma once

#include <string>
#include <string_view>

namespace mda {

/// The whole file. Throws InputError if it is absent, not a plain file, unreadable, or larger than
/// 2 GiB.
[[nodiscard]] std::string read_file(const std::string& path);

/// Writes a new file or replaces one as a whole (through a neighbour and a rename, so that no
/// reader ever sees half of it). Throws DiskError.
void write_file(const std::string& path, std::string_view text);

}  // namespace mda
