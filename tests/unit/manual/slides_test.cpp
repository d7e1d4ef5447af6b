// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component code, the script and the prompt of the introduction.
#include "snippets.hpp"

namespace {

using namespace manual_test;
using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;

class Slides : public Snippets {
protected:
    static Typed load(const std::string& name, const std::string& type) {
        return {"loadComponent(\"" + name + "\", \"slides::" + type + "\")", kTrue};
    }
    const Typed package_ = {"import(\"slides\")", kTrue};
};

TEST_F(Slides, AComponentStartsFromItsPropertyAndIsSetInItsOwnThread) {
    expectAtPrompt({}, {package_,
                        load("c", "MyComp"),
                        {"setActivity(\"c\", 0.002, 0, ORO_SCHED_OTHER)", kTrue},
                        {"c.init_value = -1", testing::_},
                        {"c.start()", kFalse},
                        {"c.init_value = 100", testing::_},
                        {"c.start()", kTrue},
                        until("c.counter >= 105"),
                        {"c.setCounter(5000)", kVoid},
                        {"c.counter >= 5000", kTrue},
                        {"c.stop()", kTrue},
                        {"c.counter", " = 100\n"}});
}

TEST_F(Slides, EventPortsOfAVectorCallBackWithTheirNumber) {
    std::vector<Typed> session = {package_,
                                  load("e", "Encoders"),
                                  {"setActivity(\"e\", 0.002, 0, ORO_SCHED_OTHER)", kTrue},
                                  {"e.configure()", kTrue},
                                  {"e.start()", kTrue}};
    for (const std::string number : {"1", "2", "3"}) {
        const std::string source = "source" + number;
        session.push_back(load(source, "MyComp"));
        session.push_back(
            {"connect(\"" + source + ".outport_counter\", \"e.encoder_" + number + "\", ConnPolicy())", kTrue});
    }
    for (const std::string number : {"1", "2", "3"}) {
        session.push_back({"e.complete", " = 0\n"});
        session.push_back({"source" + number + ".start()", kTrue});
        session.push_back(until("e.last_port == \"encoder_" + number + "\""));
    }
    session.push_back(until("e.complete > 0"));
    session.push_back({"ls e", AllOf(HasSubstr("encoder_1"), HasSubstr("Encoder Value of Motor 3"))});
    expectAtPrompt({}, session);
}

TEST_F(Slides, OperationsOfPeersAreCalledAndSent) {
    expectAtPrompt({}, {package_,
                        load("ATask", "ATask"),
                        load("c", "Caller"),
                        {"addPeer(\"c\", \"ATask\")", kTrue},
                        {"c.start() && ATask.start()", kTrue},
                        {"c.callIt()", kTrue},
                        {"ATask.resets", " = 2\n"},
                        {"c.sendIt()", kTrue},
                        {"ATask.resets", " = 4\n"}});
}

TEST_F(Slides, LinesOfTheLogNameTheComponent) {
    const Outcome outcome = atPrompt({"--log-level", "error"}, {package_, load("c", "Caller"), {"c.fail()", kVoid}});
    EXPECT_THAT(outcome.err, HasSubstr("[c]  failed, ....\n"));
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("[c]  failed, ....\n"));
}

TEST_F(Slides, AScriptDeploysAndThePromptIsThereAfterIt) {
    directory_.write("myscript.ops",
                     "//this is a comment !\n"
                     "import(\"slides\")\n"
                     "loadComponent(\"producer\", \"slides::MyComp\")\n"
                     "loadComponent(\"consumer\", \"slides::Encoders\")\n"
                     "\n"
                     "setActivity(\"producer\", 0.01, 98, ORO_SCHED_RT)\n"
                     "setActivity(\"consumer\", 0, 97, ORO_SCHED_RT)\n"
                     "\n"
                     "// connect ports\n"
                     "var ConnPolicy cp // non-buffered connection\n"
                     "connect(\"producer.outport_counter\", \"consumer.encoder_1\", cp)\n"
                     "// configure the components\n"
                     "producer: configure()\n"
                     "consumer: configure()\n"
                     "// start components\n"
                     "consumer: start()\n"
                     "producer: start()\n");
    atPrompt({"-s", "myscript.ops"},
             {until("consumer.last_port == \"encoder_1\""), {"producer.isRunning() && consumer.isRunning()", kTrue}});
}

TEST_F(Slides, CommandsOfThePrompt) {
    expectAtPrompt({}, {package_,
                        load("c", "MyComp"),
                        {"help", HasSubstr("cd ")},
                        {"help loadComponent", HasSubstr("Creates a component")},
                        {"ls", HasSubstr("loadComponent")},
                        {".types", HasSubstr("ConnPolicy")},
                        {".services", HasSubstr("scripting")},
                        {"cd c", testing::_},
                        {"ls", HasSubstr("outport_counter")},
                        {"leave", testing::_},
                        {"enter", testing::_},
                        {"var int name", " = 0\n"},
                        {"name = 3", testing::_},
                        {"setCounter(name)", kVoid},
                        {"counter", " = 3\n"},
                        {"var SendHandle handle", testing::_},
                        {"handle = setCounter.send(4);", kNothing},
                        {"handle.collect()", " = SendSuccess\n"},
                        {"counter", " = 4\n"},
                        {"start()", kTrue},
                        {"stop()", kTrue}});
}

}  // namespace
