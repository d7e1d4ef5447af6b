// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operation by which another process loads a library into this one.
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/detail/end_point.hpp>

#include "peer_fixture.hpp"

#include <stdexcept>
#include <string>

using namespace RTT;

namespace {

class CorbaLoadPlugin : public corba_test::PeerFixture {
protected:
    typedef OperationCaller<bool(const std::string&)> Load;
    bool hasLibrary() {
        return OperationCaller<bool(const std::string&)>(peer->getOperation("loadService"))("counting");
    }
};

class CorbaLoadPluginFromOutside : public CorbaLoadPlugin {
protected:
    void prepare(oroforge::test::Command& command) override { command.environment["ORBendPoint"] = "giop:tcp::"; }
};

}  // namespace

TEST_F(CorbaLoadPlugin, EveryServiceLoadsLibraries) {
    for (const Service::shared_ptr& service :
         {peer->provides(), peer->provides("sub"), peer->provides("sub")->provides("deep")}) {
        SCOPED_TRACE(service->getName());
        OperationInterfacePart* const part = service->getOperation("loadPlugin");
        ASSERT_TRUE(part);
        EXPECT_EQ(part->resultType(), "bool");
        ASSERT_EQ(part->arity(), 1U);
        EXPECT_EQ(part->getArgumentList()[0].name, "plugin_path");
        EXPECT_EQ(part->getArgumentType(1)->getTypeName(), "string");
        EXPECT_FALSE(Load(part)("/no/plugins/liblibrary.so"));
    }
    EXPECT_FALSE(hasLibrary());
    EXPECT_TRUE(Load(peer->provides("sub")->getOperation("loadPlugin"))(LIBRARY));
    EXPECT_TRUE(hasLibrary());
    bool loaded = false;
    Load load(peer->getOperation("loadPlugin"));
    auto sent = load.send(LIBRARY);
    EXPECT_EQ(sent.collect(loaded), SendSuccess);
    EXPECT_TRUE(loaded) << "it is there already";
    EXPECT_EQ(peer->server()->getProvider("this")->getArity("loadPlugin"), 1);
}

TEST_F(CorbaLoadPluginFromOutside, NothingIsLoadedIfOtherComputersCanConnect) {
    Load load(peer->getOperation("loadPlugin"));
    ASSERT_TRUE(load.ready());
    try {
        (void)load(LIBRARY);
        FAIL() << "it is refused";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("other computers can connect"), std::string::npos) << error.what();
    }
    EXPECT_FALSE(hasLibrary());
    child->send(SIGTERM);
    const oroforge::test::Outcome outcome = child->finish();
    EXPECT_NE((outcome.out + outcome.err).find("not loaded"), std::string::npos) << "its process says so, too";
}

TEST(CorbaEndPoints, AreLocalByTheirAddress) {
    for (const char* const local : {"giop:tcp:127.0.0.1:", "giop:tcp:127.0.0.1:4000", "giop:ssl:localhost:1",
                                    "giop:tcp:[::1]:5", "giop:unix:", "giop:unix:/tmp/socket"})
        EXPECT_TRUE(corba::detail::isLocalEndPoint(local)) << local;
    for (const char* const open : {"", "giop:tcp::", "giop:tcp::4000", "giop:tcp:192.168.0.20:", "giop:tcp:[::]:1",
                                   "giop:tcp:127.example.org:1", "giop:tcp:0.0.0.0:", "giop:http:127.0.0.1:"})
        EXPECT_FALSE(corba::detail::isLocalEndPoint(open)) << open;
}
