// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The typekits of tests/golden/typekit, compiled and loaded as plugins: what the runtime then knows is compared with
// what typegen reads from the same headers.
#include <dlfcn.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include <clang/type_reader.hpp>
#include <collect/close_model.hpp>
#include <collect/header_inputs.hpp>
#include <driver/options.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/base/PropertyBase.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt/types/TypekitRepository.hpp>
#include <support/golden.hpp>

namespace fs = std::filesystem;
using namespace oroforge;
using RTT::types::TypeInfo;

namespace {

std::vector<std::string> wordsOf(const fs::path& dir) {
    std::vector<std::string> words;
    std::ifstream file(dir / "args");
    for (std::string line; std::getline(file, line);) words.push_back(line);
    return words;
}

class GoldenTypekit : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        const fs::path dir = test::goldenDir("typekit", GetParam());
        const fs::path before = fs::current_path();
        fs::current_path(dir);
        diag::Sink sink;
        const auto options = typekit::parseOptions(wordsOf(dir), sink);
        ASSERT_TRUE(options);
        name = options->name;
        cxx::ParseRequest request;
        request.headers = typekit::findHeaders(options->inputs, options->flags, options->name, sink);
        auto read = cxx::readTypes(request, sink);
        fs::current_path(before);
        ASSERT_TRUE(read);
        model = *read;
        typekit::closeModel(model, sink);
        load(RTT_TYPEKIT_FILE);  // the types of numbers and strings
        load(std::string(GOLDEN_TYPEKIT_DIR) + "/libgolden_typekit_" + GetParam() + ".so");
    }

    static void load(const std::string& file) {
        void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(library, nullptr) << ::dlerror();
        const auto loadPlugin = reinterpret_cast<bool (*)(void*)>(::dlsym(library, "loadRTTPlugin"));
        ASSERT_NE(loadPlugin, nullptr);
        ASSERT_TRUE(loadPlugin(nullptr));
    }

    static const TypeInfo& typeOf(const std::string& name) {
        const TypeInfo* type = RTT::types::Types()->type(name);
        if (type == nullptr) throw std::out_of_range("no type " + name);
        return *type;
    }

    std::string name;
    model::TypeModel model;
};

}  // namespace

TEST_P(GoldenTypekit, RegistersUnderItsName) { EXPECT_TRUE(RTT::types::TypekitRepository::hasTypekit(name)); }

TEST_P(GoldenTypekit, KnowsEveryFieldOfEveryStruct) {
    for (const model::Struct& expected : model.structs) {
        SCOPED_TRACE(expected.name);
        const TypeInfo& type = typeOf(expected.name);
        std::vector<std::string> names;
        for (const model::Field& field : expected.fields) names.push_back(field.name);
        EXPECT_EQ(type.getMemberNames(), names);
        const auto value = type.buildValue();
        ASSERT_TRUE(value);
        for (const std::string& member : names) EXPECT_TRUE(type.getMember(value, member)) << member;
        EXPECT_EQ(type.getDescription(), expected.doc);
    }
}

TEST_P(GoldenTypekit, MakesPropertiesAndPortsOfEveryType) {
    std::vector<std::string> names;
    for (const auto& type : model.structs) names.push_back(type.name);
    for (const auto& type : model.enums) names.push_back(type.name);
    for (const auto& type : model.sequences) names.push_back(type.name);
    for (const std::string& typeName : names) {
        SCOPED_TRACE(typeName);
        const TypeInfo& type = typeOf(typeName);
        const std::unique_ptr<RTT::base::PropertyBase> property(type.buildProperty("p", ""));
        const std::unique_ptr<RTT::base::InputPortInterface> input(type.inputPort("i"));
        const std::unique_ptr<RTT::base::OutputPortInterface> output(type.outputPort("o"));
        ASSERT_TRUE(property);
        ASSERT_TRUE(input);
        ASSERT_TRUE(output);
        EXPECT_EQ(property->getTypeInfo(), &type);
        EXPECT_EQ(input->getTypeInfo(), output->getTypeInfo());
    }
}

TEST_P(GoldenTypekit, ReadsAndWritesEveryEnumeratorByName) {
    for (const model::Enum& expected : model.enums) {
        const TypeInfo& type = typeOf(expected.name);
        const auto value = type.buildValue();
        for (const model::Enumerator& enumerator : expected.values) {
            ASSERT_TRUE(type.fromString(enumerator.name, value)) << enumerator.name;
            EXPECT_EQ(type.toString(value), enumerator.name);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Golden, GoldenTypekit, testing::ValuesIn(test::goldenCases("typekit")), test::caseName);
