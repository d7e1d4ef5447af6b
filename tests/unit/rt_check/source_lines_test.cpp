// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// File and line of functions of this program.
#include <bin/source_lines.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include <dlfcn.h>

extern "C" [[gnu::noinline]] int functionWithALine(int number) { return number + 1; }
static const unsigned kItsLine = __LINE__ - 1;

namespace {

using OCL::deploy::SourceLines;

/** Of that function in this program. */
unsigned long offset() {
    Dl_info info{};
    void* const function = reinterpret_cast<void*>(&functionWithALine);
    EXPECT_NE(0, dladdr(function, &info));
    return reinterpret_cast<std::uintptr_t>(function) - reinterpret_cast<std::uintptr_t>(info.dli_fbase);
}

const std::string kProgram = std::filesystem::read_symlink("/proc/self/exe");

TEST(SourceLines, AreThoseOfTheDebugInformation) {
    SourceLines lines;
    lines.want(kProgram, offset());
    lines.find();
    const SourceLines::Place& place = lines.at(kProgram, offset());
    EXPECT_EQ("functionWithALine", place.function);
    EXPECT_EQ(kItsLine, place.where.line);
    EXPECT_EQ("source_lines_test.cpp", std::filesystem::path(place.where.file.str()).filename());
}

TEST(SourceLines, AreNotKnownOfWhatIsNoCodeOrNotThere) {
    SourceLines lines;
    lines.want(kProgram, 1);
    lines.want("/no/such/library.so", 0x1234);
    lines.want("/dev/null", 0x1234);
    lines.find();
    for (const auto& [file, place] :
         {std::pair(kProgram, 1ul), std::pair(std::string("/no/such/library.so"), 0x1234ul)})
        EXPECT_EQ(0u, lines.at(file, place).where.line);
}

TEST(SourceLines, FilesMayHaveAnyName) {
    const oroforge::test::TempDir directory;
    const std::string file = (directory.path() / "it's $(a) \"copy\"").string();
    std::filesystem::copy_file(kProgram, file);
    SourceLines lines;
    for (unsigned long place = 0; place != 3000; ++place) lines.want(file, offset() + 100 * place);  // several calls
    lines.find();
    EXPECT_EQ(kItsLine, lines.at(file, offset()).where.line);
}

}  // namespace
