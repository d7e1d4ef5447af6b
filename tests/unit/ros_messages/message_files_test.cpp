// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <messages/message_files.hpp>
#include <messages/message_model.hpp>

#include "message_text.hpp"

namespace oroforge::embedded {
diag::EmbeddedFiles messageTemplates();
}

namespace oroforge::messages {
namespace {

using test::MessageFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

emit::Outputs rendered(MessageFolder& folder, const std::vector<std::string>& names, const ModelRules& rules = {}) {
    std::vector<const Message*> messages;
    for (const std::string& name : names) messages.push_back(folder.read("demo/" + name));
    EXPECT_EQ(folder.firstError(), "");
    return renderMessages("demo", messages, folder.set, rules,
                          render::Renderer(render::Templates(embedded::messageTemplates())));
}

TEST(MessageFiles, namesAreTheSameAsThoseOfTheTexts) {
    MessageFolder folder;
    ModelRules rules;
    rules.perSource = 2;
    const std::vector<std::string> names = {"A", "B", "C"};
    for (const std::string& name : names) folder.write("demo/" + name, "int8 x\n");
    std::vector<std::string> made;
    for (const auto& [name, text] : rendered(folder, names, rules)) made.push_back(name);
    EXPECT_THAT(messageOutputs("demo", names, rules), testing::UnorderedElementsAreArray(made));
    EXPECT_THAT(made, testing::IsSupersetOf({"types_A.cpp", "types_C.cpp", "Plugin.cpp", "Transport.cpp",
                                             "include/demo/typekit/B.h", "include/demo/boost/B.h"}));
    EXPECT_THAT(serviceOutputs("demo", {"S"}, rules), ElementsAre("types_SRequest.cpp", "Services.cpp"));
}

TEST(MessageFiles, typesHaveTheNamesOfRos) {
    MessageFolder folder;
    folder.write("demo/Point", "float64 x\n");
    folder.write("demo/Path", "Point[] points\nPoint[4] corners\nfloat64[9] m\nbool good\nstring[] words\ntime at\n");
    const std::string text = rendered(folder, {"Point", "Path"}).at("types_Point.cpp");
    EXPECT_THAT(text, HasSubstr("makeStructType<::demo::Point_<std::allocator<void>>>(\"/demo/Point\""));
    EXPECT_THAT(text,
                HasSubstr("makeSequenceType<std::vector<::demo::Point_<std::allocator<void>>>>(\"/demo/Point[]\""));
    EXPECT_THAT(text, HasSubstr("makeArrayType<::demo::Point_<std::allocator<void>>>(\"/demo/cPoint[]\")"));
    EXPECT_THAT(text, HasSubstr("makeArrayType<::demo::Path_<std::allocator<void>>>(\"/demo/cPath[]\")"));
    EXPECT_THAT(text, HasSubstr("&RTT::types::typeRef<double>, 9"));
    EXPECT_THAT(text, HasSubstr("boost::array<double, 9>"));
    EXPECT_THAT(text, HasSubstr("&RTT::types::typeRef<std::uint8_t>, 0"));
    EXPECT_THAT(text, HasSubstr("MD5Sum<::demo::Path_<std::allocator<void>>>::static_value1 == 0x"));
    EXPECT_THAT(text, HasSubstr("<demo/Path.h> and the description of demo/Path from which"));
}

TEST(MessageFiles, arraysWithoutElementsAreLeftOut) {
    MessageFolder folder;
    folder.write("demo/Odd", "int8[0] hollow\nint8 x\n");
    const auto files = rendered(folder, {"Odd"});
    EXPECT_THAT(files.at("types_Odd.cpp"), Not(HasSubstr("hollow")));
    EXPECT_THAT(files.at("include/demo/boost/Odd.h"), Not(HasSubstr("hollow")));
}

TEST(MessageFiles, dependenciesAndConstantsAreInThePlugin) {
    MessageFolder folder;
    folder.write("other/Part", "int8 x\n");
    folder.write("demo/Whole", "other/Part part\nstring WORD=say \"hi\"\n");
    const std::string plugin = rendered(folder, {"Whole"}).at("Plugin.cpp");
    EXPECT_THAT(plugin, HasSubstr("needTypes(\"other\")"));
    EXPECT_THAT(plugin, HasSubstr("{ \"demo.Whole.WORD\", \"string\", \"say \\\"hi\\\"\" }"));
}

TEST(MessageFiles, transportHasTheWholeDefinition) {
    MessageFolder folder;
    folder.write("demo/Part", "int8 x # \xc3\xa4 \"\\\n");
    folder.write("demo/Whole", "Part part\n");
    const std::string text = rendered(folder, {"Whole"}).at("Transport.cpp");
    EXPECT_THAT(text, HasSubstr("{ \"/demo/Whole\", \"demo/Whole\", \""));
    EXPECT_THAT(text, HasSubstr("\"MSG: demo/Part\\n\"\n      \"int8 x # \xc3\xa4 \\\"\\\\\\n\""));
}

TEST(MessageFiles, onlyTheSourcesOfAChangedMessageChange) {
    ModelRules rules;
    rules.perSource = 1;
    MessageFolder before, after;
    for (MessageFolder* folder : {&before, &after}) {
        folder->write("demo/A", "int8 x\n");
        folder->write("demo/B", folder == &before ? "int8 x\n" : "int8 y\n");
    }
    const auto old = rendered(before, {"A", "B"}, rules), now = rendered(after, {"A", "B"}, rules);
    std::vector<std::string> changed;
    for (const auto& [name, text] : now)
        if (old.at(name) != text) changed.push_back(name);
    EXPECT_THAT(changed,
                ElementsAre("Transport.cpp", "include/demo/boost/B.h", "include/demo/typekit/B.h", "types_B.cpp"));
}

}  // namespace
}  // namespace oroforge::messages
