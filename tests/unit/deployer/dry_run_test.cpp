// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the program tells of files without running what they describe: --dry-run and --dot.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

const char* const kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n"
    "<properties>\n";
const char* const kImport = "<simple name=\"Import\" type=\"string\"><value>deploytest</value></simple>\n";

std::string component(const std::string& name, const std::string& type, const std::string& content = "") {
    return "<struct name=\"" + name + "\" type=\"" + type + "\">" + content + "</struct>\n";
}

std::string port(const std::string& name) {
    return "<struct name=\"Ports\" type=\"PropertyBag\"><simple name=\"" + name +
           "\" type=\"string\"><value>wire</value></simple></struct>";
}

std::string peer(const std::string& name) {
    return "<struct name=\"Peers\" type=\"PropertyBag\"><simple type=\"string\"><value>" + name +
           "</value></simple></struct>";
}

class DryRun : public deployer_test::DeployerInDirectory {
protected:
    void write(const std::string& file, const std::string& content) {
        directory_.write(file, kHead + content + "</properties>\n");
    }
};

TEST_F(DryRun, CreatesNothing) {
    write("app.xml", kImport + component("one", "deploytest::Consumer"));
    const Outcome outcome = run(command({"--dry-run", "-linfo", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("created component")));
}

TEST_F(DryRun, LaterFilesMayReferToComponentsOfEarlierOnes) {
    write("first.xml", kImport + component("one", "deploytest::Consumer"));
    write("second.xml", component("two", "deploytest::Consumer", peer("one")));
    EXPECT_EQ(0, run(command({"--dry-run", "-s", "first.xml", "-s", "second.xml"})).status);
    const Outcome alone = run(command({"--dry-run", "-s", "second.xml"}));
    EXPECT_EQ(255, alone.status);
    EXPECT_THAT(alone.err, HasSubstr("peer 'one' of component 'two' does not exist"));
}

TEST_F(DryRun, TheErrorsOfAllFilesAreToldAtOnce) {
    write("first.xml", kImport + component("one", "deploytest::Consumr"));
    write("second.xml", component("two", "deploytest::Producer", peer("on")));
    directory_.write("third.ops", "two.start(\n");
    directory_.write("bad.cpf",
                     "<properties>\n<simple name=\"a\" type=\"double\"><value>much</value></simple>\n</properties>\n");
    write("fourth.xml", component("four", "deploytest::Consumer",
                                  "<simple name=\"PropertyFile\" type=\"string\"><value>bad.cpf</value></simple>"));
    const Outcome outcome =
        run(command({"--dry-run", "-s", "first.xml", "-s", "second.xml", "third.ops", "-s", "fourth.xml"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("first.xml:5:26: error: [DEP031] unknown component type 'deploytest::Consumr'"));
    EXPECT_THAT(outcome.err, HasSubstr("did you mean 'one'?"));
    EXPECT_THAT(outcome.err, HasSubstr("third.ops:1:"));
    EXPECT_THAT(outcome.err, HasSubstr("bad.cpf:2:"));
}

TEST_F(DryRun, TheSiteFileIsOnlyPlanned) {
    write("site.xml", kImport + component("one", "deploytest::Consumer"));
    const Outcome outcome = run(command({"--dry-run", "-linfo", "--site-file", "site.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("created component")));
}

TEST_F(DryRun, TheGraphOfAPlanHasConnectionsWithoutDirection) {
    write("app.xml", kImport + component("producer", "deploytest::Producer", port("numbers") + peer("consumer")) +
                         component("consumer", "deploytest::Consumer", port("numbers")));
    const Outcome outcome = run(command({"--dry-run", "--dot", "app.dot", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ(
        "digraph \"Deployer\" {\n"
        "  rankdir=LR;\n"
        "  node [shape=box];\n"
        "  \"producer\" [label=\"producer\\ndeploytest::Producer\"];\n"
        "  \"producer\" -> \"connection wire\" [dir=none, label=\"numbers\"];\n"
        "  \"producer\" -> \"consumer\" [style=dashed, label=\"peer\"];\n"
        "  \"consumer\" [label=\"consumer\\ndeploytest::Consumer\"];\n"
        "  \"consumer\" -> \"connection wire\" [dir=none, label=\"numbers\"];\n"
        "  \"connection wire\" [shape=ellipse, label=\"wire\"];\n"
        "}\n",
        readFile(directory_ / "app.dot"));
}

TEST_F(DryRun, ComponentInSeveralStructsIsOneInTheGraph) {
    write("app.xml", kImport + component("one", "deploytest::Producer", port("numbers") + peer("two")) +
                         component("one", "deploytest::Producer", port("numbers") + peer("two")) +
                         component("one", "PropertyBag", port("numbers")) +
                         component("two", "deploytest::Consumer", port("numbers")));
    const std::string told = "app.xml:6:15: warning: [DEP009] a second struct for component 'one'";
    const Outcome planned = run(command({"--dry-run", "--dot", "plan.dot", "-s", "app.xml"}));
    EXPECT_EQ(0, planned.status) << planned.err;
    EXPECT_THAT(planned.err, HasSubstr(told));
    EXPECT_EQ(
        "digraph \"Deployer\" {\n  rankdir=LR;\n  node [shape=box];\n"
        "  \"one\" [label=\"one\\ndeploytest::Producer\"];\n"
        "  \"one\" -> \"connection wire\" [dir=none, label=\"numbers\"];\n"
        "  \"one\" -> \"two\" [style=dashed, label=\"peer\"];\n"
        "  \"two\" [label=\"two\\ndeploytest::Consumer\"];\n"
        "  \"two\" -> \"connection wire\" [dir=none, label=\"numbers\"];\n"
        "  \"connection wire\" [shape=ellipse, label=\"wire\"];\n}\n",
        readFile(directory_ / "plan.dot"));
    const Outcome checked = run(command({"--check", "--dot", "live.dot", "-s", "app.xml"}));
    EXPECT_EQ(0, checked.status) << checked.err;
    EXPECT_THAT(checked.err, HasSubstr(told));
    EXPECT_THAT(readFile(directory_ / "live.dot"), HasSubstr("\"one\" [label=\"one\\ndeploytest::Producer\"]"));
}

TEST_F(DryRun, TheGraphOfComponentsShowsWhatIsConnectedHow) {
    write("app.xml",
          std::string(kImport) +
              "<struct name=\"wire\" type=\"ConnPolicy\"><simple name=\"type\" type=\"short\"><value>1</value></simple>"
              "<simple name=\"size\" type=\"short\"><value>100</value></simple></struct>\n" +
              component("producer", "deploytest::Producer", port("numbers") + peer("consumer")) +
              component("consumer", "deploytest::Consumer", port("numbers")));
    const Outcome outcome = run(command({"--check", "--dot", "app.dot", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    const std::string graph = readFile(directory_ / "app.dot");
    EXPECT_THAT(graph, HasSubstr("  \"producer\" -> \"consumer\" [label=\"numbers → numbers\\nint, buffer 100\"];\n"));
    EXPECT_THAT(graph, HasSubstr("  \"producer\" -> \"consumer\" [style=dashed, label=\"peer\"];\n"));
    const Outcome refused = run(command({"--check", "--dot", "no/such/app.dot", "-s", "app.xml"}));
    EXPECT_EQ(255, refused.status);
    EXPECT_THAT(refused.err,
                HasSubstr("no/such/app.dot: error: the graph cannot be written: No such file or directory"));
}

TEST_F(DryRun, TheGraphDrawsAPeerAsTheComponentItIs) {
    directory_.write("alias.ops", "aliasPeer(\"one\", \"two\", \"other\")\naliasPeer(\"this\", \"two\", \"again\")\n");
    write("app.xml", std::string(kImport) + component("one", "deploytest::Consumer", "") +
                         component("two", "deploytest::Consumer", "") +
                         "<struct name=\"this\" type=\"PropertyBag\"><simple name=\"RunScript\" type=\"string\">"
                         "<value>alias.ops</value></simple></struct>");
    const Outcome outcome = run(command({"--check", "--dot", "app.dot", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    const std::string graph = readFile(directory_ / "app.dot");
    EXPECT_THAT(graph, HasSubstr("  \"one\" -> \"two\" [style=dashed, label=\"peer other\"];\n"));
    EXPECT_THAT(graph, Not(HasSubstr("\"other\"")));
    const std::string node = "[label=\"two\\ndeploytest::Consumer\"]";
    EXPECT_THAT(graph, HasSubstr(node));
    EXPECT_EQ(graph.find(node), graph.rfind(node)) << "one node, whatever names it has: " << graph;
}

TEST_F(DryRun, ALibraryFileStandsForItsOnlyComponentType) {
    const auto library = [](const std::string& name) {
        return std::string(DEPLOYER_TEST_PATH) + "/" OROCOS_TARGET_WORD "/" + name + "/lib" + name +
               "-" OROCOS_TARGET_WORD ".so";
    };
    write("app.xml", component("one", library("deploysingle")));
    const Outcome single = run(command({"--check", "-linfo", "-s", "app.xml"}));
    EXPECT_EQ(0, single.status) << single.err;
    EXPECT_THAT(single.err, HasSubstr("created component 'one' of type deploysingle::Single"));
    directory_.write("app.ops", "loadComponent(\"one\", \"" + library("deploysingle") + "\")\none.configure()\n");
    EXPECT_EQ(0, run(command({"--log-level", "info", "-s", "app.ops", "--check"})).status);

    write("several.xml", component("one", library("deploytest")));
    const Outcome several = run(command({"--dry-run", "-s", "several.xml"}));
    EXPECT_EQ(255, several.status);
    EXPECT_THAT(several.err, HasSubstr("several.xml:4:26: error: [DEP031] library '" + library("deploytest")));
    EXPECT_THAT(several.err, HasSubstr("component types, name one of them: deploytest::"));
    EXPECT_THAT(several.err, Not(HasSubstr("unknown component type")));
}

}  // namespace
