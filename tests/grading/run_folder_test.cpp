// Results are taken from a folder in which a program that nobody trusts may have put anything.
#include "grading/run_folder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/grading/place.h"

namespace rt::run_folder_test {
namespace {

namespace fs = std::filesystem;

class RunFolder : public testing::Test {
protected:
    std::string problem(const std::string& name, std::uint64_t most = 100) {
        const TakenFile result = take_file(place_.folder, name, most);
        EXPECT_NE(result.bytes.has_value(), !result.problem.empty());
        return result.problem;
    }
    std::string in(const std::string& name) const { return place_.folder + "/" + name; }
    uid_t owner(const std::string& path) const {
        struct stat status {};
        return lstat(path.c_str(), &status) == 0 ? status.st_uid : ~0u;
    }

    test::Place place_;
};

TEST_F(RunFolder, AFileIsItsBytes) {
    const std::string bytes("a\0\xff\n", 4);
    std::ofstream(in("output.png")) << bytes;
    fs::create_directory(in("pictures"));
    std::ofstream(in("pictures/empty.png"));
    EXPECT_EQ(take_file(place_.folder, "output.png", 4).bytes, bytes);
    EXPECT_EQ(take_file(place_.folder, "./pictures/empty.png", 4).bytes, "");
    EXPECT_EQ(problem("output.png", 3), "output.png has more than 3 bytes");
}

TEST_F(RunFolder, AnythingElseIsNamed) {
    fs::create_symlink(place_.expected, in("link.png"));
    fs::create_symlink("nowhere", in("dangling.png"));
    fs::create_directory_symlink(place_.suite, in("pictures"));
    fs::create_directory(in("folder.png"));
    ASSERT_EQ(mkfifo(in("pipe.png").c_str(), 0666), 0);
    const int sock = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un name{AF_UNIX, {}};
    in("socket.png").copy(name.sun_path, sizeof name.sun_path - 1);
    ASSERT_EQ(bind(sock, reinterpret_cast<sockaddr*>(&name), sizeof name), 0);
    close(sock);
    EXPECT_EQ(problem("absent.png"), "there is no absent.png");
    EXPECT_EQ(problem("link.png"), "link.png is a symbolic link");
    EXPECT_EQ(problem("dangling.png"), "dangling.png is a symbolic link");
    EXPECT_EQ(problem("folder.png"), "folder.png is a folder");
    EXPECT_EQ(problem("pipe.png"), "pipe.png is a named pipe");
    EXPECT_EQ(problem("socket.png"), "socket.png is a socket");
    EXPECT_EQ(problem("pictures/expected.png"), "pictures/expected.png: Not a directory");
    EXPECT_EQ(problem("../suite/expected.png"), "'../suite/expected.png' leads out of the run's folder");
    EXPECT_EQ(problem(place_.expected), "'" + place_.expected + "' is no name of a file in the run's folder");
    EXPECT_EQ(problem(""), "'' is no name of a file in the run's folder");
    if (geteuid() == 0 && mknod(in("device.png").c_str(), S_IFCHR | 0666, 0x105) == 0) {
        EXPECT_EQ(problem("device.png"), "device.png is a device");
    }
}

TEST_F(RunFolder, AHoleOfATerabyteIsNotRead) {
    std::ofstream(in("hole.png"));
    ASSERT_EQ(truncate(in("hole.png").c_str(), 1ll << 40), 0);
    EXPECT_EQ(problem("hole.png", 1 << 20), "hole.png has more than 1048576 bytes");
}

TEST_F(RunFolder, GivingChangesTheOwnerOfWhatIsInItAlone) {
    if (geteuid() != 0) GTEST_SKIP() << "only root gives files away";
    fs::create_directories(in("a/b"));
    std::ofstream(in("a/b/file"));
    fs::create_symlink(place_.expected, in("link"));
    fs::create_directory_symlink(place_.suite, in("folder"));
    fs::create_hard_link(place_.suite + "/scene.pov", in("second-name"));
    give_folder(place_.folder, 61000, 61000);
    for (const char* name : {"", "a", "a/b", "a/b/file", "link", "folder"}) EXPECT_EQ(owner(in(name)), 61000u) << name;
    for (const std::string& path : {place_.suite, place_.expected, place_.suite + "/scene.pov"}) EXPECT_EQ(owner(path), 0u) << path;
    EXPECT_THROW(give_folder(in("folder"), 61000, 61000), std::system_error);
    EXPECT_THROW(give_folder(in("absent"), 61000, 61000), std::system_error);
    give_folder(place_.folder, 0, 0);
    EXPECT_EQ(owner(in("a/b/file")), 0u);
}

TEST_F(RunFolder, ClosedFoldersAreOpened) {
    fs::create_directories(in("a/b/c"));
    for (const char* name : {"a/b", "a", ""}) ASSERT_EQ(chmod(in(name).c_str(), 0), 0);
    give_folder(place_.folder, geteuid(), getegid());
    for (const char* name : {"", "a", "a/b"}) EXPECT_EQ(fs::status(in(name)).permissions(), fs::perms::owner_all) << name;
}

TEST_F(RunFolder, WhatAllTakesIsCounted) {
    const int folder = open(place_.folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    EXPECT_EQ(folder_use(folder, 1 << 20), 0u);
    std::ofstream(in("file")) << std::string(100'000, 'x');
    fs::create_directory(in("a"));
    std::ofstream(in("a/file")) << std::string(100'000, 'x');
    fs::create_symlink("/usr", in("link"));
    EXPECT_THAT(folder_use(folder, 1 << 20), testing::AllOf(testing::Ge(200'000u), testing::Le(250'000u)));
    EXPECT_THAT(folder_use(folder, 5000), testing::Gt(5000u));
    close(folder);
}

}  // namespace
}  // namespace rt::run_folder_test
