// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Runs of typegen with adapter files.
#include <filesystem>

#include <adapters/accessor.hpp>
#include <adapters/name_pattern.hpp>
#include <adapters/read_adapters.hpp>
#include <support/golden.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace oroforge;
using namespace oroforge::test;

namespace {

const char* const kHeader =
    "#pragma once\n"
    "class Pose {\n"
    "public:\n"
    "    double& x() { return x_; }\n"
    "    double x() const { return x_; }\n"
    "    double operator[](int) const { return x_; }\n"
    "    double& operator[](int) { return x_; }\n"
    "private:\n"
    "    double x_ = 0;\n"
    "};\n"
    "struct Robot { Pose pose; };\n";

std::string file(const std::string& content) { return "<adapters>\n" + content + "\n</adapters>\n"; }

const std::string kPose = "<struct class=\"Pose\"><member name=\"x\" get=\"x()\"/></struct>";

}  // namespace

TEST(AdaptersRun, AreInputsOfTheDepfile) {
    const TempDir dir;
    const auto header = dir.write("t.hpp", kHeader).string(), xml = dir.write("a.xml", file(kPose)).string();
    const std::string depfile = (dir / "d").string();
    const Ran ran =
        runTypegen({"-o", (dir / "out").string(), "--depfile", depfile, "--adapters=" + xml, "demo", header});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(readFile(depfile).find(xml), std::string::npos);
}

TEST(AdaptersRun, TheFirstFileThatFitsIsTaken) {
    const TempDir dir;
    const auto header =
        dir.write("t.hpp", "#pragma once\nnamespace KDL {\n" + std::string(kHeader + 13) + "using Vector = Pose;\n}\n")
            .string();
    const auto xml =
        dir.write("a.xml", file("<sequence class=\"KDL::Vector\" name=\"mine\" size=\"1\" element=\"[index]\"/>"))
            .string();
    const Ran ran = runTypegen({"-o", (dir / "out").string(), "--adapters", xml, "--dump=model", "demo", header});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("\"name\": \"mine\""), std::string::npos) << ran.out;
}

TEST(AdaptersRun, AnAdapterThatIsNotUsedIsAWarning) {
    const TempDir dir;
    const auto header = dir.write("t.hpp", kHeader).string();
    const auto xml =
        dir.write("a.xml", file(kPose + "<struct class=\"Poze\"><member name=\"x\" get=\"y\"/></struct>")).string();
    const Ran ran = runTypegen({"-o", (dir / "out").string(), "--adapters", xml, "demo", header});
    EXPECT_EQ(ran.status, 0);
    EXPECT_NE(ran.err.find("warning: [TK074] no class 'Poze' in the headers; did you mean 'Pose'?"), std::string::npos)
        << ran.err;
}

// Packages share a file, and each uses some of it.
TEST(AdaptersRun, AnAdapterThatIsNotUsedIsNoWarningIfItsFileHasOthersThatAre) {
    const TempDir dir;
    const auto header = dir.write("t.hpp", kHeader).string();
    const std::string other = "<struct class=\"other::Quaternion\"><member name=\"x\" get=\"y\"/></struct>";
    const auto run = [&](const std::string& text) {
        const auto xml = dir.write("a.xml", file(text)).string();
        return runTypegen({"-o", (dir / "out").string(), "--adapters", xml, "demo", header}).err;
    };
    EXPECT_EQ(run(kPose + other), "");
    EXPECT_NE(run(other).find("warning: [TK074] no class 'other::Quaternion' in the headers"), std::string::npos);
}

// A virtual destructor is often all; who writes an adapter says that the class is a value.
TEST(AdaptersRun, AClassMayHaveVirtualFunctionsButNotAbstractOnes) {
    const TempDir dir;
    const auto xml = dir.write("a.xml", file(kPose)).string();
    const auto run = [&](const std::string& function) {
        std::string text = kHeader;
        text.insert(text.find("private:"), "    " + function + "\n");
        const auto header = dir.write("t.hpp", text).string();
        return runTypegen({"-o", (dir / "out").string(), "--adapters", xml, "--dump=model", "demo", header});
    };
    EXPECT_EQ(run("virtual ~Pose() = default;").status, 0);
    EXPECT_NE(run("virtual void f() = 0;").err.find("[TK020] type 'Pose' has virtual functions"), std::string::npos);
}

TEST(AdaptersRun, AreProposedForClassesOfHeadersThatAreNotListed) {
    const TempDir dir;
    dir.write("library.h", "#pragma once\nstruct Blob { unsigned char* data; };\n");
    const auto header =
        dir.write("t.hpp", "#pragma once\n#include \"library.h\"\nstruct A { Blob blob; };\nstruct B { int* own; };\n");
    const Ran ran = runTypegen({"-o", (dir / "out").string(), "demo", header.string()});
    EXPECT_NE(ran.err.find("note: store the value itself, or a std::vector of values; if that header is not yours, an "
                           "adapter says how the class is seen (--adapters=FILE)\n"),
              std::string::npos)
        << ran.err;
    EXPECT_NE(ran.err.find("note: store the value itself, or a std::vector of values\n"), std::string::npos) << ran.err;
}

TEST(AdaptersRun, ThoseThatAreShippedAreSound) {
    diag::Sink sink;
    EXPECT_GT(adapters::readAdapters({}, sink).size(), 20U);
    EXPECT_TRUE(sink.empty());
}

TEST(Accessor, BecomesCppWithItsVariablesReplaced) {
    diag::Sink sink;
    const auto cpp = [&](const std::string& text) {
        return adapters::cppOf(
            adapters::bound(adapters::parseAccessor(text, {}, {"index", "value"}, sink), {{"N", "3"}}));
    };
    EXPECT_EQ(cpp("x"), ".x");
    EXPECT_EQ(cpp(" M . p ( ) "), ".M.p()");
    EXPECT_EQ(cpp("at( index,$N )[0]"), ".at(index, 3)[0]");
    EXPECT_EQ(cpp("(value)"), "(value)");
    EXPECT_EQ(cpp("$N"), "3");
    EXPECT_TRUE(sink.empty());
}

TEST(NamePattern, HasVariablesWithAndWithoutBraces) {
    const std::map<std::string, std::string> variables = {{"N", "3"}, {"Nd", "4"}};
    EXPECT_EQ(adapters::expanded("/a/V${N}d", variables), "/a/V3d");
    EXPECT_EQ(adapters::expanded("/a/V$Nd", variables), "/a/V4");
    EXPECT_EQ(adapters::expanded("$N$N", variables), "33");
    for (const char* bad : {"$", "a${N", "$-", "${}"}) {
        bool hasBadPart = false;
        for (const auto& part : adapters::partsOf(bad))
            hasBadPart = hasBadPart || (part.isVariable && part.text.empty());
        EXPECT_TRUE(hasBadPart) << bad;
    }
}

TEST(AdaptersRun, AreNotSaidToBeUnusedBecauseOfAHeaderThatDoesNotCompile) {
    const TempDir dir;
    const auto bad = dir.write("bad.hpp", "#pragma once\nstruct Bad { int x\n").string();
    const auto good = dir.write("good.hpp", kHeader).string();
    const auto more = dir.write("more.hpp", "#pragma once\nstruct More {};\n").string();
    const auto xml = dir.write("a.xml", file(kPose)).string();
    const Ran ran = runTypegen({"-o", (dir / "out").string(), "--adapters=" + xml, "demo", bad, good, more});
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(ran.err.find("TK074"), std::string::npos) << ran.err;
}

TEST(AdaptersRun, ListTheirTypesWhenAsked) {
    const TempDir dir;
    const auto header = dir.write("t.hpp", kHeader).string();
    const std::string list = "<sequence class=\"Pose\" size=\"1\" element=\"[index]\"/>";
    const auto xml = dir.write("a.xml", file(list)).string();
    const Ran ran = runTypegen({"-v", "-o", (dir / "out").string(), "--adapters=" + xml, "demo", header});
    EXPECT_EQ(ran.status, 0) << ran.err;
    EXPECT_NE(ran.out.find("class /Pose\n"), std::string::npos) << ran.out;
}
