// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Transporters that are written for a type, and what programs of users have.
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/transports/corba/Corba.hpp>
#include <rtt/transports/corba/CorbaTemplateProtocol.hpp>
#include <rtt/transports/corba/TaskContextFactory.hpp>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>
#include <rtt/transports/corba/TransportPlugin.hpp>
#include <rtt/transports/corba/rtt-corba-fwd.hpp>

#include "../types/builtin_typekit.hpp"
#include "downstream_types.hpp"

#include <rtt/types/GeneratedTypekit.hpp>

#include <cstddef>
#include <string>

using namespace RTT;
using corba::AnyConversion;
using corba::CorbaTypeTransporter;

namespace {

namespace t = RTT::types;

constexpr t::Member spotMembers[] = {
    {"east", offsetof(downstream::Spot, east), &t::typeRef<double>, 0, "", ""},
    {"north", offsetof(downstream::Spot, north), &t::typeRef<double>, 0, "", ""},
};
constexpr t::Member cornerMembers[] = {
    {"x", offsetof(downstream::Corner, x), &t::typeRef<double>, 0, "", ""},
    {"y", offsetof(downstream::Corner, y), &t::typeRef<double>, 0, "", ""},
};

/** As a user's program derives one. */
class OwnProxy : public corba::TaskContextProxy {
public:
    explicit OwnProxy(const std::string& location) { initFromURIOrTaskname(location, true); }
    bool again() { return synchronize(); }
};

class CorbaTemplateProtocols : public types_test::WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        types_test::WithBuiltinTypes::SetUpTestSuite();
        types::Types()->addType(t::makeStructType<downstream::Spot>("/downstream/Spot", spotMembers, 2));
        types::Types()->addType(t::makeStructType<downstream::Corner>("/downstream/Corner", cornerMembers, 2));
        types::Types()->addType(t::makeSequenceType<std::vector<downstream::Corner>>("/downstream/Corners"));
        types::TypekitRepository::Import(new corba::CorbaLibPlugin());
        int argc = 1;
        char name[] = "test";
        char* argv[] = {name, nullptr};
        ASSERT_TRUE(corba::TaskContextFactory::InitOrb(argc, argv));
        before = transporter("/downstream/Spot");
        void* const library = dlopen(DOWNSTREAM_TRANSPORT, RTLD_NOW | RTLD_LOCAL);
        ASSERT_TRUE(library) << dlerror();
        const auto load = reinterpret_cast<bool (*)(TaskContext*)>(dlsym(library, "loadRTTPlugin"));
        ASSERT_TRUE(load && load(nullptr));
    }
    static void TearDownTestSuite() { corba::TaskContextFactory::DestroyOrb(); }

    static CorbaTypeTransporter* transporter(const char* type) {
        types::TypeInfo* const info = types::Types()->type(type);
        return info && info->hasProtocol(ORO_CORBA_PROTOCOL_ID)
                   ? dynamic_cast<CorbaTypeTransporter*>(info->getProtocol(ORO_CORBA_PROTOCOL_ID))
                   : nullptr;
    }
    static inline const CorbaTypeTransporter* before = nullptr;
};

}  // namespace

// The library binds its own symbols at link time, but not these.
TEST_F(CorbaTemplateProtocols, ProgramsSeeTheVariablesOfTheLibrary) {
    EXPECT_FALSE(CORBA::is_nil(corba::ApplicationServer::orb));
    EXPECT_FALSE(CORBA::is_nil(corba::ApplicationServer::rootPOA));
    EXPECT_TRUE(corba::_tc_CConnPolicy);
    EXPECT_TRUE(corba::_tc_CAnySequence);
}

TEST_F(CorbaTemplateProtocols, ReplaceTheGenericTransporter) {
    ASSERT_TRUE(before);
    EXPECT_TRUE(before->isGeneric());
    const CorbaTypeTransporter* const own = transporter("/downstream/Spot");
    ASSERT_TRUE(own);
    EXPECT_NE(own, before);
    EXPECT_FALSE(own->isGeneric());

    const auto source = types_test::variable(downstream::Spot{1, 2});
    const CORBA::Any_var any = own->createAny(source);
    ASSERT_NE(any.operator->(), nullptr);
    EXPECT_STREQ(any->NP_type()->id(), "IDL:orogen/sample/Corba/Point:1.0");
    const base::DataSourceBase::shared_ptr made = own->createDataSource(&any.in());
    ASSERT_TRUE(made);
    EXPECT_EQ(types_test::valueOf<downstream::Spot>(made).north, 2);
    const auto target = types_test::variable(downstream::Spot());
    EXPECT_TRUE(own->updateFromAny(&any.in(), target));
    EXPECT_EQ(target->rvalue().east, 1);
}

TEST_F(CorbaTemplateProtocols, ConvertTheElementsOfContainers) {
    const CorbaTypeTransporter* const own = transporter("/downstream/Corners");
    ASSERT_TRUE(own);
    ASSERT_FALSE(own->isGeneric());
    const auto source = types_test::variable(std::vector<downstream::Corner>{{1, 2}, {3, 4}});
    CORBA::Any any;
    ASSERT_TRUE(own->updateAny(source, any));
    EXPECT_STREQ(any.NP_type()->id(), "IDL:orogen/sample/Corba/vector__sample_Point_:1.0");
    const auto target = types_test::variable(std::vector<downstream::Corner>());
    ASSERT_TRUE(own->updateFromAny(&any, target));
    ASSERT_EQ(target->rvalue().size(), 2U);
    EXPECT_EQ(target->rvalue()[1].y, 4);
}

TEST_F(CorbaTemplateProtocols, RefuseOtherTypes) {
    const CorbaTypeTransporter* const own = transporter("/downstream/Spot");
    ASSERT_TRUE(own);
    CORBA::Any number;
    number <<= 2.5;
    const auto target = types_test::variable(downstream::Spot{7, 8});
    EXPECT_FALSE(own->updateFromAny(&number, target));
    EXPECT_FALSE(own->updateFromAny(nullptr, target));
    EXPECT_EQ(target->rvalue().east, 7);
    EXPECT_FALSE(own->createDataSource(&number));
    EXPECT_FALSE(own->createDataSource(nullptr));
    EXPECT_EQ(own->createAny(types_test::variable(3)), nullptr);
    EXPECT_FALSE(own->updateAny(nullptr, number));
    const CORBA::Any_var spot = own->createAny(target);
    EXPECT_FALSE(own->updateFromAny(&spot.in(), types_test::variable(3)));
}

TEST_F(CorbaTemplateProtocols, SendAPolicyAsTheOriginalDoes) {
    const CorbaTypeTransporter* const own = transporter("ConnPolicy");
    ASSERT_TRUE(own);
    const CORBA::Any_var any = own->createAny(types_test::variable(ConnPolicy::buffer(9)));
    ASSERT_NE(any.operator->(), nullptr);
    EXPECT_TRUE(any->NP_type()->equal(corba::_tc_CConnPolicy));
    const auto target = types_test::variable(ConnPolicy());
    EXPECT_TRUE(own->updateFromAny(&any.in(), target));
    EXPECT_EQ(target->rvalue().size, 9);
}

TEST_F(CorbaTemplateProtocols, SendAComponentByItsReference) {
    const CorbaTypeTransporter* const own = transporter("TaskContext");
    ASSERT_TRUE(own);
    TaskContext component("sent");
    EXPECT_EQ(corba::TaskContextServer::getIOR(&component), "");
    const CORBA::Any_var any = own->createAny(types_test::variable<TaskContext*>(&component));
    ASSERT_NE(any.operator->(), nullptr);
    EXPECT_EQ(any->NP_type()->kind(), CORBA::tk_objref);
    EXPECT_STREQ(any->NP_type()->id(), "IDL:RTT/corba/CTaskContext:1.0");
    EXPECT_NE(corba::TaskContextServer::getIOR(&component), "") << "others can call it now";

    TaskContext kept("kept");
    const auto target = types_test::variable<TaskContext*>(&kept);
    EXPECT_TRUE(own->updateFromAny(&any.in(), target));
    EXPECT_EQ(target->rvalue(), &component);
    corba::TaskContextServer::CleanupServer(&component);
}

TEST_F(CorbaTemplateProtocols, LeaveTheComponentIfThereIsNone) {
    const CorbaTypeTransporter* const own = transporter("TaskContext");
    ASSERT_TRUE(own);
    const CORBA::Any_var none = own->createAny(types_test::variable<TaskContext*>(nullptr));
    ASSERT_NE(none.operator->(), nullptr);
    EXPECT_EQ(none->NP_type()->kind(), CORBA::tk_null);
    CORBA::Any number;
    number <<= 2.5;
    TaskContext kept("kept");
    const auto target = types_test::variable<TaskContext*>(&kept);
    EXPECT_TRUE(own->updateFromAny(&none.in(), target));
    EXPECT_TRUE(own->updateFromAny(&number, target));
    EXPECT_EQ(target->rvalue(), &kept);
}

TEST_F(CorbaTemplateProtocols, ReadAndWriteThePropertyOfAnother) {
    TaskContext component("other");
    downstream::Spot spot{1, 2};
    component.addProperty("spot", spot);
    downstream::Corner corner{3, 4};
    component.addProperty("corner", corner);
    double level = 4;
    component.addAttribute("level", level);
    ASSERT_TRUE(corba::TaskContextServer::CreateServer(&component, false));
    OwnProxy proxy(corba::TaskContextServer::getIOR(&component));
    EXPECT_TRUE(proxy.again());
    const corba::CService_var service = proxy.server()->getProvider("this");

    const auto property = transporter("/downstream/Spot")->createPropertyDataSource(service, "spot");
    ASSERT_TRUE(property);
    EXPECT_EQ(types_test::valueOf<downstream::Spot>(property).north, 2);
    auto* const assignable = internal::AssignableDataSource<downstream::Spot>::narrow(property.get());
    ASSERT_TRUE(assignable);
    assignable->set(downstream::Spot{5, 6});
    EXPECT_EQ(spot.north, 6);
    ASSERT_FALSE(transporter("/downstream/Corner")->isGeneric());
    const auto byHand = transporter("/downstream/Corner")->createPropertyDataSource(service, "corner");
    ASSERT_TRUE(byHand);
    EXPECT_EQ(types_test::valueOf<downstream::Corner>(byHand).y, 4);
    const auto attribute = transporter("double")->createAttributeDataSource(service, "level", true);
    ASSERT_TRUE(attribute);
    EXPECT_EQ(types_test::valueOf<double>(attribute), 4);
    EXPECT_FALSE(transporter("double")->createPropertyDataSource(service, "spot")) << "of another type";
    EXPECT_FALSE(transporter("double")->createPropertyDataSource(service, "none"));
    corba::TaskContextServer::CleanupServer(&component);
}

TEST_F(CorbaTemplateProtocols, AFactoryMakesProxiesWithoutTheOrb) {
    TaskContext component("made");
    ASSERT_TRUE(corba::TaskContextServer::CreateServer(&component, false));
    TaskContext* const proxy = corba::TaskContextFactory::Create(corba::TaskContextServer::getIOR(&component), true);
    ASSERT_TRUE(proxy);
    EXPECT_EQ(proxy->getName(), "made");
    delete proxy;
    EXPECT_EQ(corba::TaskContextFactory::CreateFromFile("/no/such/file"), nullptr);
    corba::TaskContextServer::CleanupServer(&component);
}
