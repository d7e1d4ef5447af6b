// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/DeploymentComponent.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/extras/FileDescriptorActivityInterface.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/startstop.h>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <filesystem>

namespace {

using OCL::DeploymentComponent;
using oroforge::test::TempDir;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

const char* const kTwo =
    "<properties>"
    "<struct name='p' type='deploytest::Producer'>"
    "<struct name='Ports' type='PropertyBag'><simple name='numbers' type='string'><value>w</value></simple></struct>"
    "<simple name='AutoConf' type='boolean'><value>1</value></simple></struct>"
    "<struct name='c' type='deploytest::Consumer'>"
    "<struct name='Ports' type='PropertyBag'><simple name='numbers' type='string'><value>w</value></simple></struct>"
    "<simple name='AutoStart' type='boolean'><value>1</value></simple></struct>"
    "</properties>";

class Deployment : public testing::Test {
protected:
    static void SetUpTestSuite() {
        static char name[] = "deployment_test";
        static char* words[] = {name, nullptr};
        __os_init(1, words);
    }
    static void TearDownTestSuite() { __os_exit(); }

    Deployment() : old_(std::filesystem::current_path()) {
        std::filesystem::current_path(directory_.path());  // no site file of others, and the log goes away
        deployer_ = std::make_unique<DeploymentComponent>("Deployer");
        RTT::ComponentLoader::Instance()->setComponentPath(DEPLOYER_TEST_PATH);
        EXPECT_TRUE(deployer_->import("deploytest"));
    }
    ~Deployment() override {
        deployer_.reset();
        std::filesystem::current_path(old_);
    }

    RTT::TaskContext* peer(const std::string& name) { return deployer_->getPeer(name); }

    TempDir directory_;
    std::filesystem::path old_;
    std::unique_ptr<DeploymentComponent> deployer_;
};

TEST_F(Deployment, ComponentIsLoadedAsPeerAndUnloaded) {
    EXPECT_THAT(deployer_->getComponentTypes(), Contains("deploytest::Producer"));
    EXPECT_TRUE(deployer_->loadComponent("p", "deploytest::Producer"));
    ASSERT_NE(nullptr, peer("p"));
    EXPECT_FALSE(deployer_->loadComponent("p", "deploytest::Producer"));
    EXPECT_FALSE(deployer_->loadComponent("q", "deploytest::Prodcer"));
    EXPECT_FALSE(deployer_->loadComponent("Deployer", "deploytest::Producer"));
    EXPECT_TRUE(deployer_->unloadComponent("p"));
    EXPECT_EQ(nullptr, peer("p"));
    EXPECT_FALSE(deployer_->unloadComponent("p"));
}

TEST_F(Deployment, RunningComponentIsNotUnloaded) {
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    EXPECT_TRUE(deployer_->startComponent("c"));
    EXPECT_TRUE(deployer_->startComponent("c"));
    EXPECT_FALSE(deployer_->unloadComponent("c"));
    EXPECT_TRUE(deployer_->stopComponent("c"));
    EXPECT_TRUE(deployer_->stopComponent("c"));
    EXPECT_TRUE(deployer_->unloadComponent("c"));
}

TEST_F(Deployment, UnknownNamesAreRefusedByAll) {
    EXPECT_FALSE(deployer_->configureComponent("x"));
    EXPECT_FALSE(deployer_->startComponent("x"));
    EXPECT_FALSE(deployer_->stopComponent("x"));
    EXPECT_FALSE(deployer_->loadService("x", "marshalling"));
    EXPECT_FALSE(deployer_->addPeer("x", "this"));
    EXPECT_FALSE(deployer_->connectPeers("x", "this"));
    EXPECT_FALSE(deployer_->connectPorts("x", "this"));
    EXPECT_FALSE(deployer_->connect("x.p", "this.q", RTT::ConnPolicy()));
    EXPECT_FALSE(deployer_->setActivity("x", 0.1, 0, ORO_SCHED_OTHER));
    EXPECT_FALSE(deployer_->kickOutComponent("x"));
}

TEST_F(Deployment, NamesThatArePathsOrBeginOtherLinesAreRefusedByAll) {
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    const auto peers = deployer_->getPeerList();
    for (const char* name : {"../x", "a/b", "/", "a\n9.999 forged", "a\x1b[2J", "a\tb", "a\x7f"}) {
        EXPECT_FALSE(deployer_->loadComponent(name, "deploytest::Consumer")) << name;
        EXPECT_FALSE(deployer_->aliasPeer("c", "this", name)) << name;
        RTT::TaskContext made(name);
        EXPECT_FALSE(deployer_->addPeer(&made)) << name;
        EXPECT_FALSE(deployer_->addPeer(peer("c"), name)) << name;
        EXPECT_FALSE(deployer_->connectPeers(&made)) << name;
        EXPECT_EQ(peers, deployer_->getPeerList()) << name;
    }
    EXPECT_FALSE(peer("c")->hasPeer("../x"));
}

TEST_F(Deployment, PortsAreConnectedByPath) {
    ASSERT_TRUE(deployer_->loadComponent("p", "deploytest::Producer"));
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    EXPECT_TRUE(deployer_->connect("c.numbers", "p.numbers", RTT::ConnPolicy::buffer(10)));
    EXPECT_TRUE(peer("p")->getPort("numbers")->connected());
    EXPECT_FALSE(deployer_->connect("c.text", "p.numbers", RTT::ConnPolicy()));
    EXPECT_FALSE(deployer_->connect("c.none", "p.numbers", RTT::ConnPolicy()));
    EXPECT_FALSE(deployer_->connectTwoPorts("c", "text", "p", "numbers"));
}

TEST_F(Deployment, OperationsAreConnectedByPath) {
    ASSERT_TRUE(deployer_->loadComponent("p", "deploytest::Producer"));
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    RTT::OperationCaller<bool()> running("running"), nested("nested");
    peer("c")->requires_()->addOperationCaller(running);
    peer("c")->requires_("a")->requires_("b")->addOperationCaller(nested);
    peer("p")->provides("x")->provides("y")->addOperation("active", [] { return true; });
    EXPECT_TRUE(deployer_->connectOperations("c.running", "p.isRunning"));
    EXPECT_FALSE(running());
    EXPECT_FALSE(deployer_->connectOperations("c.running", "p.isActive")) << "is connected already";
    EXPECT_FALSE(running());
    EXPECT_TRUE(deployer_->connectOperations("c.a.b.nested", "p.x.y.active"));
    EXPECT_TRUE(nested());
    nested.disconnect();
    RTT::Operation<bool()> local("local", [] { return true; });
    ASSERT_TRUE(peer("p")->provides()->addLocalOperation(local));
    EXPECT_TRUE(deployer_->connectOperations("c.a.b.nested", "p.local"));
    EXPECT_TRUE(nested());
    nested.disconnect();
    peer("p")->provides()->removeOperation("local");
    for (const char* requested : {"c", "none.nested", "c.none", "c.a.nested", "c.a.b.c.nested"})
        EXPECT_FALSE(deployer_->connectOperations(requested, "p.isActive")) << requested;
    for (const char* provided : {"p", "none.isActive", "p.none", "p.none.isActive", "p.setPeriod"})
        EXPECT_FALSE(deployer_->connectOperations("c.a.b.nested", provided)) << provided;
    EXPECT_FALSE(nested.ready());
    EXPECT_FALSE(peer("c")->requires_()->requiresService("none")) << "nothing is made on the way";
    EXPECT_TRUE(deployer_->getOperation("connectOperations"));
}

TEST_F(Deployment, PeersAreAddedAndAliased) {
    ASSERT_TRUE(deployer_->loadComponent("p", "deploytest::Producer"));
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    EXPECT_TRUE(deployer_->addPeer("p", "c"));
    EXPECT_TRUE(deployer_->addPeer("p", "c"));
    EXPECT_EQ(peer("c"), peer("p")->getPeer("c"));
    EXPECT_TRUE(deployer_->aliasPeer("p", "this", "boss"));
    EXPECT_EQ(deployer_.get(), peer("p")->getPeer("boss"));
}

TEST_F(Deployment, PeersThatCannotBothBeConnectedStayAsTheyWere) {
    ASSERT_TRUE(deployer_->loadComponent("p", "deploytest::Producer"));
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    EXPECT_TRUE(deployer_->aliasPeer("c", "this", "p"));
    EXPECT_FALSE(deployer_->connectPeers("p", "c"));
    EXPECT_FALSE(peer("p")->hasPeer("c"));
    EXPECT_TRUE(deployer_->connectPeers("this", "p"));
    EXPECT_TRUE(peer("p")->hasPeer("Deployer"));
}

TEST_F(Deployment, PropertyThatIsGivenTwiceIsNotAddedToTheComponent) {
    const std::string twice = "<simple name='first' type='long'><value>7</value></simple>";
    directory_.write("twice.xml",
                     "<properties><struct name='p' type='deploytest::Producer'><struct name='Properties' "
                     "type='PropertyBag'>" +
                         twice + twice + "</struct></struct></properties>");
    ASSERT_TRUE(deployer_->loadComponent("other", "deploytest::Producer"));
    EXPECT_TRUE(deployer_->kickStart("twice.xml"));
    EXPECT_EQ(peer("other")->properties()->size(), peer("p")->properties()->size());
}

TEST_F(Deployment, PropertyFileThatChangesAfterTheCheckIsReadAgain) {
    const auto first = [](const char* value) {
        return std::string("<properties><simple name='first' type='long'><value>") + value +
               "</value></simple></properties>";
    };
    directory_.write("app.xml",
                     "<properties><struct name='p' type='deploytest::Producer'><simple name='UpdateProperties' "
                     "type='string'><value>p.cpf</value></simple></struct></properties>");
    directory_.write("p.cpf", first("2"));
    ASSERT_TRUE(deployer_->loadComponents("app.xml"));
    directory_.write("p.cpf", first("3"));
    EXPECT_TRUE(deployer_->configureComponents());
    EXPECT_EQ(3, peer("p")->properties()->getPropertyType<int>("first")->get());
}

TEST_F(Deployment, ActivitiesAreSetWhileStopped) {
    ASSERT_TRUE(deployer_->loadComponent("p", "deploytest::Producer"));
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    EXPECT_TRUE(deployer_->setActivity("p", 0.5, 0, ORO_SCHED_OTHER));
    EXPECT_DOUBLE_EQ(0.5, peer("p")->getPeriod());
    EXPECT_TRUE(deployer_->setFileDescriptorActivity("p", 250, 0, ORO_SCHED_OTHER));
    const auto* const io =
        dynamic_cast<RTT::extras::FileDescriptorActivityInterface*>(deployer_->getPeer("p")->getActivity());
    ASSERT_TRUE(io);
    EXPECT_EQ(250, io->getTimeout());
    EXPECT_DOUBLE_EQ(0.25, deployer_->getPeer("p")->getActivity()->getPeriod());
    EXPECT_FALSE(deployer_->setFileDescriptorActivity("p", 1e12, 0, ORO_SCHED_OTHER));
    EXPECT_TRUE(deployer_->setSequentialActivity("p"));
    EXPECT_TRUE(deployer_->setPeriodicActivity("p", 0.25, 0, ORO_SCHED_OTHER));
    EXPECT_FALSE(deployer_->setPeriodicActivity("p", 0, 0, ORO_SCHED_OTHER));
    EXPECT_DOUBLE_EQ(0.25, peer("p")->getPeriod());
    EXPECT_TRUE(deployer_->startComponent("c"));
    EXPECT_FALSE(deployer_->setActivity("c", 0.5, 0, ORO_SCHED_OTHER));
}

TEST_F(Deployment, ActivityIsKeptIfTheComponentItselfAsksForAnother) {
    ASSERT_TRUE(deployer_->loadComponent("c", "deploytest::Consumer"));
    RTT::base::ActivityInterface* const before = peer("c")->getActivity();
    peer("c")->addOperation(
        "change", [this] { return deployer_->setActivity("c", 0.5, 0, ORO_SCHED_OTHER); }, RTT::OwnThread);
    RTT::OperationCaller<bool()> change(peer("c")->getOperation("change"), RTT::internal::GlobalEngine::Instance());
    EXPECT_FALSE(change());
    EXPECT_EQ(before, peer("c")->getActivity());
    EXPECT_TRUE(peer("c")->isActive());
}

TEST_F(Deployment, RunningMasterKeepsItsSlavesIfItsActivityIsNotChanged) {
    ASSERT_TRUE(deployer_->loadComponent("master", "deploytest::Consumer"));
    ASSERT_TRUE(deployer_->loadComponent("slave", "deploytest::Consumer"));
    ASSERT_TRUE(deployer_->setMasterSlaveActivity("master", "slave"));
    RTT::base::ActivityInterface* const before = peer("slave")->getActivity();
    ASSERT_TRUE(deployer_->startComponent("master"));
    EXPECT_FALSE(deployer_->setActivity("master", 0.5, 0, ORO_SCHED_OTHER));
    EXPECT_EQ(before, peer("slave")->getActivity());
}

TEST_F(Deployment, SlavesOfSlavesAndThoseThatRunGetTheNewActivityOfTheirMaster) {
    for (const char* name : {"master", "middle", "last"})
        ASSERT_TRUE(deployer_->loadComponent(name, "deploytest::Consumer"));
    ASSERT_TRUE(deployer_->setMasterSlaveActivity("middle", "last"));
    ASSERT_TRUE(deployer_->setMasterSlaveActivity("master", "middle"));
    ASSERT_TRUE(deployer_->startComponent("middle"));
    ASSERT_TRUE(deployer_->startComponent("last"));
    const auto isSlave = [this](const char* name, const char* master) {
        const auto* const slave = dynamic_cast<RTT::extras::SlaveActivity*>(peer(name)->getActivity());
        return slave && slave->isSlaveOf(*peer(master)->getActivity());
    };
    EXPECT_TRUE(deployer_->setActivity("master", 0.5, 0, ORO_SCHED_OTHER));
    EXPECT_TRUE(isSlave("middle", "master"));
    EXPECT_TRUE(isSlave("last", "middle"));
    EXPECT_DOUBLE_EQ(0.5, peer("last")->getPeriod());
    EXPECT_TRUE(peer("middle")->isRunning());
    EXPECT_TRUE(peer("last")->isRunning());
    EXPECT_TRUE(deployer_->unloadComponent("master"));
    EXPECT_FALSE(peer("middle")->isRunning());
    EXPECT_TRUE(isSlave("last", "middle"));
}

TEST_F(Deployment, MasterMayBeUnloadedBeforeItsSlave) {
    ASSERT_TRUE(deployer_->loadComponent("slave", "deploytest::Consumer"));
    ASSERT_TRUE(deployer_->loadComponent("master", "deploytest::Consumer"));
    EXPECT_TRUE(deployer_->setMasterSlaveActivity("master", "slave"));
    EXPECT_TRUE(peer("master")->hasPeer("slave"));
    EXPECT_NE(nullptr, dynamic_cast<RTT::extras::SlaveActivity*>(peer("slave")->getActivity()));
    EXPECT_TRUE(deployer_->unloadComponent("master"));
    EXPECT_EQ(nullptr, dynamic_cast<RTT::extras::SlaveActivity*>(peer("slave")->getActivity()));
    EXPECT_TRUE(deployer_->startComponent("slave"));
}

TEST_F(Deployment, FileIsLoadedConfiguredAndStartedInSteps) {
    ASSERT_TRUE(deployer_->loadConfigurationString(kTwo));
    EXPECT_FALSE(peer("p")->isConfigured());
    EXPECT_FALSE(peer("p")->getPort("numbers")->connected());
    ASSERT_TRUE(deployer_->configureComponents());
    EXPECT_TRUE(peer("p")->isConfigured());
    EXPECT_TRUE(peer("p")->getPort("numbers")->connected());
    ASSERT_TRUE(deployer_->startComponents());
    EXPECT_TRUE(peer("c")->isRunning());
    EXPECT_FALSE(peer("p")->isRunning());
    EXPECT_TRUE(deployer_->stopComponents());
    EXPECT_TRUE(deployer_->cleanupComponents());
    EXPECT_FALSE(peer("p")->isConfigured());
    EXPECT_TRUE(deployer_->unloadComponents());
    EXPECT_THAT(deployer_->getPeerList(), IsEmpty());
}

TEST_F(Deployment, FailedFileLeavesNothingAndChangesNothing) {
    ASSERT_TRUE(deployer_->loadComponent("before", "deploytest::Consumer"));
    directory_.write("bad.xml",
                     "<properties>"
                     "<struct name='before' type='PropertyBag'><simple name='AutoStart' "
                     "type='boolean'><value>1</value></simple></struct>"
                     "<struct name='p' type='deploytest::Producer'/>"
                     "<struct name='r' type='deploytest::RefusesToConfigure'><simple name='AutoConf' "
                     "type='boolean'><value>1</value></simple></struct>"
                     "</properties>");
    EXPECT_FALSE(deployer_->kickStart("bad.xml"));
    EXPECT_THAT(deployer_->getPeerList(), ElementsAre("before"));
    directory_.write("good.xml", kTwo);
    EXPECT_TRUE(deployer_->kickStart("good.xml"));
    EXPECT_FALSE(peer("before")->isRunning());
}

TEST_F(Deployment, KickOutRemovesTheComponentsOfAFile) {
    directory_.write("good.xml", kTwo);
    ASSERT_TRUE(deployer_->loadComponent("other", "deploytest::Consumer"));
    ASSERT_TRUE(deployer_->kickStart("good.xml"));
    deployer_->kickOut("good.xml");
    EXPECT_THAT(deployer_->getPeerList(), ElementsAre("other"));
    EXPECT_TRUE(deployer_->kickOutAll());
    EXPECT_THAT(deployer_->getPeerList(), IsEmpty());
}

TEST_F(Deployment, DeployerItselfTakesOptions) {
    directory_.write("self.xml",
                     "<properties><struct name='this' type='PropertyBag'>"
                     "<struct name='Activity' type='Activity'><simple name='Period' "
                     "type='double'><value>0.5</value></simple></struct>"
                     "<struct name='Peers' type='PropertyBag'><simple type='string'><value>c</value></simple></struct>"
                     "</struct><struct name='c' type='deploytest::Consumer'/></properties>");
    EXPECT_TRUE(deployer_->kickStart("self.xml"));
    EXPECT_DOUBLE_EQ(0.5, deployer_->getPeriod());
}

TEST_F(Deployment, OperationsAreThereForScripts) {
    RTT::OperationCaller<bool(const std::string&, const std::string&)> load(
        deployer_->provides()->getOperation("loadComponent"));
    ASSERT_TRUE(load.ready());
    EXPECT_TRUE(load("c", "deploytest::Consumer"));
    for (const char* name :
         {"import", "path", "kickStart", "connect", "stream", "setActivity", "loadService", "waitForInterrupt"})
        EXPECT_TRUE(deployer_->provides()->hasOperation(name)) << name;
    EXPECT_NE(nullptr, deployer_->getProperty("AutoUnload"));
    EXPECT_NE(nullptr, deployer_->provides()->getAttribute("Target"));
}

}  // namespace
