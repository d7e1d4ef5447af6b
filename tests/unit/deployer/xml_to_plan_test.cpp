// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <deployment/xml_to_plan.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

namespace {

using namespace OCL::deploy;
using oroforge::diag::Sink;
using oroforge::test::TempDir;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> codes(const Sink& sink) {
    std::vector<std::string> result;
    for (const auto& diagnostic : sink.sorted()) result.push_back(diagnostic.code);
    return result;
}

/** The plan of the elements, which must be flawless. */
Plan plan(const std::string& elements) {
    Sink sink;
    Plan result = readPlanText("<properties>" + elements + "</properties>", "test.xml", sink);
    EXPECT_THAT(codes(sink), IsEmpty());
    return result;
}

/** What is said about the elements. */
std::vector<std::string> codesOf(const std::string& elements) {
    Sink sink;
    (void)readPlanText("<properties>" + elements + "</properties>", "test.xml", sink);
    return codes(sink);
}

std::string simple(const std::string& name, const std::string& type, const std::string& value) {
    return "<simple name=\"" + name + "\" type=\"" + type + "\"><value>" + value + "</value></simple>\n";
}

std::string component(const std::string& content) { return "<struct name=\"c\" type=\"T\">" + content + "</struct>\n"; }

std::string activity(const std::string& type, const std::string& content) {
    return component("<struct name=\"Activity\" type=\"" + type + "\">" + content + "</struct>");
}

ActivityPlan activityPlan(const std::string& type, const std::string& content) {
    return plan(activity(type, content)).components.at(0).activity.value();
}

TEST(XmlToPlan, StatementsKeepTheirOrder) {
    const Plan p = plan(simple("Path", "string", "/p") + simple("Import", "string", "a") +
                        simple("LoadLibrary", "string", "l.so"));
    ASSERT_EQ(3u, p.imports.size());
    EXPECT_EQ(ImportPlan::Path, p.imports[0].kind);
    EXPECT_EQ(ImportPlan::Import, p.imports[1].kind);
    EXPECT_EQ("a", p.imports[1].what.value);
    EXPECT_EQ(ImportPlan::LoadLibrary, p.imports[2].kind);
}

TEST(XmlToPlan, ComponentHoldsAllItsElements) {
    const Plan p = plan(component(
        simple("AutoConf", "boolean", "1") + simple("AutoStart", "boolean", "false") +
        simple("Service", "string", "s1") + simple("Plugin", "string", "s2") + simple("PropertyFile", "string", "f1") +
        simple("UpdateProperties", "string", "f2") + simple("LoadProperties", "string", "f3") +
        simple("RunScript", "string", "x.ops") + "<struct name='Ports' type='PropertyBag'>" +
        simple("in", "string", "conn") + "</struct>" +
        "<struct name='Peers' type='PropertyBag'><simple type='string'><value>other</value></simple></struct>" +
        "<struct name='Properties' type='PropertyBag'>" + simple("K", "double", "1") + "</struct>"));
    const ComponentPlan& c = p.components.at(0);
    EXPECT_EQ("c", c.name.value);
    EXPECT_EQ("T", c.type.value);
    EXPECT_EQ(true, c.autoConf.value());
    EXPECT_EQ(false, c.autoStart.value());
    EXPECT_FALSE(c.autoConnect.has_value());
    EXPECT_EQ(2u, c.services.size());
    ASSERT_EQ(3u, c.propertyFiles.size());
    EXPECT_EQ(PropertyFilePlan::Update, c.propertyFiles[1].mode);
    EXPECT_EQ("conn", c.ports.at(0).connection.value);
    EXPECT_EQ("other", c.peers.at(0).value);
    EXPECT_EQ("K", c.properties.at(0).children.at(0).attributeOr("name", ""));
    EXPECT_EQ(ScriptPlan::Run, c.scripts.at(0).kind);
}

TEST(XmlToPlan, PlacesPointIntoTheFile) {
    Sink sink;
    const Plan p =
        readPlanText("<properties>\n  <struct name=\"c\"\n          type=\"T\"/>\n</properties>", "test.xml", sink);
    EXPECT_EQ("test.xml", p.components.at(0).type.where.file);
    EXPECT_EQ(2u, p.components.at(0).name.where.line);
    EXPECT_EQ(3u, p.components.at(0).type.where.line);
    EXPECT_EQ(17u, p.components.at(0).type.where.column);
}

TEST(XmlToPlan, PolicyIsToldByTypeOrByItsMembers) {
    const Plan p = plan("<struct name='a' type='ConnPolicy'>" + simple("type", "short", "1") +
                        simple("size", "short", "12") + "</struct>" + "<struct name='b' type='PropertyBag'>" +
                        simple("init", "boolean", "1") + simple("name_id", "string", "/t") + "</struct>");
    ASSERT_EQ(2u, p.policies.size());
    EXPECT_EQ(RTT::ConnPolicy::BUFFER, p.policies[0].policy.type);
    EXPECT_EQ(12, p.policies[0].policy.size);
    EXPECT_EQ(RTT::ConnPolicy::LOCK_FREE, p.policies[0].policy.lock_policy);
    EXPECT_TRUE(p.policies[1].policy.init);
    EXPECT_EQ("/t", p.policies[1].policy.name_id);
    EXPECT_THAT(p.components, IsEmpty());
}

TEST(XmlToPlan, PolicyIsChecked) {
    const auto policy = [](const std::string& content) {
        return codesOf("<struct name='a' type='ConnPolicy'>" + content + "</struct>");
    };
    EXPECT_THAT(policy(simple("type", "short", "7")), ElementsAre("DEP005"));
    EXPECT_THAT(policy(simple("typ", "short", "1")), ElementsAre("DEP010"));
    EXPECT_THAT(policy(simple("type", "short", "1")), ElementsAre("DEP011"));
    EXPECT_THAT(policy(simple("type", "short", "1") + simple("transport", "short", "2")), IsEmpty());
    EXPECT_THAT(policy(simple("init", "short", "1")), ElementsAre("DEP004"));
    EXPECT_THAT(policy(""), ElementsAre("DEP011"));
}

TEST(XmlToPlan, ActivityWithPeriodOnlyIsNotRealTime) {
    const ActivityPlan a = activityPlan("Activity", simple("Period", "double", "0.01"));
    EXPECT_EQ(0.01, a.period.value());
    EXPECT_FALSE(a.priority.has_value());
    EXPECT_FALSE(a.realTime);
}

TEST(XmlToPlan, ActivityWithPriorityIsRealTimeUnlessTheSchedulerSaysOtherwise) {
    EXPECT_TRUE(activityPlan("Activity", simple("Priority", "short", "5")).realTime);
    EXPECT_FALSE(
        activityPlan("Activity", simple("Scheduler", "string", "ORO_SCHED_OTHER") + simple("Priority", "short", "5"))
            .realTime);
    EXPECT_FALSE(
        activityPlan("Activity", simple("Priority", "short", "5") + simple("Scheduler", "string", "ORO_SCHED_OTHER"))
            .realTime);
}

TEST(XmlToPlan, ActivityTypesHaveTheirNeeds) {
    const std::string priority = simple("Priority", "short", "5");
    const std::string period = simple("Period", "double", "0.1");
    EXPECT_THAT(codesOf(activity("Activity", "")), ElementsAre("DEP013"));
    EXPECT_THAT(codesOf(activity("NonPeriodicActivity", "")), ElementsAre("DEP013"));
    EXPECT_THAT(codesOf(activity("NonPeriodicActivity", priority + period)), ElementsAre("DEP013"));
    EXPECT_THAT(codesOf(activity("PeriodicActivity", period)), ElementsAre("DEP013"));
    EXPECT_THAT(codesOf(activity("PeriodicActivity", priority)), ElementsAre("DEP013"));
    EXPECT_THAT(codesOf(activity("PeriodicActivity", priority + period)), IsEmpty());
    EXPECT_THAT(codesOf(activity("SlaveActivity", simple("Master", "string", "m"))), IsEmpty());
    EXPECT_THAT(codesOf(activity("SequentialActivity", "")), IsEmpty());
    EXPECT_THAT(codesOf(activity("FileDescriptorActivity", "")), ElementsAre("DEP013"));
    EXPECT_THAT(codesOf(activity("FileDescriptorActivity", priority + period)), IsEmpty());
    EXPECT_THAT(codesOf(activity("Acitvity", period)), ElementsAre("DEP012"));
    EXPECT_THAT(codesOf(activity("Activity", period + simple("Scheduler", "string", "FIFO"))), ElementsAre("DEP015"));
    EXPECT_THAT(codesOf(activity("Activity", period + simple("Prio", "short", "5"))), ElementsAre("DEP014"));
    EXPECT_THAT(codesOf(activity("Activity", simple("Period", "double", "-1"))), ElementsAre("DEP005"));
}

TEST(XmlToPlan, ActivityTypeInANamespaceIsAnsweredWithTheOneOutOfIt) {
    Sink sink;
    (void)readPlanText("<properties>" + activity("RTT::Activity", simple("Period", "double", "1")) + "</properties>",
                       "test.xml", sink);
    EXPECT_EQ("unknown activity type 'RTT::Activity'; did you mean 'Activity'?", sink.sorted().at(0).message);
}

TEST(XmlToPlan, ValuesAreCheckedByType) {
    EXPECT_THAT(codesOf(component(simple("AutoConf", "string", "1"))), ElementsAre("DEP004"));
    EXPECT_THAT(codesOf(component(simple("AutoConf", "boolean", "yes"))), ElementsAre("DEP005"));
    EXPECT_THAT(codesOf(component("<simple name='AutoConf' type='boolean'/>")), ElementsAre("DEP003"));
    EXPECT_THAT(codesOf(component("<simple name='AutoConf'><value>1</value></simple>")), ElementsAre("XML010"));
    EXPECT_THAT(codesOf(component("<simple name='Ports' type='string'><value>x</value></simple>")),
                ElementsAre("DEP004"));
    EXPECT_THAT(codesOf(activity("Activity", simple("Priority", "short", "high"))), ElementsAre("DEP005"));
    EXPECT_THAT(codesOf(activity("Activity", simple("Period", "double", "0,02"))), ElementsAre("CPF007"));
}

TEST(XmlToPlan, APeriodMayHaveAUnit) {
    const auto period = [](const std::string& type, const std::string& value) {
        Sink sink;
        const auto plan = readPlanText(
            "<properties>" + activity(type, simple("Period", "double", value) + simple("Priority", "short", "0")) +
                "</properties>",
            "test.xml", sink);
        EXPECT_TRUE(sink.empty()) << value;
        return plan.components.at(0).activity->period;
    };
    EXPECT_EQ(0.02, period("Activity", "20ms"));
    EXPECT_EQ(0.02, period("Activity", "0.02 s"));
    EXPECT_EQ(0.00025, period("PeriodicActivity", "250us"));
    EXPECT_EQ(20, period("FileDescriptorActivity", "20"));
    EXPECT_EQ(20, period("FileDescriptorActivity", "20ms"));
    EXPECT_EQ(500, period("FileDescriptorActivity", "0.5s"));
    for (const char* value : {"20m", "20mss", "0,02", "20 hz", "0.5.1"})
        EXPECT_THAT(codesOf(activity("Activity", simple("Period", "double", value))), ElementsAre("CPF007")) << value;
}

TEST(XmlToPlan, EverythingWrongIsReportedInOneRun) {
    EXPECT_THAT(codesOf(simple("Imprt", "string", "a") +
                        component(simple("AutoCon", "boolean", "1") + simple("AutoConf", "boolean", "2")) +
                        "<sequence name='s' type='t'/>"),
                testing::UnorderedElementsAre("DEP002", "DEP006", "DEP005", "DEP002"));
}

TEST(XmlToPlan, RootAndContentAreRequired) {
    EXPECT_THAT(codesOf(""), ElementsAre("DEP008"));
    Sink sink;
    (void)readPlanText("<property/>", "test.xml", sink);
    EXPECT_THAT(codes(sink), ElementsAre("DEP001"));
    Sink malformed;
    (void)readPlanText("<properties>", "test.xml", malformed);
    EXPECT_THAT(codes(malformed), ElementsAre("XML003"));
}

TEST(XmlToPlan, IncludeStandsForTheFileBesideIt) {
    const TempDir dir;
    dir.write("sub/parts.xml", "<properties>" + simple("Import", "string", "parts") + "</properties>");
    const auto main = dir.write(
        "sub/main.xml", "<properties>" + simple("Include", "string", "parts.xml") + component("") + "</properties>");
    Sink sink;
    const Plan p = readPlanFile(main.string(), sink);
    EXPECT_THAT(codes(sink), IsEmpty());
    EXPECT_EQ("parts", p.imports.at(0).what.value);
    EXPECT_EQ(1u, p.components.size());
}

TEST(XmlToPlan, FileHasTheNameByWhichItWasFirstIncluded) {
    const TempDir dir;
    dir.write("sub/parts.xml", "<properties>" + component("") + "</properties>");
    const auto main =
        dir.write("main.xml", "<properties>" + simple("Include", "string", "sub/parts.xml") +
                                  simple("Include", "string", "./sub/../sub/parts.xml") + "</properties>");
    Sink sink;
    const Plan p = readPlanFile(main.string(), sink);
    ASSERT_EQ(2u, p.components.size());
    EXPECT_EQ(p.components[0].name.where, p.components[1].name.where);
}

TEST(XmlToPlan, PlacesInIncludedFilesHaveNoDots) {
    const TempDir dir;
    dir.write("parts.xml", "<properties>" + component("") + "</properties>");
    const auto main =
        dir.write("sub/main.xml", "<properties>" + simple("Include", "string", ".././/parts.xml") + "</properties>");
    Sink sink;
    const Plan p = readPlanFile(main.string(), sink);
    ASSERT_EQ(1u, p.components.size());
    EXPECT_EQ((dir / "parts.xml").string(), p.components[0].name.where.file.str());
}

TEST(XmlToPlan, LinkToAFileInAnotherDirectoryIsAnotherFile) {
    const TempDir dir;
    dir.write("shared.xml", "<properties>" + simple("Include", "string", "part.xml") + "</properties>");
    std::string main = "<properties>";
    for (const std::string side : {"left", "right"}) {
        dir.write(side + "/part.xml", "<properties><struct name='" + side + "' type='T'/></properties>");
        std::filesystem::create_symlink("../shared.xml", dir / (side + "/common.xml"));
        main += simple("Include", "string", side + "/common.xml");
    }
    Sink sink;
    const Plan p = readPlanFile(dir.write("main.xml", main + "</properties>").string(), sink);
    ASSERT_EQ(2u, p.components.size());
    EXPECT_EQ("left", p.components[0].name.value);
    EXPECT_EQ("right", p.components[1].name.value);
}

TEST(XmlToPlan, IncludeOfItselfAndOfNothingIsAnError) {
    const TempDir dir;
    const auto a = dir.write("a.xml", "<properties>" + simple("Include", "string", "b.xml") + "</properties>");
    dir.write("b.xml", "<properties>" + simple("Include", "string", "a.xml") + simple("Include", "string", "none.xml") +
                           "</properties>");
    Sink sink;
    (void)readPlanFile(a.string(), sink);
    EXPECT_THAT(codes(sink), testing::UnorderedElementsAre("DEP007", "DEP020"));
}

}  // namespace
