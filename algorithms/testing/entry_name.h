// Names of the tests that run for every entry of the catalogue.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "algorithms/catalog.h"

namespace mda::testing {

/// The entry's name with what GoogleTest does not take in a name replaced.
inline std::string entry_name(const ::testing::TestParamInfo<CatalogEntry>& info) {
  std::string name(info.param.name);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace mda::testing
