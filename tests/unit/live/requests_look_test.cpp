// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Looking at a deployment: hello, tree, show, get; and requests that are nonsense.
#include "requests_fixture.hpp"

#include <unistd.h>

namespace live_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(RequestsTest, HelloSaysWhatThisIsAndWhatIsAllowed) {
    rights = {true, false, false, false, false};
    const json hello = result("hello");
    EXPECT_EQ("cell", hello["name"]);
    EXPECT_EQ(getpid(), hello["pid"]);
    EXPECT_EQ("1.2", hello["version"]);
    EXPECT_EQ(json::array({"cell.xml"}), hello["files"]);
    EXPECT_EQ(json::array({"properties"}), hello["allow"]);
    EXPECT_EQ(1764280000000000000, hello["started"].get<std::int64_t>());
    EXPECT_EQ("", hello["log"]);
    const json lines = result("lines", {{"last", 5}});
    EXPECT_EQ("", lines["file"]);
    EXPECT_EQ(json::array(), lines["lines"]);
    EXPECT_THAT(failure("lines", {{"last", -1}}), StartsWith("LIV001"));
    EXPECT_THAT(failure("lines", {{"level", "loud"}}), StartsWith("LIV001"));
    EXPECT_EQ(json::array({"Arm.out"}), result("ports")["outputs"]);
}

TEST_F(RequestsTest, TheTreeHasComponentsAndTheirServices) {
    const json components = result("tree")["components"];
    ASSERT_EQ(2u, components.size());
    EXPECT_EQ("Deployer", components[0]["name"]);
    const json node = components[1];
    EXPECT_EQ("Arm", node["name"]);
    EXPECT_EQ("live_test::Arm", node["type"]);
    EXPECT_EQ("Stopped", node["state"]);
    EXPECT_EQ("gripper", named(node["services"], "gripper").value("name", ""));
    EXPECT_EQ(6, node["counts"]["properties"]);
    EXPECT_EQ(2, node["counts"]["ports"]);
}

TEST_F(RequestsTest, AComponentIsShownWithAllItsParts) {
    arm->out.write(0.5);
    const json shown = result("show", {{"path", "Arm"}});
    EXPECT_EQ("component", shown["kind"]);
    EXPECT_EQ("Stopped", shown["state"]);
    const json gain = named(shown["properties"], "gain");
    EXPECT_EQ("double", gain["type"]);
    EXPECT_EQ(2.5, gain["value"]);
    EXPECT_EQ("2.5", gain["text"]);
    EXPECT_EQ("1/s", gain["unit"]);
    EXPECT_EQ("How strongly it corrects", gain["doc"]);
    EXPECT_EQ(true, gain["writable"]);
    EXPECT_EQ("{p = 1.5, mode = \"slow\"}", named(shown["properties"], "pid")["text"]);
    EXPECT_EQ(1.5, named(shown["properties"], "pid")["value"]["p"]);
    EXPECT_EQ(false, named(shown["attributes"], "limit")["writable"]);
    const json add = named(shown["operations"], "add");
    EXPECT_EQ("double", add["result"]);
    EXPECT_EQ("a", add["arguments"][0]["name"]);
    EXPECT_EQ("own", add["thread"]);
    EXPECT_EQ("client", named(shown["operations"], "addHere")["thread"]);
    EXPECT_EQ("0.5", named(shown["ports"], "out")["text"]);
    EXPECT_EQ("in", named(shown["ports"], "in")["direction"]);
}

TEST_F(RequestsTest, APartIsShownAlone) {
    EXPECT_EQ("property", result("show", {{"path", "Arm.gain"}})["kind"]);
    EXPECT_EQ("operation", result("show", {{"path", "Arm.add"}})["kind"]);
    EXPECT_EQ("port", result("show", {{"path", "Arm.out"}})["kind"]);
    EXPECT_EQ("service", result("show", {{"path", "Arm.gripper"}})["kind"]);
}

TEST_F(RequestsTest, TheLastSampleOfAnInputPortIsShownAndNotTaken) {
    Arm other("Other");
    deployer->addPeer(&other);
    ASSERT_TRUE(arm->out.connectTo(&other.in));
    arm->out.write(3.25);
    EXPECT_EQ("3.25", result("show", {{"path", "Other.in"}})["text"]);
    EXPECT_EQ(3.25, result("get", {{"path", "Other.in"}})["value"]);
    EXPECT_EQ("Arm.out", result("show", {{"path", "Other.in"}})["connections"][0]["port"]);
    double read = 0;
    EXPECT_EQ(RTT::NewData, other.in.read(read));
    EXPECT_EQ(3.25, read);
}

TEST_F(RequestsTest, ValuesAreReadByTheirPath) {
    EXPECT_EQ(2.5, result("get", {{"path", "Arm.gain"}})["value"]);
    EXPECT_EQ(3, result("get", {{"path", "Arm.list[2]"}})["value"]);
    EXPECT_EQ(3, result("get", {{"path", "Arm.list.2"}})["value"]);
    EXPECT_EQ("Arm.list[2]", result("get", {{"path", "Arm.list.2"}})["path"]);
    EXPECT_EQ(1.5, result("get", {{"path", "Arm.pid.p"}})["value"]);
    EXPECT_EQ("\"left\"", result("get", {{"path", "Arm.label"}})["text"]);
    EXPECT_EQ(7, result("get", {{"path", "Arm.gripper.force"}})["value"]);
    EXPECT_EQ(4, result("get", {{"path", "Arm.count"}})["value"]);
}

TEST_F(RequestsTest, AHugeValueIsCut) {
    arm->label.assign(200000, 'x');
    const json got = result("get", {{"path", "Arm.label"}, {"timeout", 10}});
    EXPECT_EQ(true, got["cut"]);
    EXPECT_LE(got["text"].get<std::string>().size(), 65536u);
    EXPECT_THAT(got["text"].get<std::string>(), testing::EndsWith("…"));
    arm->list.assign(1000000, 0.123456789);
    EXPECT_TRUE(result("get", {{"path", "Arm.list"}, {"timeout", 10}})["value"].is_null());
    EXPECT_LE(result("show", {{"path", "Arm"}, {"timeout", 10}}).dump().size(), 100000u);
}

TEST_F(RequestsTest, WhatIsNotUtf8IsStillAnswered) {
    arm->label = "a\xff\xc3";
    const json got = result("get", {{"path", "Arm.label"}});
    EXPECT_NO_THROW(got.dump());
    EXPECT_EQ("\"a\xef\xbf\xbd\xef\xbf\xbd\"", got["text"]);
}

TEST_F(RequestsTest, AnUnknownNameGetsAHint) {
    EXPECT_THAT(failure("get", {{"path", "Arm.gian"}}), HasSubstr("LIV003: there is no property, attribute or port "
                                                                  "'gian' in 'Arm'; did you mean 'gain'?"));
    EXPECT_THAT(failure("show", {{"path", "Amr"}}), HasSubstr("did you mean 'Arm'?"));
    EXPECT_THAT(failure("get", {{"path", "Arm.list[9]"}}), HasSubstr("LIV003: 'Arm.list', of type"));
    EXPECT_THAT(failure("get", {{"path", "Arm.pid.moda"}}), HasSubstr("did you mean 'mode'?"));
    EXPECT_THAT(failure("get", {{"path", "Arm"}}), HasSubstr("LIV003: 'Arm' is a component"));
    EXPECT_THAT(failure("get", {{"path", "Arm.add"}}), HasSubstr("is an operation"));
    EXPECT_THAT(failure("tree", {{"path", "Arm.gripper"}}), HasSubstr("expected a component"));
    EXPECT_THAT(failure("shwo"), HasSubstr("LIV002: there is no verb 'oro.shwo'; did you mean 'show'?"));
}

TEST_F(RequestsTest, NonsenseIsAnsweredWithAnError) {
    const auto code = [this](const json& request) { return ask(request).value("code", "none"); };
    for (const json& request : {json(), json(1), json("get"), json::array({1}), json::object(), json{{"op", 1}},
                                json{{"op", "get"}}, json{{"op", json::array()}}})
        EXPECT_THAT(code(request), testing::AnyOf("LIV001", "LIV002")) << request;
    for (const json& path : {json(), json(1), json(true), json::array({"a"}), json::object({{"a", 1}}), json("a[b]"),
                             json("Arm..gain"), json("Arm.list["), json(std::string(10000, 'a'))})
        EXPECT_EQ("LIV001", code({{"op", "oro.get"}, {"path", path}})) << path;
    for (const json& timeout : {json("1"), json(0), json(-1), json(1e300), json(4000), json()})
        EXPECT_EQ("LIV001", code({{"op", "oro.get"}, {"path", "Arm.gain"}, {"timeout", timeout}})) << timeout;
    json deep = {{"op", "oro.get"}, {"id", 1}};
    deep["path"] = json::parse(std::string(100000, '[') + std::string(100000, ']'));
    std::string refused;
    requests->handle(deep, {"tester", rights}, [&](const json& answer) { refused = answer.value("code", "none"); });
    EXPECT_EQ("LIV001", refused);
    EXPECT_EQ(json(), ask({{"op", "oro.hello"}})["id"]);
}

TEST_F(RequestsTest, EveryFieldOfEveryVerbMayBeNonsense) {
    const std::vector<json> values = {json(),
                                      1,
                                      -1,
                                      1.5e300,
                                      true,
                                      "",
                                      ".",
                                      "..",
                                      "[",
                                      "[]",
                                      "a[1]",
                                      "Arm[0]",
                                      "Arm.gain[0]",
                                      "Arm.list[99999999999999999999]",
                                      "Arm.list[-1]",
                                      "\u0000",
                                      json::array(),
                                      json::array({1, json::object()}),
                                      json::object(),
                                      {{"a", {{"b", {1, 2}}}}},
                                      std::string(70000, 'x'),
                                      std::string(5000, '{'),
                                      std::string(5000, '[')};
    const std::vector<std::pair<const char*, std::vector<const char*>>> verbs = {{"hello", {"path"}},
                                                                                 {"tree", {"path"}},
                                                                                 {"show", {"path", "timeout"}},
                                                                                 {"get", {"path"}},
                                                                                 {"set", {"path", "value", "text"}},
                                                                                 {"call", {"path", "arguments"}},
                                                                                 {"lifecycle", {"component", "do"}},
                                                                                 {"describe", {"type"}},
                                                                                 {"graph", {"path"}},
                                                                                 {"line", {"line"}},
                                                                                 {"complete", {"line"}},
                                                                                 {"interrupt", {"line"}},
                                                                                 {"unknown", {"path"}},
                                                                                 {"", {"path"}}};
    for (const auto& [verb, fields] : verbs)
        for (const char* const field : fields)
            for (const json& value : values) {
                json request = {{"op", std::string("oro.") + verb},
                                {"id", value},
                                {"path", "Arm.gain"},
                                {"do", "start"},
                                {"component", "Arm"},
                                {"type", "double"},
                                {"line", "1"}};
                request[field] = value;
                const json answer = ask(request);
                ASSERT_TRUE(answer.is_object()) << request;
                EXPECT_EQ(value, answer["id"]);
                EXPECT_THAT(answer["op"], testing::AnyOf("oro.answer", "oro.error")) << answer;
            }
}

TEST_F(RequestsTest, AComponentThatIsBusyIsShownWithoutItsValues) {
    auto blocked = std::thread([this] {
        arm->provides()->getOperation("nothing");
        RTT::OperationCaller<void()>(arm->getOperation("block"), deployer->engine()).send();
    });
    blocked.join();
    while (!arm->blocked) std::this_thread::yield();
    const json shown = result("show", {{"path", "Arm"}, {"timeout", 0.2}});
    EXPECT_THAT(shown["missing"].get<std::string>(), HasSubstr("component 'Arm' did not answer within"));
    EXPECT_EQ("double", named(shown["properties"], "gain")["type"]);
    EXPECT_EQ("LIV004: component 'Arm' did not answer within 0.1 s; this will not be done",
              failure("get", {{"path", "Arm.gain"}, {"timeout", 0.1}}));
    arm->release();
    EXPECT_EQ(2.5, result("get", {{"path", "Arm.gain"}})["value"]);
}

}  // namespace
}  // namespace live_test
