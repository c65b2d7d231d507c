// What this program was built from and with; filled in by the build (build_info.cc.in).
#pragma once

#include <string_view>

namespace mda {

struct BuildInfo {
  std::string_view version;
  std::string_view commit;  ///< "unknown" outside a git checkout
  bool dirty = false;       ///< tracked files differed from the commit
  std::string_view compiler;
  std::string_view flags;
  std::string_view cbc_version;
  std::string_view clp_version;
  std::string_view eigen_version;
  std::string_view boost_version;
};

[[nodiscard]] const BuildInfo& build_info() noexcept;

}  // namespace mda
