// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The packages that a process has loaded, for the metadata of recordings.
#include <reporting/mcap_file/packages.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/** A file in the memory of this process, as a library is. */
class Mapped {
public:
    explicit Mapped(const fs::path& file) {
        fs::create_directories(file.parent_path());
        std::ofstream(file) << "library";
        const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
        at_ = ::mmap(nullptr, kSize, PROT_READ, MAP_PRIVATE, opened, 0);
        ::close(opened);
    }
    ~Mapped() { ::munmap(at_, kSize); }
    Mapped(const Mapped&) = delete;
    Mapped& operator=(const Mapped&) = delete;

private:
    static constexpr std::size_t kSize = 7;
    void* at_;
};

TEST(LoadedPackages, HaveTheVersionsOfTheirDescriptions) {
    const oroforge::test::TempDir prefix;
    const fs::path lib = prefix / "lib";
    prefix.write("lib/pkgconfig/tank-gnulinux.pc", "Name: tank-gnulinux\nVersion: 1.4.2 \nLibs: -L${libdir}\n");
    prefix.write("lib/pkgconfig/my-arm-gnulinux.pc", "Version:0.1\r\n");
    const Mapped tank(lib / "orocos/gnulinux/tank/libtank-gnulinux.so.1.4");
    const Mapped typekit(lib / "orocos/gnulinux/tank/types/libtank-typekit-gnulinux.so");
    const Mapped arm(lib / "orocos/my-arm/plugins/libarm-service-gnulinux.so");
    const Mapped unknown(lib / "orocos/gnulinux/bare/libbare-gnulinux.so");
    const Mapped own(lib / "orocos/gnulinux/types/librtt-typekit-gnulinux.so");
    const Mapped elsewhere(lib / "libelse-gnulinux.so");
    EXPECT_EQ("bare, my-arm 0.1, tank 1.4.2", OCL::recording::packagesOf(::getpid()));
}

TEST(LoadedPackages, OfAProcessThatIsGoneAreNone) { EXPECT_EQ("", OCL::recording::packagesOf(0)); }

}  // namespace
