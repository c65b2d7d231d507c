#include "harness/certificate_file.h"

#include <gtest/gtest.h>

#include <string>

#include "harness/errors.h"

namespace mda::testing {
namespace {

TEST(CertificateFileTest, FilesThatAreNoneAreRefusedWithTheirPlace) {
  const auto fault_of = [](const std::string& text) -> std::string {
    try {
      (void)parse_certificate(text, "proof.json");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(fault_of("nonsense").find("proof.json"), std::string::npos);
  EXPECT_NE(fault_of("{}").find("'schema' is missing"), std::string::npos);
  const std::string head =
      R"({"schema":1,"fingerprint":"f","bits":20,"cost":0,"columns":[],"steps":)";
  EXPECT_EQ(fault_of(head + R"([{"enumerate":true}]})"), "");
  EXPECT_NE(fault_of(head + R"([{"magic":true}]})").find("steps'[0]"), std::string::npos);
  EXPECT_NE(fault_of(head + R"([{"column":1e99}]})").find("'column'"), std::string::npos);
  EXPECT_NE(fault_of(head + R"([{"odd_rows":[0,"1"]}]})").find("[1]"), std::string::npos);
  EXPECT_NE(fault_of(head + "[]}" + std::string(1, '\0') + "x"), "");
  EXPECT_EQ(fault_of(head + R"([],"bits":3})"), "proof.json: 'bits' is there twice");
  EXPECT_EQ(fault_of(head + R"([],"color":3})"), "proof.json: unknown key 'color'");
  EXPECT_NE(fault_of(head + R"([{"parts":[{"rows":[],"floor":0,"roof":1}]}]})").find("'roof'"),
            std::string::npos);
}

}  // namespace
}  // namespace mda::testing
