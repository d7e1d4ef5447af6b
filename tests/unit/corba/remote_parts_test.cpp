// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What stands for single parts of another process. Here they are in this one, but called by their references.
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/transports/corba/AnyDataSource.hpp>
#include <rtt/transports/corba/CorbaConnPolicy.hpp>
#include <rtt/transports/corba/CorbaOperationCallerFactory.hpp>
#include <rtt/transports/corba/CorbaTemplateProtocol.hpp>
#include <rtt/transports/corba/DataSourceProxy.hpp>
#include <rtt/transports/corba/RemoteChannelElement.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>
#include <rtt/transports/corba/TransportPlugin.hpp>

#include "../transports/transport_fixture.hpp"
#include "../types/builtin_typekit.hpp"

#include <chrono>
#include <string>
#include <thread>

using namespace RTT;

namespace {

using transport_test::soon;

class CorbaParts : public types_test::WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        types_test::WithBuiltinTypes::SetUpTestSuite();
        types::TypekitRepository::Import(new corba::CorbaLibPlugin());
        int argc = 1;
        char name[] = "test";
        char* argv[] = {name, nullptr};
        ASSERT_TRUE(corba::TaskContextServer::InitOrb(argc, argv));
    }
    static void TearDownTestSuite() { corba::TaskContextServer::DestroyOrb(); }

    CorbaParts() {
        component.addProperty("gain", gain);
        component.addAttribute("level", level);
        component.addOperation("add", [](int a, int b) { return a + b; }).doc("Adds.");
        const corba::CTaskContext_var reference = corba::TaskContextServer::CreateServer(&component, false);
        service = reference->getProvider("this");
    }
    ~CorbaParts() override { corba::TaskContextServer::CleanupServer(&component); }

    TaskContext component{"other"};
    double gain = 1.5, level = 0.5;
    corba::CService_var service;
};

/** Two ends of a channel that know each other. */
struct Channel {
    typedef corba::RemoteChannelElement<double> End;
    explicit Channel(const ConnPolicy& policy)
        : writer(newEnd(policy)), reader(newEnd(policy)), before(storage(policy)), behind(storage(policy)) {
        const corba::CRemoteChannelElement_var toWriter = writer->activate_this();
        const corba::CRemoteChannelElement_var toReader = reader->activate_this();
        toWriter->setRemoteSide(toReader);
        toReader->setRemoteSide(toWriter);
        remote = toReader;
        EXPECT_TRUE(before->connectTo(writer));
        EXPECT_TRUE(reader->connectTo(behind));
    }
    ~Channel() {
        before->disconnect(true);
        // The reader ends in a thread of the ORB, which the end of the process may overtake.
        EXPECT_TRUE(soon([&] { return remote->_non_existent(); }));
    }
    static boost::intrusive_ptr<End> newEnd(const ConnPolicy& policy) {
        static const corba::CorbaTemplateProtocol<double> transporter;
        corba::CRemoteChannelElement_i* const made =
            transporter.createChannelElement_i(nullptr, corba::ApplicationServer::rootPOA, policy);
        return boost::intrusive_ptr<End>(dynamic_cast<End*>(made), false);
    }
    static base::ChannelElement<double>::shared_ptr storage(const ConnPolicy& policy) {
        return internal::ConnFactory::buildDataStorage<double>(policy);
    }

    boost::intrusive_ptr<End> writer, reader;
    base::ChannelElement<double>::shared_ptr before, behind;
    corba::CRemoteChannelElement_var remote;
};

}  // namespace

TEST_F(CorbaParts, AChannelElementPassesSamplesOn) {
    Channel channel(ConnPolicy::buffer(10));
    for (const double sample : {1, 2, 3}) EXPECT_EQ(channel.before->write(sample), WriteSuccess);
    channel.writer->transferSamples();
    double sample = 0;
    for (const double expected : {1, 2, 3}) {
        EXPECT_TRUE(soon([&] { return channel.behind->read(sample, false) == NewData; }));
        EXPECT_EQ(sample, expected);
    }
    CORBA::Any text;
    text <<= "a text";
    EXPECT_EQ(channel.remote->write(text), corba::CWriteFailure) << "of another type";
    EXPECT_TRUE(channel.reader->isRemoteElement());
}

TEST_F(CorbaParts, AChannelElementFetchesSamples) {
    Channel channel(ConnPolicy::buffer(10, ConnPolicy::LOCK_FREE, false, ConnPolicy::PULL));
    double sample = 0;
    EXPECT_EQ(channel.reader->readErased(&sample, false), NoData);
    EXPECT_EQ(channel.before->write(4), WriteSuccess);
    EXPECT_EQ(channel.reader->readErased(&sample, false), NewData);
    EXPECT_EQ(sample, 4);
}

TEST_F(CorbaParts, AChannelElementThatIsDisconnectedCannotBeCalled) {
    Channel channel(ConnPolicy::buffer(10));
    channel.before->disconnect(true);
    CORBA::Any number;
    number <<= 2.5;
    EXPECT_TRUE(soon([&] {
        try {
            (void)channel.remote->write(number);
            return false;
        } catch (const CORBA::OBJECT_NOT_EXIST&) {
            return true;
        }
    }));
}

TEST_F(CorbaParts, AnOperationIsCalledByItsName) {
    TaskContext user("user");
    auto* const add = new corba::CorbaOperationCallerFactory("add", service, corba::ApplicationServer::rootPOA);
    EXPECT_EQ(add->description(), "Adds.");
    EXPECT_EQ(add->arity(), 2U);
    EXPECT_EQ(add->resultType(), "int");
    user.provides()->add("add", add);
    OperationCaller<int(int, int)> call(user.getOperation("add"));
    ASSERT_TRUE(call.ready());
    EXPECT_EQ(call(2, 3), 5);
    EXPECT_THROW(corba::CorbaOperationCallerFactory("none", service, corba::ApplicationServer::rootPOA),
                 name_not_found_exception);
}

TEST_F(CorbaParts, AValueIsThatOfTheOther) {
    const corba::DataSourceProxy<double>::shared_ptr shown = new corba::DataSourceProxy<double>(service, "gain", true);
    EXPECT_EQ(shown->get(), 1.5);
    gain = 3;
    EXPECT_TRUE(shown->evaluate());
    EXPECT_EQ(shown->rvalue(), 3);
    const corba::ValueDataSourceProxy<double>::shared_ptr own =
        new corba::ValueDataSourceProxy<double>(service, "level", false);
    own->set(7);
    EXPECT_EQ(level, 7);
    own->set() = 8;
    own->updated();
    EXPECT_EQ(level, 8);
    EXPECT_THROW(corba::DataSourceProxy<double>(service, "none", true), corba::NonExistingDataSource);
    EXPECT_THROW(corba::DataSourceProxy<int>(service, "gain", true), corba::NonExistingDataSource);
}

TEST_F(CorbaParts, AnAnyIsAssignedToItsTypeOnly) {
    const boost::intrusive_ptr<corba::AnyDataSource> any =
        new corba::AnyDataSource(corba::AnyConversion<double>::createAny(2.5));
    const auto number = types_test::variable(0.0);
    EXPECT_TRUE(any->assignTo(number));
    EXPECT_EQ(number->rvalue(), 2.5);
    EXPECT_FALSE(any->assignTo(types_test::variable(0)));
}
