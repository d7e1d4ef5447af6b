// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations as objects: created by name, copied, local ones, those of an object, their signals.
#include <rtt/TaskContext.hpp>

#include <gtest/gtest.h>

#include <algorithm>

using namespace RTT;
using namespace RTT::detail;

namespace {

int twice(int x) { return 2 * x; }
int thrice(int x) { return 3 * x; }

class Arm {
public:
    explicit Arm(int at) : position(at) {}
    int move(int by) { return position += by; }
    int where() const { return position; }
    int position;
};
typedef boost::shared_ptr<Arm> ArmPtr;

class Server : public TaskContext {
public:
    Operation<int(int)> own{"own", &Server::addsUp, this, OwnThread};
    Server() : TaskContext("server") {
        addOperation("twice", &twice).doc("Doubles.").arg("x", "a number");
        addOperation(own);
    }
    int addsUp(int x) {
        executed_by_itself = engine()->isSelf();
        return sum += x;
    }
    int sum = 0;
    bool executed_by_itself = false;
};

}  // namespace

TEST(OperationMembers, CreateGivesAGenericCallerOfTheNamedOperation) {
    Server server;
    TaskContext client("client");
    int result = 0;
    OperationCallerC caller = server.provides()->create("twice", client.engine()).argC(4).ret(result);
    ASSERT_TRUE(caller.ready());
    EXPECT_TRUE(caller.call());
    EXPECT_EQ(8, result);
    caller = server.operations()->create("own", client.engine()).argC(5).ret(result);
    EXPECT_TRUE(caller.call());
    EXPECT_EQ(5, result);
    EXPECT_TRUE(server.executed_by_itself) << "an OwnThread operation stays with its component";
    EXPECT_FALSE(server.provides()->create("missing", client.engine()).ready());
}

TEST(OperationMembers, AnOperationIsReadyWithAnOwnerAndAFunctionOnly) {
    Server server;
    Operation<int(int)> unbound("unbound"), bound("bound", &twice);
    EXPECT_FALSE(unbound.ready());
    EXPECT_FALSE(bound.ready()) << "no component provides it";
    server.addOperation(bound);
    EXPECT_TRUE(bound.ready());
    EXPECT_TRUE((Operation<int(int)>("owned", &twice, OwnThread, server.engine()).ready()));
    server.addOperation(unbound);
    EXPECT_FALSE(unbound.ready());
    EXPECT_FALSE(server.provides()->hasOperation("unbound"));
    EXPECT_TRUE(server.own.ready());
}

TEST(OperationMembers, AnOperationIsAssignedAndCopied) {
    Server server;
    Operation<int(int)> operation("empty");
    operation = Operation<int(int)>("triple", &thrice).doc("Triples.").arg("x", "a number");
    EXPECT_EQ("triple", operation.getName());
    EXPECT_EQ("Triples.", operation.getDescriptions().front());
    server.addOperation(operation);
    OperationCaller<int(int)> caller = server.getOperation("triple");
    EXPECT_EQ(9, caller(3));

    Operation<int(int)> copy = operation;
    copy.calls(&twice);
    EXPECT_EQ(9, OperationCaller<int(int)>(server.getOperation("triple"))(3)) << "a copy is another operation";
    operation = copy;
    EXPECT_EQ(9, OperationCaller<int(int)>(server.getOperation("triple"))(3)) << "what was added stays";
    server.provides()->addOperation(operation);
    EXPECT_EQ(6, OperationCaller<int(int)>(server.getOperation("triple"))(3));
}

TEST(OperationMembers, ALocalOperationIsForCallersInThisProcessOnly) {
    Server server;
    Service& service = *server.provides();
    Operation<int(int)> local("local", &twice), unbound("unbound"), nameless("", &twice);
    ASSERT_TRUE(service.addLocalOperation(local));
    EXPECT_TRUE(service.addLocalOperation(local)) << "it is there already";
    EXPECT_FALSE(service.addLocalOperation(unbound));
    EXPECT_FALSE(service.addLocalOperation(nameless));
    EXPECT_TRUE(local.ready());

    OperationCaller<int(int)> caller = service.getLocalOperation("local");
    ASSERT_TRUE(caller.ready());
    EXPECT_EQ(10, caller(5));
    EXPECT_EQ(10, (OperationCaller<int(int)>("local", server.provides())(5)));
    EXPECT_TRUE(service.hasOperation("local"));
    EXPECT_FALSE(service.hasMember("local"));
    EXPECT_EQ(nullptr, service.getPart("local"));
    const std::vector<std::string> names = service.getOperationNames();
    EXPECT_EQ(1, std::count(names.begin(), names.end(), "local"));

    Server client;
    OperationCaller<int(int)> wanted("local");
    client.requires("arm")->addOperationCaller(wanted);
    EXPECT_TRUE(client.requires("arm")->connectTo(server.provides()));
    EXPECT_EQ(10, wanted(5));

    Operation<int(int)> other("other", &thrice);
    EXPECT_TRUE(service.resetOperation("local", &other));
    EXPECT_EQ(15, OperationCaller<int(int)>(service.getLocalOperation("local"))(5));
    service.removeOperation("local");
    EXPECT_FALSE(service.hasOperation("local"));
    EXPECT_EQ(nullptr, service.getLocalOperation("local"));
}

TEST(OperationMembers, AnOperationOfAnObjectTakesItAsFirstArgumentInCppAndFromItsSourceElsewhere) {
    Server server;
    const ArmPtr left(new Arm(1)), right(new Arm(100));
    ValueDataSource<ArmPtr>::shared_ptr source(new ValueDataSource<ArmPtr>(left));
    Service& service = *server.provides();

    Operation<int(ArmPtr, int)> move("move", [](ArmPtr arm, int by) { return arm->move(by); });
    service.addOperationDS(source, move).doc("Moves an arm.").arg("by", "so much");
    Operation<int(Arm*)> where("where", [](Arm* arm) { return arm->where(); });
    service.addOperationDS(source.get(), where);
    OperationCaller<int(ArmPtr, int)> moves = server.getOperation("move");
    EXPECT_EQ(102, moves(right, 2));
    EXPECT_EQ(102, OperationCaller<int(Arm*)>(server.getOperation("where"))(right.get()));
    EXPECT_EQ(102, OperationCaller<int(Arm*)>(service.getLocalOperation("where"))(right.get()));

    ASSERT_EQ(1u, server.getOperation("move")->arity());
    EXPECT_EQ("by", server.getOperation("move")->getArgumentList()[0].name);
    int result = 0;
    EXPECT_TRUE(service.create("move", server.engine()).argC(10).ret(result).call());
    EXPECT_EQ(11, result);
    source->set(right);
    EXPECT_EQ(102, OperationCaller<int()>(server.getOperation("where"))());
    source->set(nullptr);
    EXPECT_THROW(OperationCaller<int()>(server.getOperation("where"))(), std::runtime_error);
}

TEST(OperationMembers, AMemberFunctionOfASourceTakesAnObjectInCpp) {
    Server server;
    const ArmPtr left(new Arm(1)), right(new Arm(100));
    ValueDataSource<ArmPtr>::shared_ptr source(new ValueDataSource<ArmPtr>(left));
    server.provides()->addOperationDS("move", &Arm::move, source).arg("by", "so much");
    server.provides()->addOperationDS("where", &Arm::where, source.get());
    OperationInterfacePart* const move = server.getOperation("move");
    EXPECT_EQ(3, OperationCaller<int(int)>(move)(2));
    EXPECT_EQ(102, OperationCaller<int(ArmPtr, int)>(move)(right, 2));
    EXPECT_EQ(105, OperationCaller<int(Arm*, int)>(move)(right.get(), 3));
    EXPECT_EQ(3, OperationCaller<int()>(server.getOperation("where"))());
    EXPECT_EQ(105, OperationCaller<int(ArmPtr)>(server.getOperation("where"))(right));
    EXPECT_THROW(OperationCaller<int(ArmPtr)>(server.getOperation("where"))(nullptr), std::runtime_error);
}

TEST(OperationMembers, TheSignalOfAnOperationConnectsHandlers) {
    Server server;
    EXPECT_FALSE(server.own.signal);
    int direct = 0, pointed = 0;
    Handle first = server.own.signal.connect([&](int x) { direct += x; });
    Handle second = server.own.signal->connect([&](int x) { pointed += x; });
    EXPECT_TRUE(server.own.signal);
    EXPECT_TRUE(first.connected() && second.connected());
    TaskContext client("client");
    OperationCaller<int(int)> caller(server.getOperation("own"), client.engine());
    EXPECT_EQ(3, caller(3));
    EXPECT_EQ(3, direct);
    EXPECT_EQ(3, pointed);
    EXPECT_TRUE(first.disconnect());
    server.own.signal->emit(4);
    (*server.own.signal)(5);
    EXPECT_EQ(3, direct);
    EXPECT_EQ(12, pointed);
    EXPECT_EQ(3, server.sum) << "emitting calls the listeners only";
}
