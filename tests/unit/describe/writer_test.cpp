// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reading what was written gives the model again.
#include <regex>

#include <manifest/reader.hpp>
#include <manifest/writer.hpp>

#include <gtest/gtest.h>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;

namespace oroforge::test {
namespace {

/// What differs only in where it stands is the same.
std::string withoutPlaces(const model::Package& package) {
    return std::regex_replace(model::dump(package), std::regex(R"(,?\s*"at": "[0-9]+:[0-9]+")"), "");
}

std::vector<std::string> manifestsOf(const fs::path& folder) {
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string text = entry.path().extension() == ".xml" ? readFile(entry.path()) : "";
        if (text.find("<package name=") != std::string::npos && text.find("<component ") != std::string::npos)
            found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

TEST(ManifestWriter, WritesWhatTheReaderReads) {
    std::size_t read = 0;
    for (const char* folder : {"tests/golden/component", "tests/golden/manifest_model", "examples"}) {
        for (const std::string& file : manifestsOf(sourceRoot() / folder)) {
            diag::Sink sink, again;
            const auto package = manifest::readFile(file, sink);
            if (!package || sink.hadErrors()) continue;
            const std::string text = manifest::write(*package);
            const auto second = manifest::readText(text, "written.xml", again);
            ASSERT_TRUE(second && again.empty()) << file << "\n" << text;
            EXPECT_EQ(withoutPlaces(*second), withoutPlaces(*package)) << file << "\n" << text;
            EXPECT_EQ(manifest::write(*second), text) << file;
            ++read;
        }
    }
    EXPECT_GE(read, 5U);
}

model::Text given(const std::string& text) { return {text, {"x", 1, 1}}; }

TEST(ManifestWriter, KeepsTextsThatXmlWouldChange) {
    model::Package package;
    package.name = given("p");
    package.components.resize(1);
    model::Component& component = package.components[0];
    component.className = given("C");
    component.doc = " two\nlines, \"quoted\" <&> and  blanks ";
    model::Property property;
    property.name = given("text");
    property.type = given("std::string");
    property.defaultValue = given("\ta\r\n \"b\" ");
    property.doc = "it's <b>";
    component.properties.push_back(property);
    diag::Sink sink;

    const auto read = manifest::readText(manifest::write(package), "written.xml", sink);

    ASSERT_TRUE(read && sink.empty());
    EXPECT_EQ(read->components[0].doc, component.doc);
    EXPECT_EQ(read->components[0].properties[0].defaultValue.value, property.defaultValue.value);
    EXPECT_EQ(read->components[0].properties[0].doc, property.doc);
}

TEST(ManifestWriter, WritesActivitiesAndPoliciesOnlyAsFarAsTheyAreNotTheDefault) {
    const auto written = [](const std::string& attributes, const std::string& content = "") {
        diag::Sink sink;
        const std::string text =
            "<package name=\"p\"><component class=\"C\"" + attributes + ">" + content + "</component></package>";
        const auto package = manifest::readText(text, "given.xml", sink);
        EXPECT_TRUE(package && sink.empty()) << text;
        const std::string again = manifest::write(*package);
        const std::size_t begin = again.find("<component");
        return again.substr(begin, again.find('\n', begin) - begin);
    };
    EXPECT_EQ(written(" activity=\"periodic\" period=\"0.10\""), "<component class=\"C\" period=\"0.10\"/>");
    EXPECT_EQ(written(" activity=\"nonperiodic\""), "<component class=\"C\" activity=\"nonperiodic\"/>");
    EXPECT_EQ(written(" activity=\"slave\" period=\"1\""), "<component class=\"C\" activity=\"slave\" period=\"1\"/>");
    EXPECT_EQ(written(" activity=\"nonperiodic\" priority=\"3\""), "<component class=\"C\" priority=\"3\"/>");
    EXPECT_EQ(written(" initial=\"Stopped\""), "<component class=\"C\"/>");
    EXPECT_EQ(written("", "<hooks configure=\"true\" start=\"true\" update=\"true\" stop=\"true\" cleanup=\"true\"/>"),
              "<component class=\"C\"/>");
}

}  // namespace
}  // namespace oroforge::test
