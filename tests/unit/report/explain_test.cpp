// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Every code has an explanation, and what explanations show is true: the example gives the error, the advice does not.
#include <explain/explanations.hpp>

#include <support/child_process.hpp>
#include <support/explained.hpp>
#include <support/golden.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;
using namespace oroforge;
using namespace oroforge::test;

namespace {

Ran typegen(const std::string& text) {
    const TempDir dir;
    const std::string header = dir.write("example.hpp", "#pragma once\n" + text).string();
    return runTypegen({"-o", (dir / "out").string(), "demo", header});
}

/// Beside the manifest lies the header that some explanations show.
Ran orocreatePkg(const std::string& manifest) {
    const TempDir dir;
    dir.write("types.hpp",
              "#pragma once\n"
              "namespace tank {\n"
              "class Filter { double state_ = 0; };\n"
              "struct Gains { double p = 0; };\n"
              "enum class Mode { idle, heat };\n"
              "}\n");
    Command command;
    command.program = OROCREATE_PKG;
    command.directory = dir.path();
    command.arguments = {"--generate", dir.write("tank.xml", manifest).string(), "--output", (dir / "out").string()};
    const Outcome outcome = run(command);
    return {outcome.status, outcome.out, outcome.err};
}

/// Examples are headers, or of the codes OM manifests.
Ran readBy(const std::string& code, const std::string& example) {
    return code.compare(0, 2, "OM") == 0 ? orocreatePkg(example) : typegen(example);
}

class Explained : public testing::TestWithParam<std::string> {};
class Example : public testing::TestWithParam<std::string> {};
class WayOut : public testing::TestWithParam<std::string> {};

}  // namespace

TEST(Explanations, AreThereForEveryCodeAndForNoOther) {
    expectExplained(explain::explanations(),
                    {"generator/adapters", "generator/check", "generator/clang", "generator/driver", "generator/emit",
                     "generator/flags", "generator/manifest", "generator/merge", "generator/model", "generator/render",
                     "generator/view", "typekit_gen"},
                    "TK|EMIT|OM|OC|RM");
}

TEST_P(Explained, ByATitleAndAParagraph) { expectReadable(*explain::explanations().of(GetParam())); }

TEST_P(Example, GivesTheCode) {
    const Ran ran = readBy(GetParam(), block(*explain::explanations().of(GetParam()), "Example:"));
    EXPECT_NE(ran.err.find("[" + GetParam() + "]"), std::string::npos) << ran.err;
}

TEST_P(WayOut, IsAccepted) {
    const Ran ran = readBy(GetParam(), block(*explain::explanations().of(GetParam()), "Instead:"));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "");
}

INSTANTIATE_TEST_SUITE_P(Codes, Explained, testing::ValuesIn(codesOf(explain::explanations())), caseName);
INSTANTIATE_TEST_SUITE_P(Codes, Example, testing::ValuesIn(codesWith("Example:", explain::explanations())), caseName);
INSTANTIATE_TEST_SUITE_P(Codes, WayOut, testing::ValuesIn(codesWith("Instead:", explain::explanations())), caseName);
