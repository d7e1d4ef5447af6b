// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <deployment/validate.hpp>
#include <deployment/xml_to_plan.hpp>

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

namespace {

using namespace OCL::deploy;
using oroforge::diag::Sink;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PlanContext context() {
    PlanContext result;
    result.deployer = "Deployer";
    result.components = {"Existing"};
    result.componentTypes = {"ns::Controller", "ns::Plant"};
    return result;
}

Plan planOf(const std::string& elements) {
    Sink sink;
    const Plan plan = readPlanText("<properties>" + elements + "</properties>", "test.xml", sink);
    EXPECT_FALSE(sink.hadErrors());
    return plan;
}

std::vector<std::string> messages(const std::string& elements, const PlanContext& around = context()) {
    Sink validation;
    validate(planOf(elements), around, validation);
    std::vector<std::string> result;
    for (const auto& diagnostic : validation.sorted())
        result.push_back((diagnostic.severity == oroforge::diag::Severity::Warning ? "warning: " : "") +
                         diagnostic.code + " " + diagnostic.message);
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

TEST(Validate, MastersInACircleHaveNoThread) {
    EXPECT_THAT(messages(component("a", "ns::Plant", master("b")) + component("b", "ns::Plant", master("a")) +
                         component("c", "ns::Plant", master("a"))),
                ElementsAre("DEP017 component 'a' is, through its masters, its own master",
                            "DEP017 component 'b' is, through its masters, its own master"));
}

TEST(Validate, AServiceThatNobodyHasIsToldWhereTheComponentIsNotSeen) {
    const std::string asks =
        component("a", "ns::Plant", "<simple name='Service' type='string'><value>marshaling</value></simple>");
    PlanContext around = context();
    around.services = {"marshalling"};
    EXPECT_THAT(messages(asks, around), IsEmpty());
    around.planOnly = true;
    EXPECT_THAT(messages(asks, around),
                ElementsAre("warning: DEP033 no plugin has a service 'marshaling' for component "
                            "'a'; did you mean 'marshalling'?"));
}

TEST(Validate, UnknownTypeIsAnsweredWithTheNearest) {
    EXPECT_THAT(messages(component("c", "ns::Controler")),
                ElementsAre("DEP031 unknown component type 'ns::Controler'; did you mean 'ns::Controller'?"));
}

TEST(Validate, SecondStructOfAComponentAddsOptions) {
    EXPECT_THAT(
        messages(component("c", "ns::Plant") + component("c", "ns::Plant")),
        ElementsAre("warning: DEP009 a second struct for component 'c', which adds to the options of the first"));
    EXPECT_THAT(messages(component("c", "ns::Plant") + component("c", "PropertyBag")), IsEmpty());
}

TEST(Validate, SecondStructOfAComponentHasNoOtherType) {
    EXPECT_THAT(messages(component("c", "ns::Plant") + component("c", "PropertyBag") +
                         component("c", "ns::Controller") + component("c", "ns::Nothing")),
                ElementsAre("DEP009 a second component of the name 'c', of type 'ns::Controller'",
                            "DEP009 a second component of the name 'c', of type 'ns::Nothing'"));
}

TEST(Validate, OptionsBeforeTheirComponentAreTheOnlyError) {
    EXPECT_THAT(messages(component("c", "PropertyBag") + component("c", "ns::Plant")),
                ElementsAre("DEP031 there is no component 'c' to add options to"));
}

TEST(Validate, FileThatIsIncludedTwiceIsToldOnce) {
    oroforge::test::TempDir directory;
    directory.write("common.xml", "<properties>" + component("c", "ns::Plant") + component("d", "ns::Plant") +
                                      "<struct name='wire' type='ConnPolicy'><simple name='init' type='boolean'>"
                                      "<value>1</value></simple></struct></properties>");
    const std::string common = (directory / "common.xml").string();
    const std::string include = "<simple name='Include' type='string'><value>" + common + "</value></simple>";
    const std::string port =
        "<struct name='Ports' type='PropertyBag'><simple name='p' type='string'><value>wire</value></simple></struct>";
    EXPECT_THAT(
        messages(include + include + component("e", "ns::Plant", port)),
        ElementsAre("warning: DEP009 component 'c' is there already: '" + common + "' is included more than once"));
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

TEST(Validate, PolicyIsUsedAndASecondReplacesIt) {
    const std::string policy =
        "<struct name='wire' type='ConnPolicy'><simple name='type' type='short'><value>0</value></simple></struct>";
    const std::string port =
        "<struct name='Ports' type='PropertyBag'><simple name='p' type='string'><value>wire</value></simple></struct>";
    EXPECT_THAT(messages(policy + component("a", "ns::Plant", port)), IsEmpty());
    EXPECT_THAT(messages(policy + policy + component("a", "ns::Plant", port)),
                ElementsAre("warning: DEP021 a second policy for connection 'wire', which replaces the first"));
    EXPECT_THAT(messages(policy), ElementsAre(HasSubstr("DEP018")));
}

// --- what descriptions tell -----------------------------------------------------------------------------------------

using RTT::internal::ComponentDescription;
using RTT::internal::DescribedPort;
using RTT::internal::DescribedProperty;

const DescribedPort kPorts[] = {
    {"command", &typeid(int), false}, {"state", &typeid(int), true}, {"arm.force", &typeid(double), true}};
const DescribedProperty kProperties[] = {{"gain", &typeid(double)}, {"arm.limit", &typeid(double)}};
const ComponentDescription kPlant{"ns::Plant", "plants", kPorts, kProperties, false};
const ComponentDescription kDynamic{"ns::Dynamic", "plants", kPorts, kProperties, true};

/** ns::Plant and ns::Dynamic are described, ns::Controller is not. */
PlanContext described(bool planOnly) {
    PlanContext result = context();
    result.componentTypes.push_back("ns::Dynamic");
    result.descriptions = {{"ns::Plant", &kPlant}, {"ns::Dynamic", &kDynamic}};
    result.services = {"scripting"};
    result.planOnly = planOnly;
    return result;
}

std::vector<std::string> dry(const std::string& elements) { return messages(elements, described(true)); }
std::vector<std::string> real(const std::string& elements) { return messages(elements, described(false)); }

std::string port(const std::string& name, const std::string& connection = "wire") {
    return "<struct name='Ports' type='PropertyBag'><simple name='" + name + "' type='string'><value>" + connection +
           "</value></simple></struct>";
}

std::string property(const std::string& name) {
    return "<struct name='Properties' type='PropertyBag'><simple name='" + name +
           "' type='double'><value>1</value></simple></struct>";
}

TEST(ValidateDescribed, UnknownNamesAreErrorsOfADryRunOnly) {
    const std::string plan = component("a", "ns::Plant", port("sttae") + property("gian"));
    EXPECT_THAT(dry(plan), ElementsAre("DEP040 component 'a' has no port 'sttae'; did you mean 'state'?",
                                       "DEP043 component 'a' has no property 'gian'; did you mean 'gain'?"));
    EXPECT_THAT(real(plan), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Plant", port("state"))), IsEmpty());
    // This program has no typekit.
    EXPECT_THAT(dry(component("a", "ns::Plant", port("state") + property("gain"))),
                ElementsAre("DEP065 component 'a': no loaded typekit has the type 'double' of property 'gain'"));
}

TEST(ValidateDescribed, NotesTellWhereTheKnowledgeComesFrom) {
    Sink sink;
    validate(planOf(component("a", "ns::Plant", port("x"))), described(true), sink);
    ASSERT_EQ(sink.sorted().size(), 1u);
    const auto notes = sink.sorted()[0].notes;
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_EQ(notes[0].message, "the manifest of package 'plants' lists the ports: 'command', 'state', 'arm.force'");
    EXPECT_EQ(notes[0].where.column, 36u);
    EXPECT_EQ(notes[1].message,
              "if the class adds ports by itself, say dynamic=\"true\" for the component in that manifest");
}

TEST(ValidateDescribed, WhatMayComeBesidesIsNotMissed) {
    const std::string unknown = port("x") + property("y");
    const std::string service = "<simple name='Service' type='string'><value>scripting</value></simple>";
    EXPECT_THAT(dry(component("a", "ns::Dynamic", unknown)), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Controller", unknown)), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Plant", service + unknown)), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Plant", unknown) + component("a", "PropertyBag", service)), IsEmpty());
    EXPECT_THAT(dry(component("Existing", "ns::Plant", unknown)), IsEmpty());
    EXPECT_THAT(dry(component("this", "ns::Plant", unknown)), IsEmpty());
}

TEST(ValidateDescribed, ScriptsMayBringPortsButComeAfterTheProperties) {
    oroforge::test::TempDir directory;
    directory.write("a.ops", "");
    const std::string script =
        "<simple name='RunScript' type='string'><value>" + (directory / "a.ops").string() + "</value></simple>";
    EXPECT_THAT(dry(component("a", "ns::Plant", script + port("x") + property("y"))), ElementsAre(HasSubstr("DEP043")));
}

TEST(ValidateDescribed, StructsThatAddOptionsAreChecked) {
    EXPECT_THAT(dry(component("a", "ns::Plant") + component("a", "PropertyBag", port("stat"))),
                ElementsAre("DEP040 component 'a' has no port 'stat'; did you mean 'state'?"));
}

TEST(ValidateDescribed, ServicesHavePortsByPathButNoPropertiesOfTheComponent) {
    EXPECT_THAT(dry(component("a", "ns::Plant", port("arm.force"))), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Plant", port("arm.forec"))),
                ElementsAre("DEP040 component 'a' has no port 'arm.forec'; did you mean 'arm.force'?"));
}

TEST(ValidateDescribed, TypesOfAConnectionDifferInEveryMode) {
    const std::string plan =
        component("a", "ns::Plant", port("command")) + component("b", "ns::Plant", port("arm.force"));
    const auto differs = ElementsAre(AllOf(HasSubstr("DEP041 port 'b.arm.force' of type"),
                                           HasSubstr("cannot take part in connection 'wire' of type")));
    EXPECT_THAT(dry(plan), differs);
    EXPECT_THAT(real(plan), differs);
    // What nobody describes between them does not hide it.
    const std::string unknown = component("c", "ns::Controller", port("any"));
    EXPECT_THAT(real(unknown + plan), differs);
}

TEST(ValidateDescribed, DirectionsAreToldWhereNobodyLooksLater) {
    const std::string inputs =
        component("a", "ns::Plant", port("command")) + component("b", "ns::Plant", port("command"));
    const std::string outputs = component("a", "ns::Plant", port("state")) + component("b", "ns::Plant", port("state"));
    EXPECT_THAT(dry(inputs), ElementsAre("DEP042 no output port takes part in connection 'wire'"));
    EXPECT_THAT(dry(outputs), ElementsAre("warning: DEP042 no input port takes part in connection 'wire'"));
    EXPECT_THAT(real(inputs), IsEmpty());
    EXPECT_THAT(real(outputs), IsEmpty());
    EXPECT_THAT(dry(inputs + component("c", "ns::Controller", port("any"))), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Plant", port("command"))), IsEmpty());
    EXPECT_THAT(dry(component("a", "ns::Plant", port("command")) + component("a", "PropertyBag", port("command"))),
                IsEmpty());
    PlanContext around = described(true);
    around.connections = {"wire"};
    EXPECT_THAT(messages(inputs, around), IsEmpty());
}

TEST(ValidateDescribed, PlansBeforeTakePart) {
    const Plan earlier = planOf(component("a", "ns::Plant", port("state") + port("x")));
    PlanContext around = described(true);
    around.planned = {&earlier};
    EXPECT_THAT(messages(component("b", "ns::Plant", port("arm.force")), around),
                ElementsAre(HasSubstr("DEP041 port 'b.arm.force'")));
    EXPECT_THAT(messages(component("a", "PropertyBag", port("stat", "other")), around),
                ElementsAre(HasSubstr("DEP040 component 'a' has no port 'stat'")));
    EXPECT_THAT(messages(component("b", "ns::Plant", peers("a") + port("command")), around), IsEmpty());
}

TEST(ValidateDescribed, StrictPropertyFilesHaveEveryProperty) {
    oroforge::test::TempDir directory;
    directory.write("a.cpf", "<properties><simple name='gian' type='double'><value>1</value></simple></properties>");
    const auto file = [&](const char* element) {
        return component("a", "ns::Plant",
                         "<simple name='" + std::string(element) + "' type='string'><value>" +
                             (directory / "a.cpf").string() + "</value></simple>");
    };
    EXPECT_THAT(dry(file("PropertyFile")),
                ElementsAre(AllOf(HasSubstr("DEP052 could not set the properties of component 'a'"),
                                  HasSubstr("property 'gain' of type"), HasSubstr("did you mean 'gian'?"))));
    EXPECT_THAT(real(file("PropertyFile")), IsEmpty());
    EXPECT_THAT(dry(file("UpdateProperties")), IsEmpty());
    EXPECT_THAT(dry(file("LoadProperties")), IsEmpty());
}

}  // namespace
