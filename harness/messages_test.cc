#include "harness/messages.h"

#include <gtest/gtest.h>

#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace mda::testing {
namespace {

TEST(MessagesTest, ExceptionsAreToldWithoutTheirLibrary) {
  EXPECT_EQ(plain_words(std::bad_alloc()), "out of memory");
  EXPECT_EQ(plain_words(std::bad_array_new_length()), "out of memory");
  EXPECT_EQ(plain_words(std::runtime_error("[json] is a word")), "[json] is a word");
  try {
    static_cast<void>(nlohmann::json::object().at("scan"));
    ADD_FAILURE() << "there is no such member";
  } catch (const nlohmann::json::exception& error) {
    EXPECT_EQ(plain_words(error).find("json"), std::string::npos) << plain_words(error);
    EXPECT_NE(plain_words(error).find("'scan'"), std::string::npos) << plain_words(error);
  }
}

}  // namespace
}  // namespace mda::testing
