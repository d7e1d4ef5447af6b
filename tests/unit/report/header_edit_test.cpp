// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <clang/base/header_edit.hpp>

#include <gtest/gtest.h>

using namespace oroforge::cxx;

namespace {

/// The header after the insertion.
std::string withInclude(std::string header) {
    const auto at = placeForInclude(header, "string");
    if (!at) return "there already";
    return header.insert(*at, "#include <string>\n");
}

}  // namespace

TEST(PlaceForInclude, IsBeforeTheFirstInclude) {
    EXPECT_EQ(withInclude("// text\n#pragma once\n#include <vector>\nint x;\n"),
              "// text\n#pragma once\n#include <string>\n#include <vector>\nint x;\n");
    EXPECT_EQ(withInclude("#ifndef G\n#define G\n\n# include \"a.h\"\n#endif\n"),
              "#ifndef G\n#define G\n\n#include <string>\n# include \"a.h\"\n#endif\n");
}

TEST(PlaceForInclude, IsBehindTheGuardIfNothingIsIncluded) {
    EXPECT_EQ(withInclude("#pragma once\nint x;\n"), "#pragma once\n#include <string>\nint x;\n");
    EXPECT_EQ(withInclude("#ifndef G\n#define G 1\nint x;\n#endif\n"),
              "#ifndef G\n#define G 1\n#include <string>\nint x;\n#endif\n");
    EXPECT_EQ(withInclude("int x;\n"), "#include <string>\nint x;\n");
    EXPECT_EQ(withInclude("#pragma once"), "#pragma once#include <string>\n") << "a file of one line without its end";
}

TEST(PlaceForInclude, LeavesOutIncludesUnderConditions) {
    EXPECT_EQ(withInclude("#pragma once\n#ifdef X\n#include <x>\n#endif\n#include <y>\n"),
              "#pragma once\n#ifdef X\n#include <x>\n#endif\n#include <string>\n#include <y>\n");
    EXPECT_EQ(withInclude("#ifdef X\n#include <x>\n#endif\nint x;\n"),
              "#include <string>\n#ifdef X\n#include <x>\n#endif\nint x;\n");
}

TEST(PlaceForInclude, IsNowhereIfItIsThere) {
    EXPECT_EQ(withInclude("#include <vector>\r\n#\tinclude <string>\r\n"), "there already");
    EXPECT_NE(withInclude("#include <string.h>\n"), "there already");
}

TEST(PlaceForPragmaOnce, IsBehindAByteOrderMark) {
    EXPECT_EQ(placeForPragmaOnce("int x;"), 0U);
    EXPECT_EQ(placeForPragmaOnce("\xEF\xBB\xBFint x;"), 3U);
    EXPECT_EQ(placeForPragmaOnce(""), 0U);
}

TEST(GuardOf, IsTheMacroAroundTheWholeText) {
    EXPECT_EQ(guardOf("// text\n#ifndef A_HPP // guard\n#define A_HPP\n#if 1\n#endif\nint x;\n#endif  // A_HPP\n"),
              "A_HPP");
    EXPECT_EQ(guardOf("#pragma once\nint x;\n"), "");
    EXPECT_EQ(guardOf("#ifndef MOST\n#define MOST 4\n#endif\n#include <a>\n"), "");
    EXPECT_EQ(guardOf("#ifndef NO_TYPES\nint x;\n#endif\n"), "");
    EXPECT_EQ(guardOf("#ifdef A\n#define A\n#endif\n"), "");
}
