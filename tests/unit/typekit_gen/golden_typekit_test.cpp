// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The typekits of tests/golden/{typekit,typekit_view}, compiled and loaded as plugins: what the runtime then knows is
// compared with what typegen reads from the same headers.
#include <algorithm>
#include <memory>

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/base/PropertyBase.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt/types/TypekitRepository.hpp>

#include "golden_typekit.hpp"

using namespace oroforge;
using RTT::types::TypeInfo;
using test::GoldenTypekit;

namespace {

bool isSample(const model::Struct& type) { return type.assignable && type.make.empty(); }

/// The checks of one typekit are one test: each would have to read its headers again.
class LoadedTypekit : public GoldenTypekit {
protected:
    void knowsEveryFieldOfEveryStruct() const;
    void knowsEveryAlias() const;
    void makesNoPortsOfWhatIsNoSample() const;
    void makesPropertiesAndPortsOfEveryType() const;
    void readsAndWritesEveryEnumeratorByName() const;
};

void LoadedTypekit::knowsEveryFieldOfEveryStruct() const {
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

void LoadedTypekit::knowsEveryAlias() const {
    for (const model::Alias& alias : model.aliases) {
        EXPECT_EQ(&typeOf(alias.name), &typeOf(alias.of)) << alias.name;
        EXPECT_EQ(typeOf(alias.name).getTypeName(), alias.of);
    }
}

void LoadedTypekit::makesNoPortsOfWhatIsNoSample() const {
    for (const auto& expected : model.structs) {
        if (isSample(expected)) continue;
        SCOPED_TRACE(expected.name);
        const TypeInfo& type = typeOf(expected.name);
        const std::unique_ptr<RTT::base::PropertyBase> property(type.buildProperty("p", ""));
        ASSERT_TRUE(property);
        EXPECT_EQ(property->getDataSource()->isAssignable(), expected.assignable);
        EXPECT_EQ(type.inputPort("i"), nullptr);
        EXPECT_EQ(type.outputPort("o"), nullptr);
    }
}

void LoadedTypekit::makesPropertiesAndPortsOfEveryType() const {
    std::vector<std::string> names;
    for (const auto& type : model.structs)
        if (isSample(type)) names.push_back(type.name);
    for (const auto& type : model.enums) names.push_back(type.name);
    for (const auto& type : model.library) names.push_back(type.name);
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

void LoadedTypekit::readsAndWritesEveryEnumeratorByName() const {
    for (const model::Enum& expected : model.enums) {
        const TypeInfo& type = typeOf(expected.name);
        const auto value = type.buildValue();
        for (const model::Enumerator& enumerator : expected.values) {
            ASSERT_TRUE(type.fromString(enumerator.name, value)) << enumerator.name;
            const auto first = std::find_if(expected.values.begin(), expected.values.end(),
                                            [&](const auto& other) { return other.value == enumerator.value; });
            EXPECT_EQ(type.toString(value), first->name);  // two names of one number
        }
    }
}

}  // namespace

TEST_P(LoadedTypekit, KnowsWhatTypegenReadsFromItsHeaders) {
    EXPECT_TRUE(RTT::types::TypekitRepository::hasTypekit(name));
    EXPECT_FALSE(model.structs.empty() && model.enums.empty() && model.library.empty()) << "nothing to check";
    knowsEveryFieldOfEveryStruct();
    knowsEveryAlias();
    makesNoPortsOfWhatIsNoSample();
    makesPropertiesAndPortsOfEveryType();
    readsAndWritesEveryEnumeratorByName();
}

INSTANTIATE_TEST_SUITE_P(Golden, LoadedTypekit, testing::ValuesIn(test::builtTypekits()), test::caseName);
