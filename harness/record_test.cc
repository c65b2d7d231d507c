#include "harness/record.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "harness/errors.h"
#include "harness/files.h"
#include "harness/testing/small_disk.h"
#include "harness/testing/temporary_directory.h"

namespace mda::testing {
namespace {

namespace fs = std::filesystem;

/// The message of the error of type E that `action` must throw.
template <typename E, typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const E& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

TEST(AppendFileTest, KeepsWhatIsAppended) {
  const TemporaryDirectory directory;
  AppendFile file(directory.file("f"));
  file.append("one\n");
  file.append("");
  file.append("two\n");
  EXPECT_EQ(read_file(directory.file("f")), "one\ntwo\n");
}

TEST(AppendFileTest, RefusesAFileThatIsThere) {
  const TemporaryDirectory directory;
  std::ofstream(directory.file("f")) << "mine";
  const auto make = [&] { AppendFile file(directory.file("f")); };
  EXPECT_NE(message_of<InputError>(make).find("'" + directory.file("f") + "'"), std::string::npos);
  EXPECT_EQ(read_file(directory.file("f")), "mine");
}

TEST(AppendFileTest, AFullDiskTearsNoLine) {
  const TemporaryDirectory directory;
  AppendFile file(directory.file("f"));
  const std::string line = std::string(99, 'x') + "\n";
  const SmallDisk disk(350);
  file.append(line + line);
  const std::string message = message_of<DiskError>([&] { file.append(line + line); });
  EXPECT_NE(message.find("'" + directory.file("f") + "'"), std::string::npos) << message;
  EXPECT_EQ(read_file(directory.file("f")), line + line) << "what was finished, and no more";
  file.append(line);
  EXPECT_EQ(read_file(directory.file("f")), line + line + line) << "what fits may still be added";
}

TEST(RunDirectoryTest, MakesTheDirectoryItsParentsAndEmptyFiles) {
  const TemporaryDirectory directory;
  RunDirectory run(directory.path() / "a" / "b c" / "\xc3\xb6");
  EXPECT_EQ(read_file((run.path() / "rows.jsonl").string()), "");
  EXPECT_EQ(read_file((run.path() / "answers.jsonl").string()), "");
  run.append({.rows = "{\"row\":1}\n", .answers = "{\"answer\":1}\n"});
  run.append({.rows = "{\"row\":2}\n", .answers = "{\"answer\":2}\n"});
  run.write_manifest("{}");
  run.write_manifest("{\"more\":1}");
  EXPECT_EQ(read_file((run.path() / "rows.jsonl").string()), "{\"row\":1}\n{\"row\":2}\n");
  EXPECT_EQ(read_file((run.path() / "answers.jsonl").string()), "{\"answer\":1}\n{\"answer\":2}\n");
  EXPECT_EQ(read_file((run.path() / "manifest.json").string()), "{\"more\":1}");
  EXPECT_EQ(std::distance(fs::directory_iterator(run.path()), {}), 3) << "nothing else";
}

TEST(RunDirectoryTest, AFullDiskTakesBackWhatGoesWithTheLinesThatDoNotFit) {
  const TemporaryDirectory directory;
  RunDirectory run(directory.path() / "run", {.closed = true, .scenes = true});
  const SmallDisk disk(100);
  const std::string large(90, 'x');
  run.append({.rows = large, .answers = "a", .tracking = "t", .scenes = "s"});
  const auto append = [&] {
    run.append({.rows = large, .answers = "b", .tracking = "u", .scenes = "z"});
  };
  EXPECT_NE(message_of<DiskError>(append).find("rows.jsonl"), std::string::npos);
  const std::map<std::string, std::string> expected = {
      {"rows", large}, {"answers", "a"}, {"tracking", "t"}, {"scenes", "s"}};
  for (const auto& [name, text] : expected) {
    EXPECT_EQ(read_file((run.path() / (name + ".jsonl")).string()), text) << name;
  }
}

TEST(RunDirectoryTest, RefusesARunThatIsThere) {
  for (const char* name : {"rows.jsonl", "answers.jsonl", "scenes.jsonl", "manifest.json"}) {
    const TemporaryDirectory directory;
    std::ofstream(directory.file(name)) << "mine";
    const auto make = [&] { RunDirectory run(directory.path()); };
    EXPECT_NE(message_of<InputError>(make).find("holds a run already"), std::string::npos);
    EXPECT_EQ(read_file(directory.file(name)), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(directory.path()), {}), 1) << "nothing else";
  }
}

TEST(RunDirectoryTest, TakesADirectoryOfOtherFiles) {
  const TemporaryDirectory directory;
  std::ofstream(directory.file("notes.txt")) << "mine";
  EXPECT_NO_THROW(RunDirectory run(directory.path()));
  EXPECT_EQ(read_file(directory.file("notes.txt")), "mine");
}

TEST(RunDirectoryTest, PlacesThatCannotBeMadeLeaveNothingBehind) {
  const TemporaryDirectory directory;
  std::ofstream(directory.file("file")) << "mine";
  const std::string too_long(300, 'a');
  for (const fs::path& path :
       {fs::path("/proc/nowhere"), fs::path("/proc/self/x/y"), directory.path() / "file",
        directory.path() / "file" / "below", directory.path() / "new" / "newer" / too_long}) {
    const std::string message = message_of<InputError>([&] { RunDirectory run(path); });
    EXPECT_NE(message.find("'" + path.string() + "'"), std::string::npos) << message;
  }
  EXPECT_EQ(read_file(directory.file("file")), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory.path()), {}), 1);
}

TEST(RunDirectoryTest, AFullDiskKeepsTheOldManifest) {
  const TemporaryDirectory directory;
  RunDirectory run(directory.path() / "run");
  run.write_manifest("{}");
  const SmallDisk disk(100);
  const auto write = [&] { run.write_manifest(std::string(200, 'x')); };
  EXPECT_NE(message_of<DiskError>(write).find("manifest.json"), std::string::npos);
  EXPECT_EQ(read_file((run.path() / "manifest.json").string()), "{}");
  EXPECT_EQ(std::distance(fs::directory_iterator(run.path()), {}), 3) << "no half file stays";
}

TEST(FilesTest, ReadsAndReplacesWholeFiles) {
  const TemporaryDirectory directory;
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file(directory.file("f"), bytes);
  EXPECT_EQ(read_file(directory.file("f")), bytes);
  write_file(directory.file("f"), "");
  EXPECT_EQ(read_file(directory.file("f")), "");
  const std::string large(300000, 'x');
  write_file(directory.file("f"), large);
  EXPECT_EQ(read_file(directory.file("f")), large);
}

TEST(FilesTest, ReadsNoDirectoriesAndNoDevices) {
  const TemporaryDirectory directory;
  for (const std::string& name : {directory.path().string(), directory.file("absent"),
                                  std::string("/dev/zero"), std::string("/dev/null")}) {
    const auto read = [&] { static_cast<void>(read_file(name)); };
    EXPECT_NE(message_of<InputError>(read).find("'" + name + "'"), std::string::npos);
  }
}

TEST(FilesTest, WritesOnlyWhereThereCanBeAFile) {
  const TemporaryDirectory directory;
  for (const std::string& name :
       {directory.path().string(), directory.file("absent/f"), std::string("/proc/nowhere")}) {
    const auto write = [&] { write_file(name, "x"); };
    EXPECT_NE(message_of<InputError>(write).find("'" + name + "'"), std::string::npos);
  }
  EXPECT_TRUE(directory.is_empty());
}

TEST(FilesTest, ASymbolicLinkStaysOne) {
  const TemporaryDirectory directory;
  fs::create_symlink("target", directory.path() / "link");
  write_file(directory.file("link"), "before");
  write_file(directory.file("link"), "after");
  EXPECT_TRUE(fs::is_symlink(directory.path() / "link"));
  EXPECT_EQ(read_file(directory.file("target")), "after");
}

TEST(FilesTest, AFullDeviceIsADiskErrorAndStaysADevice) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const TemporaryDirectory directory;
  fs::create_symlink("/dev/full", directory.path() / "full");
  const auto write = [&] { write_file(directory.file("full"), "x"); };
  EXPECT_NE(message_of<DiskError>(write).find("full"), std::string::npos);
  EXPECT_TRUE(fs::is_character_file(directory.path() / "full"));
}

}  // namespace
}  // namespace mda::testing
