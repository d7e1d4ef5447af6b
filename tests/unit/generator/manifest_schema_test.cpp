// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The XSD that is shipped for editors agrees with the rules by which manifests are checked.
#include <filesystem>

#include <gtest/gtest.h>
#include <manifest/schema.hpp>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;

namespace oroforge {
namespace {

fs::path schemaFile() { return test::sourceRoot() / "share/component_manifest.xsd"; }

/// Empty if xmllint finds the file valid.
std::string faultsOf(const fs::path& manifest) {
    test::Command command;
    command.program = "xmllint";
    command.arguments = {"--noout", "--schema", schemaFile().string(), manifest.string()};
    const test::Outcome outcome = test::run(command);
    return outcome.status == 0 ? "" : outcome.err;
}

std::vector<fs::path> manifestsBelow(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".xml") continue;
        if (test::readFile(entry.path()).find("<package name=") != std::string::npos) found.push_back(entry.path());
    }
    return found;
}

TEST(ManifestSchema, IsWhatTheRulesSay) { test::expectGolden(schemaFile(), manifest::schemaText()); }

TEST(ManifestSchema, EveryManifestOfTheTreeIsValid) {
    std::size_t checked = 0;
    for (const char* folder : {"examples", "tests/golden/component", "tests/golden/package",
                               "tests/golden/manifest_model", "tests/golden/manifest_view"}) {
        for (const fs::path& manifest : manifestsBelow(test::sourceRoot() / folder)) {
            EXPECT_EQ(faultsOf(manifest), "") << manifest;
            ++checked;
        }
    }
    EXPECT_GE(checked, 20u);
}

TEST(ManifestSchema, FaultyManifestsAreNot) {
    for (const char* name : {"unknown_names", "missing_attributes", "bad_values"}) {
        EXPECT_NE(faultsOf(test::goldenDir("manifest_diagnostics", name) / "m.xml"), "") << name;
    }
}

}  // namespace
}  // namespace oroforge
