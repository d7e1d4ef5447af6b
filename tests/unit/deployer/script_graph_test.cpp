// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// --dot of scripts: the graph after they ran; of those that are only looked through, what can be known.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

const std::string kTwo =
    "import(\"deploytest\")\n"
    "loadComponent(\"producer\", \"deploytest::Producer\")\n"
    "loadComponent(\"consumer\", \"deploytest::Consumer\")\n";

class ScriptGraph : public deployer_test::DeployerInDirectory {
protected:
    /** The graph of such a script with such options. */
    std::string graphOf(const std::string& script, const std::vector<std::string>& options) {
        directory_.write("app.ops", script);
        std::vector<std::string> words = {"--dot", "app.dot", "-s", "app.ops"};
        words.insert(words.begin(), options.begin(), options.end());
        const Outcome outcome = run(command(words));
        EXPECT_EQ(0, outcome.status) << outcome.err;
        return readFile(directory_ / "app.dot");
    }
};

TEST_F(ScriptGraph, OfAScriptThatRanIsThatOfTheRealComponents) {
    const std::string graph =
        graphOf(kTwo +
                    "var ConnPolicy policy\npolicy.type = BUFFER\npolicy.size = 7\n"
                    "var string to = \"consumer.numbers\"\n"
                    "connect(\"producer.numbers\", to, policy)\naddPeer(\"consumer\", \"producer\")\n",
                {});
    EXPECT_EQ(
        "digraph \"Deployer\" {\n  rankdir=LR;\n  node [shape=box];\n"
        "  \"consumer\" [label=\"consumer\\ndeploytest::Consumer\"];\n"
        "  \"producer\" [label=\"producer\\ndeploytest::Producer\"];\n"
        "  \"consumer\" -> \"producer\" [style=dashed, label=\"peer\"];\n"
        "  \"producer\" -> \"consumer\" [label=\"numbers → numbers\\nint, buffer 7\"];\n"
        "}\n",
        graph);
}

TEST_F(ScriptGraph, OfAScriptThatIsLookedThroughShowsWhatItNames) {
    for (const char* option : {"--dry-run", "--check"}) {
        const std::string graph =
            graphOf(kTwo +
                        "connect(\"consumer.numbers\", \"producer.numbers\", ConnPolicy())\n"
                        "addPeer(\"consumer\", \"producer\")\nstream(\"consumer.text\", ConnPolicy())\n",
                    {option});
        EXPECT_EQ(
            "digraph \"Deployer\" {\n  rankdir=LR;\n  node [shape=box];\n"
            "  \"consumer\" [label=\"consumer\\ndeploytest::Consumer\"];\n"
            "  \"producer\" [label=\"producer\\ndeploytest::Producer\"];\n"
            "  \"consumer\" -> \"producer\" [style=dashed, label=\"peer\"];\n"
            "  \"producer\" -> \"consumer\" [label=\"numbers → numbers\\nint\"];\n"
            "  \"stream consumer.text\" [shape=ellipse, label=\"stream\"];\n"
            "  \"stream consumer.text\" -> \"consumer\" [label=\"text\"];\n"
            "}\n",
            graph)
            << option;
    }
}

TEST_F(ScriptGraph, PortsOfTheSameNameAreFoundAndScriptsOfScripts) {
    directory_.write("more.ops", "connectPorts(\"producer\", \"consumer\")\n");
    EXPECT_THAT(graphOf(kTwo + "runScript(\"more.ops\")\n", {"--dry-run"}),
                HasSubstr("\"producer\" -> \"consumer\" [label=\"numbers → numbers\\nint\"];\n"));
    EXPECT_THAT(
        graphOf(kTwo + "connectTwoPorts(\"producer\", \"numbers\", \"consumer\", \"numbers\")\n", {"--dry-run"}),
        HasSubstr("\"producer\" -> \"consumer\" [label=\"numbers → numbers\\nint\"];\n"));
}

TEST_F(ScriptGraph, WhatMayHappenIsDottedAndWhatIsComputedIsLeftOutWithANote) {
    const std::string graph =
        graphOf(kTwo +
                    "var string name = \"third\"\n"
                    "if name == \"third\" then {\n  loadComponent(\"fourth\", \"deploytest::Consumer\")\n"
                    "  connect(\"producer.numbers\", \"fourth.numbers\", ConnPolicy())\n}\n"
                    "loadComponent(name, \"deploytest::Consumer\")\n"
                    "connect(\"producer.numbers\", name + \".numbers\", ConnPolicy())\n",
                {"--dry-run"});
    EXPECT_THAT(graph, HasSubstr("  \"fourth\" [style=dotted, label=\"fourth\\ndeploytest::Consumer\"];\n"));
    EXPECT_THAT(graph, HasSubstr("  \"producer\" -> \"fourth\" [style=dotted, label=\"numbers → numbers\\nint\"];\n"));
    EXPECT_THAT(graph, HasSubstr("  \"left out\" [shape=note, label=\"left out, with names that scripts compute:\\n"
                                 "loadComponent() in app.ops:9\\nconnect() in app.ops:10\"];\n"));
    EXPECT_THAT(graph, Not(HasSubstr("\"third\"")));
}

TEST_F(ScriptGraph, OfAnXmlFileAndAScriptIsOne) {
    directory_.write("app.xml",
                     "<properties><simple name=\"Import\" type=\"string\"><value>deploytest</value></simple>\n"
                     "<struct name=\"producer\" type=\"deploytest::Producer\"/></properties>\n");
    directory_.write("app.ops",
                     "loadComponent(\"consumer\", \"deploytest::Consumer\")\n"
                     "connect(\"producer.numbers\", \"consumer.numbers\", ConnPolicy())\n"
                     "connectPeers(\"producer\", \"consumer\")\n");
    const Outcome outcome = run(command({"--dry-run", "--dot", "app.dot", "app.xml", "app.ops"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    const std::string graph = readFile(directory_ / "app.dot");
    EXPECT_THAT(graph, HasSubstr("  \"producer\" [label=\"producer\\ndeploytest::Producer\"];\n"));
    EXPECT_THAT(graph, HasSubstr("  \"producer\" -> \"consumer\" [label=\"numbers → numbers\\nint\"];\n"))
        << "the input shows the direction";
    EXPECT_THAT(graph, HasSubstr("  \"producer\" -> \"consumer\" [style=dashed, label=\"peer\"];\n"));
    EXPECT_THAT(graph, HasSubstr("  \"consumer\" -> \"producer\" [style=dashed, label=\"peer\"];\n"));
}

}  // namespace
