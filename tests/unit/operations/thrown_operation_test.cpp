// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What an operation that throws does to its component: nothing if C++ called it directly, Exception if data sources did.
#include "probe.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/OperationCallerC.hpp>

#include <stdexcept>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

struct ThrownOperation : testing::Test {
    typedef base::DataSourceBase::shared_ptr Source;

    ThrownOperation() {
        server.addOperation("bad", &ThrownOperation::bad, this);
        server.provides("arm")->addOperation("bad", &ThrownOperation::bad, this);
        server.addOperation(
            "badHere", [this](int n) { return bad(n); }, OwnThread);
    }
    int bad(int n) {
        if (n > 0) throw std::runtime_error("planted");
        return n;
    }
    static Source one() { return new ConstantDataSource<int>(1); }
    static std::string thrownBy(const std::function<void()>& action) {
        try {
            action();
        } catch (const std::exception& thrown) {
            return thrown.what();
        }
        return "no exception";
    }

    Probe server{"server"};
    ExecutionEngine* const global = GlobalEngine::Instance();
};

TEST_F(ThrownOperation, CalledByADataSourcePutsItsComponentIntoException) {
    const Source call = server.getOperation("bad")->produce({one()}, global);
    EXPECT_EQ(thrownBy([&] { call->evaluate(); }), "planted");
    EXPECT_TRUE(server.inException());
    EXPECT_EQ(server.takeHooks(), "exception");
    EXPECT_EQ(thrownBy([&] { DataSource<int>::narrow(call.get())->get(); }), "planted");
    EXPECT_EQ(server.takeHooks(), "") << "it is in that state already";
}

TEST_F(ThrownOperation, OfAServicePutsTheComponentOfThatIntoException) {
    const Source call = server.provides("arm")->getOperation("bad")->produce({one()}, global);
    EXPECT_EQ(thrownBy([&] { call->evaluate(); }), "planted");
    EXPECT_TRUE(server.inException());
}

TEST_F(ThrownOperation, CalledByAGenericCallerPutsItsComponentIntoException) {
    OperationCallerC call(server.getOperation("bad"), "bad", global);
    call.argC(1);
    call.check();
    EXPECT_EQ(thrownBy([&] { call.call(); }), "planted");
    EXPECT_TRUE(server.inException());
}

TEST_F(ThrownOperation, SentByDataSourcesPutsItsComponentIntoException) {
    OperationInterfacePart& part = *server.getOperation("bad");
    const Source handle = part.produceHandle(), send = part.produceSend({one()}, global);
    ASSERT_TRUE(handle->update(send.get()));
    const Source collect = part.produceCollect({handle}, new ConstantDataSource<bool>(true));
    EXPECT_NE(thrownBy([&] { collect->evaluate(); }), "no exception");
    EXPECT_TRUE(server.inException()) << "before the caller knows";
}

TEST_F(ThrownOperation, SentByAGenericCallerPutsItsComponentIntoException) {
    OperationCallerC call(server.getOperation("bad"), "bad", global);
    call.argC(1);
    call.check();
    SendHandleC handle = call.send();
    EXPECT_TRUE(eventually([&] { return server.inException(); }));
    thrownBy([&] { handle.collect(); });
}

TEST_F(ThrownOperation, CalledOrSentDirectlyOnlyThrows) {
    OperationCaller<int(int)> bad(server.getOperation("bad"), global);
    EXPECT_EQ(thrownBy([&] { bad(1); }), "planted");
    EXPECT_NE(thrownBy([&] { bad.send(1).collect(); }), "no exception");
    EXPECT_FALSE(server.inException());
    EXPECT_EQ(server.takeHooks(), "");
}

TEST_F(ThrownOperation, ThatDoesNotThrowChangesNothing) {
    const Source call = server.getOperation("bad")->produce({new ConstantDataSource<int>(0)}, global);
    EXPECT_TRUE(call->evaluate());
    EXPECT_FALSE(server.inException());
}

TEST_F(ThrownOperation, OfTheThreadOfItsComponentCalledInThatPutsItIntoException) {
    oroforge::test::makeManual(server);
    const Source call = server.getOperation("badHere")->produce({one()}, server.engine());
    std::string thrown;
    server.onUpdate = [&] { thrown = thrownBy([&] { call->evaluate(); }); };
    ASSERT_TRUE(server.start());
    ASSERT_TRUE(server.update());
    EXPECT_EQ(thrown, "planted");
    EXPECT_TRUE(server.inException());
}

TEST_F(ThrownOperation, CalledTwiceWhileItsComponentIsBusyEntersExceptionOnce) {
    std::atomic<bool> inside{false}, leave{false};
    server.onUpdate = [&] {
        inside = true;
        EXPECT_TRUE(eventually([&] { return leave.load(); }));
    };
    ASSERT_TRUE(server.start());
    ASSERT_TRUE(server.trigger());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    const Source call = server.getOperation("bad")->produce({one()}, global);
    for (int i = 0; i != 2; ++i) EXPECT_EQ(thrownBy([&] { call->evaluate(); }), "planted");
    leave = true;
    ASSERT_TRUE(eventually([&] { return server.inException(); }));
    usleep(20000);
    EXPECT_EQ(server.takeHooks(), "start stop exception");
}

TEST_F(ThrownOperation, ThatIsRefusedLeavesItsComponentAsItIs) {
    const Source call = server.getOperation("badHere")->produce({one()}, global);
    server.getActivity()->stop();
    server.fatal();
    EXPECT_NE(thrownBy([&] { call->evaluate(); }), "no exception");
    EXPECT_TRUE(server.inFatalError());
}

TEST_F(ThrownOperation, OfNoComponentOnlyThrows) {
    GlobalService::Instance()->addOperation("badForAll", &ThrownOperation::bad, this);
    const Source call = GlobalService::Instance()->getOperation("badForAll")->produce({one()}, server.engine());
    EXPECT_EQ(thrownBy([&] { call->evaluate(); }), "planted");
    EXPECT_FALSE(server.inException());
    GlobalService::Instance()->remove("badForAll");
}

}  // namespace
