// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations and services, as components use them.
#include <rtt/RTT.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

double cube(double x) { return x * x * x; }

class Server : public TaskContext {
public:
    Operation<int(int, int)> add;
    boost::function<bool(std::string)> known;
    std::string last;

    Server()
        : TaskContext("server"),
          add("add", &Server::addImpl, this, OwnThread),
          known(boost::bind(&Server::is, this, _1)) {
        this->addOperation(add).doc("Adds.").arg("a", "first").arg("b", "second");
        addOperation("cube", &cube).doc("The third power.").arg("x", "");
        addOperation("isKnown", known);
        addOperation("half", [](double x) { return x / 2; });
        addOperation("bound", boost::function<double(double)>(boost::bind(&cube, _1)), OwnThread);
        addOperation("say", &Server::say, this, OwnThread);
        addOperation("split", &Server::split, this, OwnThread);
        addOperation("five", &Server::five, this, ClientThread);
        provides("math")->addOperation("cube", &cube).doc("Also here.");
        provides("math")->provides("deep")->addOperation("five", &Server::five, this);
    }
    int addImpl(int a, int b) { return a + b; }
    bool is(std::string name) { return name == "known"; }
    void say(const std::string& text) { last = text; }
    bool split(double x, int& whole, double& rest) {
        whole = int(x);
        rest = x - whole;
        return x >= 0;
    }
    double five(double a, double b, double c, double d, double e) const { return a + b + c + d + e; }
};

class Client : public TaskContext {
public:
    OperationCaller<int(int, int)> add;
    OperationCaller<void(const std::string&)> say;
    Client() : TaskContext("client"), add("add"), say("say", this->engine()) {
        this->requires_("server")->addOperationCaller(add);
        this->requires_("server")->addOperationCaller(say);
    }
};

}  // namespace

TEST(UserCode, CallsOperations) {
    Server server;
    Client client;
    client.addPeer(&server);
    OperationCaller<double(double)> cubed = client.getPeer("server")->getOperation("cube");
    ASSERT_TRUE(cubed.ready());
    EXPECT_EQ(cubed(2.0), 8.0);
    EXPECT_EQ(cubed.call(3.0), 27.0);
    OperationCaller<bool(std::string)> known(server.getOperation("isKnown"), client.engine());
    EXPECT_TRUE(known("known"));
    OperationCaller<double(double)> half("half");
    half = server.provides();
    EXPECT_EQ(half(5.0), 2.5);
    OperationCaller<double(double)> bound("bound", server.provides(), client.engine());
    EXPECT_EQ(bound(2.0), 8.0);
    OperationCaller<double(double, double, double, double, double)> five;
    EXPECT_FALSE(five.ready());
    five = server.provides("math")->provides("deep")->getOperation("five");
    EXPECT_EQ(five(1, 2, 3, 4, 5), 15.0);
    ServicePtr math = server.provides("math");
    ServiceRequesterPtr required = client.requires_("server");
    EXPECT_TRUE(math->hasOperation("cube") && !required->ready());
    EXPECT_TRUE(server.provides()->getLocalOperation("cube"));
    OperationCaller<double(double)> local(server.provides()->getLocalOperation("cube"), client.engine());
    EXPECT_EQ(local(2.0), 8.0);
    if (!OperationCaller<double(double)>(server.getOperation("nothing")).ready()) SUCCEED();
    EXPECT_TRUE(server.operations()->hasOperation("add"));
    cubed.disconnect();
    EXPECT_FALSE(cubed.ready());
}

TEST(UserCode, SendsOperations) {
    Server server;
    Client client;
    OperationCaller<int(int, int)> add(server.getOperation("add"), client.engine());
    SendHandle<int(int, int)> handle = add.send(2, 3);
    int sum = 0;
    EXPECT_EQ(handle.collect(sum), SendSuccess);
    EXPECT_EQ(sum, 5);
    EXPECT_EQ(handle.ret(), 5);
    EXPECT_NE(handle.collectIfDone(), SendNotReady);
    OperationCaller<bool(double, int&, double&)> split(server.getOperation("split"), client.engine());
    int whole = 0;
    double rest = 0.0;
    EXPECT_TRUE(split(2.5, whole, rest));
    EXPECT_EQ(whole, 2);
    EXPECT_EQ(rest, 0.5);
    SendHandle<bool(double, int&, double&)> later = split.send(-1.5, whole, rest);
    bool positive = true;
    EXPECT_EQ(later.collect(positive, whole, rest), SendSuccess);
    EXPECT_FALSE(positive);
    EXPECT_EQ(rest, -0.5);
    SendHandle<int(int, int)> nothing;
    EXPECT_EQ(nothing.collectIfDone(), SendFailure);
}

TEST(UserCode, RequiresOperations) {
    Server server;
    Client client;
    EXPECT_FALSE(client.requires_("server")->ready());
    EXPECT_TRUE(client.requires_("server")->connectTo(server.provides()));
    EXPECT_TRUE(client.requires_()->requires_("server")->ready());
    EXPECT_EQ(client.add(1, 2), 3);
    client.say("hello");
    EXPECT_EQ(server.last, "hello");
#if __cplusplus < 202002L
    EXPECT_EQ(client.requires("server")->getOperationCallerNames().size(), 2u);
#endif
    EXPECT_EQ(client.requires_("server")->getOperationCaller("add"), &client.add);
}

TEST(UserCode, LooksAtAnOperation) {
    Server server;
    OperationInterfacePart* part = server.provides()->getOperation("split");
    ASSERT_TRUE(part);
    EXPECT_EQ(part->arity(), 3u);
    EXPECT_EQ(part->collectArity(), 3u);
    EXPECT_EQ(part->resultType(), "bool");
    EXPECT_EQ(part->getArgumentType(1)->getTypeName(), "double");
    EXPECT_EQ(part->getCollectType(2)->getTypeName(), "int");
    std::vector<ArgumentDescription> list = server.provides()->getPart("add")->getArgumentList();
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[1].name, "b");
    EXPECT_EQ(list[1].type, "int");
    EXPECT_EQ(server.provides()->getOperation("add")->description(), "Adds.");

    int sum = 0;
    internal::OperationCallerC call(server.provides()->getPart("add"), "add", internal::GlobalEngine::Instance());
    call.argC(4).argC(5).ret(sum);
    call.check();
    ASSERT_TRUE(call.ready());
    EXPECT_TRUE(call.call());
    EXPECT_EQ(sum, 9);
    internal::SendHandleC handle = call.send();
    int collected = 0;
    handle.arg(collected);
    EXPECT_EQ(handle.collect(), SendSuccess);
    EXPECT_EQ(collected, 9);
    EXPECT_TRUE(call.getSendDataSource());
}

TEST(UserCode, ListensToAnOperation) {
    Server server;
    int heard = 0;
    Operation<void(int)> event("event");
    server.addEventOperation(event).doc("Something happened.");
    RTT::Handle handle = event.signals([&heard](int x) { heard += x; });
    OperationCaller<void(int)> raise = server.getOperation("event");
    raise(2);
    handle.disconnect();
    raise(3);
    EXPECT_EQ(heard, 2);
}
