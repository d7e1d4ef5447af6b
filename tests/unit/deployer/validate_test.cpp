// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <deployment/validate.hpp>
#include <deployment/xml_to_plan.hpp>

#include <gmock/gmock.h>

namespace {

using namespace OCL::deploy;
using oroforge::diag::Sink;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Surroundings surroundings() {
    Surroundings result;
    result.deployer = "Deployer";
    result.components = {"Existing"};
    result.componentTypes = {"ns::Controller", "ns::Plant"};
    return result;
}

std::vector<std::string> messages(const std::string& elements) {
    Sink sink;
    const Plan plan = readPlanText("<properties>" + elements + "</properties>", "test.xml", sink);
    EXPECT_FALSE(sink.hadErrors());
    Sink validation;
    validate(plan, surroundings(), validation);
    std::vector<std::string> result;
    for (const auto& diagnostic : validation.sorted()) result.push_back(diagnostic.code + " " + diagnostic.message);
    return result;
}

std::string component(const std::string& name, const std::string& type, const std::string& content = "") {
    return "<struct name='" + name + "' type='" + type + "'>" + content + "</struct>";
}

std::string peers(const std::string& name) {
    return "<struct name='Peers' type='PropertyBag'><simple type='string'><value>" + name +
           "</value></simple></struct>";
}

std::string master(const std::string& name) {
    return "<struct name='Activity' type='SlaveActivity'><simple name='Master' type='string'><value>" + name +
           "</value></simple></struct>";
}

TEST(Validate, KnownTypeNewNameIsFine) { EXPECT_THAT(messages(component("c", "ns::Controller")), IsEmpty()); }

TEST(Validate, UnknownTypeIsAnsweredWithTheNearest) {
    EXPECT_THAT(messages(component("c", "ns::Controler")),
                ElementsAre("DEP031 unknown component type 'ns::Controler'; did you mean 'ns::Controller'?"));
}

TEST(Validate, ComponentOfTheSameNameTwiceIsAnErrorUnlessItOnlyAddsOptions) {
    EXPECT_THAT(messages(component("c", "ns::Plant") + component("c", "ns::Plant")), ElementsAre(HasSubstr("DEP009")));
    EXPECT_THAT(messages(component("c", "ns::Plant") + component("c", "PropertyBag")), IsEmpty());
}

TEST(Validate, OptionsNeedAComponent) {
    EXPECT_THAT(messages(component("Deployer", "PropertyBag") + component("this", "PropertyBag") +
                         component("Existing", "PropertyBag")),
                IsEmpty());
    EXPECT_THAT(messages(component("Exisiting", "PropertyBag")),
                ElementsAre("DEP031 there is no component 'Exisiting' to add options to; did you mean 'Existing'?"));
}

TEST(Validate, PeersAndMastersAreOfThePlanOrExist) {
    EXPECT_THAT(messages(component("a", "ns::Plant", peers("b")) +
                         component("b", "ns::Plant", peers("Existing") + master("a"))),
                IsEmpty());
    EXPECT_THAT(messages(component("a", "ns::Plant", peers("x"))), ElementsAre(HasSubstr("DEP016")));
    EXPECT_THAT(messages(component("a", "ns::Plant", master("x"))), ElementsAre(HasSubstr("DEP017")));
    EXPECT_THAT(messages(component("a", "ns::Plant", master("a"))),
                ElementsAre("DEP017 component 'a' is its own master"));
}

TEST(Validate, FilesMustExist) {
    EXPECT_THAT(messages(component("a", "ns::Plant",
                                   "<simple name='PropertyFile' type='string'><value>none.cpf</value></simple>")),
                ElementsAre("DEP020 no such file: 'none.cpf'"));
}

TEST(Validate, PolicyIsGivenOnceAndUsed) {
    const std::string policy =
        "<struct name='wire' type='ConnPolicy'><simple name='type' type='short'><value>0</value></simple></struct>";
    const std::string port =
        "<struct name='Ports' type='PropertyBag'><simple name='p' type='string'><value>wire</value></simple></struct>";
    EXPECT_THAT(messages(policy + component("a", "ns::Plant", port)), IsEmpty());
    EXPECT_THAT(messages(policy + policy + component("a", "ns::Plant", port)), ElementsAre(HasSubstr("DEP021")));
    EXPECT_THAT(messages(policy), ElementsAre(HasSubstr("DEP018")));
}

}  // namespace
