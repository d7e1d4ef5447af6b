// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "probe.hpp"

#include <rtt/OutputPort.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/dotted_name.hpp>

#include <algorithm>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::Probe;

namespace {

class DottedName : public testing::Test {
protected:
    DottedName() {
        c.addPeer(&peer);
        peer.addPeer(&c, "back");
        c.provides("gauge")->provides("inner");
    }
    ~DottedName() override { GlobalService::Instance()->removeService("world"); }

    Service::shared_ptr service(const std::string& path) { return resolve(c, path).target.service; }

    Probe c{"c"}, peer{"peer"};
};

TEST_F(DottedName, PartsAndTheLastOne) {
    EXPECT_EQ(partsOf("a.b.c"), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(partsOf("a."), (std::vector<std::string>{"a"}));
    EXPECT_EQ(partsOf(".a"), (std::vector<std::string>{"", "a"}));
    EXPECT_TRUE(partsOf("").empty());
    EXPECT_EQ(splitAtLastDot("a.b.c"), std::make_pair(std::string("a.b"), std::string("c")));
    EXPECT_EQ(splitAtLastDot("a"), std::make_pair(std::string(), std::string("a")));
}

TEST_F(DottedName, LeadsThroughPeersAndServices) {
    EXPECT_EQ(&c, resolve(c, "").target.component);
    EXPECT_EQ("c", resolve(c, "this").target.name);
    EXPECT_EQ(&peer, resolve(c, "peer").target.component);
    EXPECT_EQ(&c, resolve(c, "this.peer.back").target.component);
    EXPECT_EQ("back", resolve(c, "peer.back").target.name);
    const ResolvedName inner = resolve(c, "gauge.inner");
    EXPECT_EQ(nullptr, inner.target.component);
    EXPECT_EQ(c.provides("gauge")->getService("inner"), inner.target.service);
}

TEST_F(DottedName, APeerComesBeforeAServiceAndBehindAServiceThereAreNoPeers) {
    c.provides("peer");
    EXPECT_EQ(&peer, resolve(c, "peer").target.component);
    EXPECT_EQ(c.provides("peer"), resolve(*c.provides(), "peer").target.service);
    c.provides("gauge")->provides("peer");
    EXPECT_EQ(nullptr, resolve(c, "gauge.peer").target.component);
}

TEST_F(DottedName, WhatOnlyTheFirstPartMayMean) {
    GlobalService::Instance()->provides("world");
    EXPECT_EQ(c.provides(), service("task"));
    EXPECT_EQ(c.provides(), service("c"));
    EXPECT_EQ(GlobalService::Instance(), service("GlobalService"));
    EXPECT_EQ(GlobalService::Instance()->getService("world"), service("world"));
    for (const char* path : {"peer.task", "peer.peer", "peer.world", "gauge.GlobalService"})
        EXPECT_FALSE(service(path)) << path;
    const Service::shared_ptr own = c.provides("c");
    EXPECT_EQ(own, service("c")) << "a service of the component's name";
    c.provides("task");
    EXPECT_EQ(c.provides(), service("task")) << "comes before everything else";
}

TEST_F(DottedName, TellsTheFirstUnknownPart) {
    const ResolvedName wrong = resolve(c, "peer.bock.x");
    EXPECT_FALSE(wrong.target.service);
    EXPECT_EQ("bock", wrong.wrong);
    EXPECT_EQ(5u, wrong.wrongAt);
    EXPECT_TRUE(std::count(wrong.known.begin(), wrong.known.end(), "back"));
    EXPECT_EQ((std::vector<std::string>{"inner"}), resolve(c, "gauge.iner").known);
}

TEST_F(DottedName, TheLongestNameOfAPortIsMeant) {
    OutputPort<int> dotted, inner, deep;
    c.addPort("gauge.level", dotted);
    c.provides("gauge")->addPort("level", inner);
    c.provides("gauge")->addPort("inner.level", deep);
    Service& own = *c.provides();
    EXPECT_EQ(&dotted, findPort(own, "gauge.level"));
    EXPECT_EQ(&deep, findPort(own, "gauge.inner.level"));
    EXPECT_EQ(&inner, findPort(*c.provides("gauge"), "level"));
    for (const char* path : {"", "gauge", "gauge.", "gauge.no", "no.level", "peer.level"})
        EXPECT_EQ(nullptr, findPort(own, path)) << path;
    c.ports()->removePort("gauge.level");
    EXPECT_EQ(&inner, findPort(own, "gauge.level"));
}

}  // namespace
