#include "harness/testing/tampered_run.h"

#include <algorithm>
#include <list>
#include <sstream>
#include <vector>

#include "harness/files.h"
#include "harness/run.h"

namespace mda::testing {

using nlohmann::json;

void TamperedRun::restore() const {
  std::filesystem::remove_all(path());
  std::filesystem::copy(original_, path(), std::filesystem::copy_options::recursive);
}

Verification TamperedRun::verify(int workers) const {
  const std::atomic<bool> interrupted = false;
  return verify_run(RunFiles(path()), workers, interrupted);
}

void TamperedRun::tamper(const std::string& name, const std::function<bool(json&)>& change) const {
  std::istringstream text(read_file((path() / name).string()));
  std::string tampered;
  bool done = false;
  for (std::string line; std::getline(text, line);) {
    json object = json::parse(line);
    if (!done && change(object)) {
      done = true;
      line = object.is_null() ? "" : object.dump();
    }
    if (!line.empty()) tampered += line + "\n";
  }
  ASSERT_TRUE(done);
  write_file((path() / name).string(), tampered);
}

void TamperedRun::change_manifest(const std::string& text, const std::string& by) const {
  std::string manifest = read_file((path() / "manifest.json").string());
  const auto place = manifest.find(text);
  ASSERT_NE(place, std::string::npos);
  write_file((path() / "manifest.json").string(), manifest.replace(place, text.size(), by));
}

void TamperedRun::expect_disagreement(const std::string& with) const {
  const std::vector<std::string> examples = verify().examples;
  ASSERT_FALSE(examples.empty());
  const bool is_told = std::any_of(examples.begin(), examples.end(), [&](const std::string& text) {
    return text.find(with) != std::string::npos;
  });
  EXPECT_TRUE(is_told) << examples.front();
}

std::filesystem::path kept_run(const Sweep& sweep) {
  static std::list<TemporaryDirectory> directories;
  const std::atomic<bool> interrupted = false;
  auto made = directories.emplace_back().path() / "run";
  static_cast<void>(run_sweep(sweep, made, 2, {}, interrupted));
  return made;
}

}  // namespace mda::testing
