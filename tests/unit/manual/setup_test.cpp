// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How each component is set up: threads, services, configuring and starting, ports, peers (sections 2.4.1 to 2.4.4, 2.4.6).
#include "snippets.hpp"

namespace {

using namespace manual_test;
using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Setup : public Snippets {
protected:
    static std::string worker(const std::string& name, const std::string& content = kNothing) {
        return bag(name, "line::Worker", content);
    }
    static std::string on(const std::string& flag) { return simple(flag, "boolean", "1"); }
    static std::string thread(const std::string& type, const std::string& content) {
        return bag("Activity", type, content);
    }
    static std::string numbers(const std::string& period, const std::string& priority, const std::string& scheduler) {
        return simple("Period", "double", period) + simple("Priority", "short", priority) +
               simple("Scheduler", "string", scheduler);
    }
    static std::string port(const std::string& name, const std::string& connection) {
        return bag("Ports", "PropertyBag", simple(name, "string", connection));
    }
};

TEST_F(Setup, ActivitiesOfAllTypes) {
    writeXml("app.xml",
             import("line") +
                 worker("slow", thread("Activity", numbers("0.005", "0", "ORO_SCHED_OTHER")) + on("AutoConf")) +
                 worker("shared", thread("PeriodicActivity", numbers("0.02", "0", "ORO_SCHED_OTHER"))) +
                 worker("woken", thread("Activity", simple("Priority", "short", "0") +
                                                        simple("Scheduler", "string", "ORO_SCHED_OTHER"))) +
                 worker("none", thread("SequentialActivity", "")) +
                 worker("helper", thread("SlaveActivity", simple("Master", "string", "boss"))) +
                 bag("boss", "line::Foreman", thread("Activity", numbers("0.001", "0", "ORO_SCHED_OTHER"))));
    expectAtPrompt({"-s", "app.xml"}, {{"slow.getPeriod()", testing::EndsWith(" = 0.005\n")},
                                       {"shared.getPeriod()", " = 0.02\n"},
                                       {"woken.getPeriod()", " = 0\n"},
                                       {"none.getPeriod()", " = 0\n"},
                                       {"helper.getPeriod()", " = 0.001\n"}});
}

TEST_F(Setup, ThreadsAreMadeInTheStepConfigureComponents) {
    writeXml("app.xml", import("line") + worker("w", thread("Activity", numbers("0.005", "0", "ORO_SCHED_OTHER"))));
    expectAtPrompt({}, {{"loadComponents(\"app.xml\")", kTrue},
                        {"w.getPeriod()", " = 0\n"},
                        {"configureComponents()", kTrue},
                        {"w.getPeriod()", " = 0.005\n"}});
}

TEST_F(Setup, SlavesArePeersOfTheirMasterAndRunWhenItTriggersThem) {
    writeXml("app.xml",
             import("line") +
                 bag("boss", "line::Foreman", thread("Activity", numbers("0.002", "0", "ORO_SCHED_OTHER"))) +
                 worker("helper", thread("SlaveActivity", simple("Master", "string", "boss")) + on("AutoConf")));
    expectAtPrompt({"-s", "app.xml"}, {{"cd boss", testing::_},
                                       {"peers", HasSubstr("helper")},
                                       {"cd", testing::_},
                                       {"helper.start()", HasSubstr(kTrue)},
                                       {"helper.cycles()", " = 0\n"},
                                       {"boss.start()", kTrue},
                                       until("helper.cycles() >= 3"),
                                       {"helper.thread() == boss.thread()", kTrue}});
}

TEST_F(Setup, ServicesAndPluginsAreLoadedAnyNumberOfTimes) {
    writeXml(
        "app.xml",
        import("line") + import(MANUAL_ROBOT "/lib/orocos") +
            worker("w", simple("Service", "string", "scripting") + simple("Plugin", "string", "armservice") +
                            simple("Service", "string", "marshalling") + simple("Plugin", "string", "armservice")));
    expectAtPrompt({"-s", "app.xml"},
                   {{"w.armservice.owner()", " = \"w\"\n"},
                    {"w.scripting.eval(\"speed = 4.0\")", kTrue},
                    {"w.marshalling.writeProperties(\"w.cpf\")", kTrue},
                    {"w.speed", " = 4\n"},
                    {".services", AllOf(HasSubstr("armservice"), HasSubstr("scripting"), HasSubstr("marshalling"))},
                    {".plugins", AllOf(HasSubstr("armservice"), HasSubstr("scripting"))}});
}

TEST_F(Setup, ServicesAreLoadedFromThePromptIntoTheVisitedComponentOrByName) {
    expectAtPrompt({}, {{"import(\"line\")", kTrue},
                        {"loadComponent(\"Reporter\", \"OCL::FileReporting\")", kTrue},
                        {"loadComponent(\"w\", \"line::Worker\")", kTrue},
                        {"loadService(\"Reporter\", \"scripting\")", kTrue},
                        {"Reporter.scripting.eval(\"ReportFile = \\\"x.dat\\\"\")", kTrue},
                        {"Reporter.ReportFile", " = \"x.dat\"\n"},
                        {"cd w", testing::_},
                        {".provide marshalling", testing::_},
                        {"marshalling.writeProperties(\"w.cpf\")", kTrue}});
    const Outcome stranger = atPrompt({}, {{"loadService(\"Nobody\", \"scripting\")", kFalse}});
    EXPECT_THAT(stranger.err, HasSubstr("no component 'Nobody'"));
}

TEST_F(Setup, NothingIsConfiguredOrStartedUnlessTheFileSaysSo) {
    writeXml("app.xml", import("line") + worker("idle") + worker("configured", on("AutoConf")) +
                            worker("running", on("AutoConf") + on("AutoStart")) +
                            worker("off", simple("AutoConf", "boolean", "0") + simple("AutoStart", "boolean", "0")));
    expectAtPrompt({"-s", "app.xml"}, {{"idle.isConfigured()", testing::EndsWith(kFalse)},
                                       {"configured.isConfigured() && !configured.isRunning()", kTrue},
                                       {"running.isRunning()", kTrue},
                                       {"off.isConfigured()", kFalse},
                                       {"idle.configure()", "idle: configured with speed 1, label ''\n" + kTrue},
                                       {"idle.start()", "idle: started after 0 cycles\n" + kTrue}});
}

TEST_F(Setup, PortsOfOneConnectionAreConnectedAndOthersAreNot) {
    writeXml("app.xml",
             import("line") + bag("Flow", "ConnPolicy", simple("type", "short", "1") + simple("size", "short", "12")) +
                 bag("from", "line::Source", port("parts", "Flow")) + bag("to", "line::Sink", port("parts", "Flow")) +
                 bag("also", "line::Sink", port("parts", "Flow")) + bag("alone", "line::Sink", ""));
    std::vector<Typed> session = {{"var int i = 0", " = 0\n"},
                                  {"while i < 20 { i = i + 1; from.put(1.0) }", kNothing},
                                  {"to.waiting()", " = 12\n"},
                                  {"also.waiting()", " = 12\n"},
                                  {"alone.waiting()", " = 0\n"}};
    expectAtPrompt({"-s", "app.xml"}, session);
    // Without a policy: the newest sample.
    writeXml("app.xml", import("line") + bag("from", "line::Source", port("parts", "Flow")) +
                            bag("to", "line::Sink", port("parts", "Flow")));
    expectAtPrompt({"-s", "app.xml"}, {session[0], session[1], {"to.waiting()", " = 1\n"}});
}

TEST_F(Setup, PortsOfOneConnectionMustHaveOneType) {
    writeXml("app.xml", import("line") + bag("from", "line::Source", port("waste", "Flow")) +
                            bag("to", "line::Sink", port("waste", "Flow")));
    const Outcome outcome = rttscript({"-s", "app.xml"});
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("app.xml:"), HasSubstr("int"), HasSubstr("string")));
}

TEST_F(Setup, AutoConnectNeedsBothFlagsAndAPeer) {
    const auto application = [this](const std::string& ofSource, const std::string& ofSink) {
        writeXml("app.xml", import("line") + bag("from", "line::Source", ofSource) + bag("to", "line::Sink", ofSink));
    };
    const std::vector<Typed> put = {{"from.put(1.0)", kVoid}};
    const auto arrives = [&](const std::string& number) {
        const Outcome outcome = atPrompt({"-s", "app.xml"}, {put[0], {"to.waiting()", " = " + number + "\n"}});
        EXPECT_EQ(0, outcome.status) << outcome.err;
        return outcome.err;
    };
    application(on("AutoConnect"), on("AutoConnect"));
    EXPECT_EQ("", arrives("0")) << "no peers";
    application(on("AutoConnect") + peer("to"), kNothing);
    EXPECT_EQ("", arrives("0")) << "one flag";
    application(on("AutoConnect"), on("AutoConnect") + peer("from"));
    const std::string log = arrives("1");
    EXPECT_THAT(log, HasSubstr("AutoConnect: not all ports of the same name")) << "the other pair has two types";
    EXPECT_THAT(log, Not(HasSubstr(" error: [")));
}

TEST_F(Setup, APortMayBeConnectedByBothWays) {
    writeXml("app.xml",
             import("line") + bag("from", "line::Source", port("parts", "Flow") + on("AutoConnect") + peer("to")) +
                 bag("to", "line::Sink", on("AutoConnect")) + bag("also", "line::Sink", port("parts", "Flow")));
    atPrompt({"-s", "app.xml"}, {{"from.put(1.0)", kVoid}, {"to.waiting() + also.waiting()", " = 2\n"}});
}

TEST_F(Setup, ScriptsConnectPortsWithAPolicyThatIsUsedAgain) {
    directory_.write("app.ops",
                     "import(\"line\")\n"
                     "loadComponent(\"Plant\", \"line::Source\")\n"
                     "loadComponent(\"Controller\", \"line::Sink\")\n"
                     "loadComponent(\"Display\", \"line::Sink\")\n"
                     "var ConnPolicy cp\n"
                     "cp.type = BUFFER\n"
                     "cp.size = 10 // buffer of size 10\n"
                     "connect(\"Plant.parts\", \"Controller.parts\", cp )\n"
                     "cp.size = 3\n"
                     "connect(\"Plant.parts\", \"Display.parts\", cp )\n");
    expectAtPrompt({"-s", "app.ops"}, {{"var int i = 0", " = 0\n"},
                                       {"while i < 20 { i = i + 1; Plant.put(1.0) }", kNothing},
                                       {"Controller.waiting()", " = 10\n"},
                                       {"Display.waiting()", " = 3\n"}});
}

TEST_F(Setup, StreamsTakeAPortAndAPolicy) {
    const Outcome outcome =
        atPrompt({}, {{"import(\"line\")", kTrue},
                      {"loadComponent(\"Plant\", \"line::Source\")", kTrue},
                      {"var ConnPolicy cp", AllOf(HasSubstr("{type = 0,"), HasSubstr("lock_policy = 2"))},
                      {"cp.transport = 77", testing::_},
                      {"stream(\"Plant.parts\", cp)", kFalse},
                      {"stream(\"Plant.prats\", cp)", kFalse}});
    EXPECT_THAT(outcome.err, HasSubstr("77"));
    EXPECT_THAT(outcome.err, HasSubstr("did you mean 'parts'?"));
}

TEST_F(Setup, PeersAreKnownByTheirName) {
    writeXml("app.xml",
             import("line") + worker("Controller") + bag("Reporter", "OCL::FileReporting", peer("Controller")));
    expectAtPrompt({"-s", "app.xml"},
                   {{"cd Reporter", testing::_},
                    {"peers", HasSubstr("Controller")},
                    {"cd Controller", testing::_},
                    {"peers", Not(HasSubstr("Reporter"))},
                    {"cd", testing::_},
                    {"Reporter.reportData(\"Controller\", \"speed\")", kTrue},
                    {"Reporter.reportComponent(\"Controller\")", kTrue},
                    {"loadService(\"Reporter\", \"scripting\")", kTrue},
                    {"Reporter.scripting.eval(\"Controller.configure()\")", StartsWith("Controller: configured")}});
}

}  // namespace
