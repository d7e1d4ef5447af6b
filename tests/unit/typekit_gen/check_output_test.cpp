// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// typegen --check: output that was committed is what would be generated, or it is said what is not.
#include <driver/typegen.hpp>

#include <filesystem>
#include <sstream>

#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

class CheckOutput : public ::testing::Test {
protected:
    CheckOutput() {
        header("double x;");
        EXPECT_EQ(typegen({}), 0) << err_;
    }

    void header(const std::string& fields) {
        header_ =
            dir_.write("include/demo/types.hpp", "#pragma once\nnamespace demo { struct A { " + fields + " }; }\n")
                .string();
    }
    int typegen(std::vector<std::string> words) {
        words.insert(words.end(), {"-o", out(), "demo", header_});
        std::ostringstream out, err;
        const int status = oroforge::typekit::run(words, out, err);
        err_ = err.str();
        return status;
    }
    /// The check fails and leaves everything as it was.
    void expectFault(const std::string& text) {
        const auto before = readTree(dir_.path());
        EXPECT_EQ(typegen({"--check"}), 1);
        EXPECT_NE(err_.find(text), std::string::npos) << err_;
        EXPECT_NE(err_.find("[TK067]"), std::string::npos) << err_;
        EXPECT_EQ(readTree(dir_.path()), before);
    }
    std::string out(const std::string& name = "") const { return (dir_ / "generated" / name).string(); }

    const TempDir dir_;
    std::string header_, err_;
};

}  // namespace

TEST_F(CheckOutput, PassesWhenNothingChanged) {
    EXPECT_EQ(typegen({"--check"}), 0) << err_;
    header("double x; /* not for the docs */");
    EXPECT_EQ(typegen({"--check"}), 0) << err_;
}

TEST_F(CheckOutput, NamesWhatIsStaleAndHowToRefresh) {
    header("double x, y;");
    expectFault("types_");
    EXPECT_NE(err_.find("error: [TK067] stale: typegen now writes '"), std::string::npos) << err_;
    EXPECT_NE(err_.find("to refresh: typegen -o " + out("").substr(0, out("").size() - 1)), std::string::npos) << err_;
    EXPECT_EQ(typegen({}), 0);
    EXPECT_EQ(typegen({"--check"}), 0) << err_;
}

TEST_F(CheckOutput, NamesWhatIsMissing) {
    fs::remove(out("Plugin.cpp"));
    fs::remove(out("types_types.cpp"));
    expectFault("Plugin.cpp: error: [TK067] missing");
    EXPECT_NE(err_.find("types_types.cpp: error: [TK067] missing"), std::string::npos) << err_;
}

TEST_F(CheckOutput, NamesWhatAnEarlierTypegenLeft) {
    fs::copy(out("types_types.cpp"), out("types_99.cpp"));
    fs::create_directories(out("types/renamed/typekit"));
    fs::copy(out("types/demo/typekit/Types.hpp"), out("types/renamed/typekit/Types.hpp"));
    dir_.write("generated/mine.cpp", "// by hand\n");
    expectFault("types_99.cpp: error: [TK067] superfluous");
    EXPECT_NE(err_.find("types/renamed/typekit/Types.hpp: error: [TK067] superfluous"), std::string::npos) << err_;
    EXPECT_EQ(err_.find("mine.cpp"), std::string::npos) << err_;
}

TEST_F(CheckOutput, NoticesWhatWasEdited) {
    const std::string text = readFile(out("Plugin.cpp"));
    dir_.write("generated/Plugin.cpp", text + "// added\n");
    expectFault("stale: typegen now writes fewer lines");
    dir_.write("generated/Plugin.cpp", text.substr(0, text.size() / 2));
    expectFault("Plugin.cpp:");
    std::string crlf;
    for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    dir_.write("generated/Plugin.cpp", crlf);
    expectFault("Plugin.cpp:1: error: [TK067] stale: lines end with CR LF");
}

TEST_F(CheckOutput, SaysWhatItIsTold) {
    fs::remove(out("Plugin.cpp"));
    EXPECT_EQ(typegen({"--check=cmake --build . --target refresh"}), 1);
    EXPECT_NE(err_.find("note: cmake --build . --target refresh"), std::string::npos) << err_;
}
