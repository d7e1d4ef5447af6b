// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Plugins that were built with different versions of a header: their ports must not be connected.
#include "log_capture.hpp"

#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/SharedConnection.hpp>
#include <rtt/types/Schema.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

using flow_test::LogCapture;
using RTT::base::PortInterface;

namespace {

/** Components whose ports are of plan::Sample as the library of one version saw it. */
class Fingerprint : public testing::Test {
protected:
    RTT::TaskContext& component(const std::string& name, const std::string& type, const std::string& version) {
        const std::string file = FINGERPRINT_DIR "/libfingerprint_" + version + "-" FINGERPRINT_TARGET + ".so";
        EXPECT_TRUE(loader_->loadLibrary(file));
        RTT::TaskContext* const made = loader_->loadComponent(name, type + "_" + version);
        if (!made) throw std::runtime_error(file + " has no component type " + type + "_" + version);
        made_.emplace_back(made, [this](RTT::TaskContext* one) { loader_->unloadComponent(one); });
        return *made;
    }
    PortInterface& writer(const std::string& version) {
        return *component("w", "Writer", version).ports()->getPort("out");
    }
    PortInterface& reader(const std::string& version, const std::string& name = "r") {
        return *component(name, "Reader", version).ports()->getPort("in");
    }

    /** What is told when `first` is refused to write to a port of `version`; empty if it may. */
    std::string refusal(const std::string& version) {
        LogCapture log;
        const bool connected = writer("first").connectTo(&reader(version), RTT::ConnPolicy::data());
        EXPECT_EQ(connected, log.text().empty()) << log.text();
        return connected ? "" : log.text();
    }

private:
    RTT::ComponentLoader::shared_ptr loader_ = RTT::ComponentLoader::Instance();
    std::vector<std::unique_ptr<RTT::TaskContext, std::function<void(RTT::TaskContext*)>>> made_;
};

void expectText(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "expected: " << part << "\nfound: " << text;
}

}  // namespace

TEST_F(Fingerprint, ConnectsPluginsBuiltAlike) {
    PortInterface &out = writer("first"), &in = reader("same");
    ASSERT_NE(out.sampleSchema(), in.sampleSchema()) << "each plugin must have its own";
    EXPECT_STREQ(out.sampleSchema()->name, "plan::Sample");
    EXPECT_STREQ(in.sampleSchema()->name, "plan::Sample");
    EXPECT_TRUE(out.connectTo(&in, RTT::ConnPolicy::data()));
    EXPECT_EQ(layoutHash(*out.sampleSchema()), layoutHash(*in.sampleSchema()));
    EXPECT_EQ(schemaHash(*out.sampleSchema()), schemaHash(*in.sampleSchema()));
}

TEST_F(Fingerprint, NamesFieldsThatHaveChangedPlaces) {
    expectText(refusal("swapped"),
               "field 'path[].second.x' is at byte 0 in the plugin of w.out, byte 8 in that of r.in");
}

TEST_F(Fingerprint, NamesAFieldThatWasRenamed) {
    expectText(refusal("renamed"), "field 'path[].second.y' is called 'y' in the plugin of w.out, 'z' in that of r.in");
}

TEST_F(Fingerprint, NamesAFieldOfAnotherType) {
    expectText(refusal("retyped"),
               "field 'path[].second.y' is of type 'double' in the plugin of w.out, 'long long' in that of r.in");
}

TEST_F(Fingerprint, NamesAFieldOfAnotherUnit) {
    expectText(refusal("units"), "field 'path[].second.x' has the unit m in the plugin of w.out, mm in that of r.in");
}

TEST_F(Fingerprint, NamesAnEnumeratorOfAnotherNumber) {
    expectText(refusal("renumbered"),
               "enumerator 'Idle' of field 'mode' is 0 in the plugin of w.out, 1 in that of r.in");
}

TEST_F(Fingerprint, LetsEnumeratorsBeAdded) { EXPECT_EQ(refusal("more_modes"), ""); }

TEST_F(Fingerprint, ComparesSizesIfOneSideHasNoDescription) {
    expectText(refusal("larger"), "the type has 32 bytes in the plugin of w.out, 40 bytes in that of r.in");
}

TEST_F(Fingerprint, ConnectsPluginsOfWhichOneHasNoDescription) { EXPECT_EQ(refusal("plain"), ""); }

TEST_F(Fingerprint, IsComparedByBothDirectionsAndByClones) {
    PortInterface &out = writer("first"), &in = reader("swapped");
    LogCapture log;
    EXPECT_FALSE(in.connectTo(&out));
    const std::unique_ptr<PortInterface> clone(in.clone()), opposite(in.antiClone());
    EXPECT_FALSE(out.connectTo(clone.get()));
    EXPECT_TRUE(opposite->connectTo(&in));
}

TEST_F(Fingerprint, IsComparedInSharedConnections) {
    RTT::ConnPolicy policy = RTT::ConnPolicy::buffer(4);
    policy.buffer_policy = RTT::Shared;
    policy.name_id = "fingerprints";
    PortInterface &out = writer("first"), &alike = reader("same"), &other = reader("renamed", "other");
    ASSERT_TRUE(out.connectTo(&alike, policy));
    LogCapture log;
    EXPECT_FALSE(other.createConnection(out.getSharedConnection(), policy));
    expectText(log.text(), "port other.in cannot join shared connection 'fingerprints'");
    expectText(log.text(), "'y' in the connection, 'z' in the plugin of other.in");
}
