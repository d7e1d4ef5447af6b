// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What every transport does, for every policy: one set of tests, to which a new transport adds its protocol.
#include "transport_fixture.hpp"

#include <rtt/TaskContext.hpp>
#if defined(WITH_CORBA)
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>
#endif

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

using namespace RTT;
using transport_test::readSoon;
using transport_test::soon;

namespace {

constexpr int kLocal = 0, kCorba = 1, kQueues = 2;
typedef std::tuple<int, int, bool, int> Parameters;  // protocol, kind of storage, pull, lock

class Writer : public TaskContext {
public:
    explicit Writer(const std::string& name) : TaskContext(name) {
        ports()->addPort("number", number);
        ports()->addPort("text", text);
    }
    OutputPort<double> number;
    OutputPort<std::string> text;
};

class Reader : public TaskContext {
public:
    explicit Reader(const std::string& name) : TaskContext(name) {
        ports()->addEventPort("number", number, [this](base::PortInterface*) { ++events; });
        ports()->addPort("text", text);
    }
    ~Reader() override { stop(); }
    InputPort<double> number;
    InputPort<std::string> text;
    std::atomic<int> events{0};
};

class Conformance : public testing::WithParamInterface<Parameters>, public transport_test::WithTypes {
protected:
    static constexpr int kSize = 8;

    ConnPolicy policy(bool init = false) const {
        ConnPolicy made = ConnPolicy::data(std::get<3>(GetParam()), init, std::get<2>(GetParam()));
        made.transport = std::get<0>(GetParam());
        made.type = kind();
        made.size = kind() == ConnPolicy::DATA ? 0 : kSize;
        return made;
    }
    static int kind() { return std::get<1>(GetParam()); }
    static int protocol() { return std::get<0>(GetParam()); }

    /** A port as a component of another process would see it, which only CORBA shows. */
    base::PortInterface* seen([[maybe_unused]] TaskContext& owner, base::PortInterface& port) {
#if defined(WITH_CORBA)
        if (protocol() == kCorba) return remote(owner).getPort(port.getName());
#endif
        return &port;
    }
    bool join(OutputPort<double>& from, Reader& to) { return from.connectTo(seen(to, to.number), policy()); }
    static bool endSoon(const base::PortInterface& one, const base::PortInterface& other) {
        return soon([&] { return !one.connected() && !other.connected(); });
    }

#if defined(WITH_CORBA)
    void SetUp() override {
        if (protocol() != kCorba) return;
        char name[] = "test";
        char* words[] = {name, nullptr};
        (void)corba::TaskContextServer::InitOrb(1, words);
    }
    void TearDown() override {
        proxies.clear();
        corba::TaskContextServer::CleanupServers();
    }
    TaskContext& remote(TaskContext& owner) {
        const corba::CTaskContext_var reference = corba::TaskContextServer::CreateServer(&owner, false);
        TaskContext* const made = corba::TaskContextProxy::Create(reference, /*force_remote=*/true);
        for (const auto& known : proxies)
            if (known.get() == made) return *made;
        proxies.emplace_back(made);
        return *made;
    }
    std::vector<std::unique_ptr<TaskContext>> proxies;
#endif

    Writer writer{"writer"};
    Reader reader{"reader"};
    double got = 0;
};

std::string nameOf(const testing::TestParamInfo<Parameters>& info) {
    const char* const kinds[] = {"data", "buffer", "circular"};
    const char* const locks[] = {"unsync", "locked", "lock_free"};
    const char* const protocols[] = {"local_", "corba_", "mqueue_"};
    return std::string(protocols[std::get<0>(info.param)]) + kinds[std::get<1>(info.param)] +
           (std::get<2>(info.param) ? "_pull_" : "_push_") + locks[std::get<3>(info.param)];
}

}  // namespace

TEST(Transports, AreLoadedWhenTheyAreFirstUsed) {
    const plugin::PluginLoader::shared_ptr loader = plugin::PluginLoader::Instance();
    loader->loadInstalled();
    ASSERT_TRUE(loader->isLoaded("rtt-typekit"));
    EXPECT_FALSE(loader->isLoaded("rtt-transport-mqueue"));
    EXPECT_FALSE(types::Types()->type("double")->hasProtocol(17));
    EXPECT_FALSE(loader->isLoaded("rtt-transport-mqueue"));
    EXPECT_TRUE(types::Types()->type("double")->hasProtocol(kQueues));
    EXPECT_TRUE(loader->isLoaded("rtt-transport-mqueue"));
    EXPECT_TRUE(types::Types()->type("string")->hasProtocol(kQueues));
}

TEST_P(Conformance, DeliversSamplesInTheirOrder) {
    ASSERT_TRUE(join(writer.number, reader));
    EXPECT_TRUE(writer.number.connected() && reader.number.connected());
    EXPECT_EQ(reader.number.read(got), NoData) << "the sample that sizes the connection is no data";
    for (int i = 1; i <= kSize; ++i) ASSERT_EQ(writer.number.write(i), WriteSuccess);
    if (kind() == ConnPolicy::DATA) {
        EXPECT_TRUE(soon([&] { return reader.number.read(got) != NoData && got == kSize; }));
    } else {
        for (int i = 1; i <= kSize; ++i) {
            ASSERT_TRUE(readSoon(reader.number, got)) << i;
            EXPECT_EQ(got, i);
        }
    }
    EXPECT_EQ(reader.number.read(got), OldData);
}

TEST_P(Conformance, DeliversTheLastSample) {
    ASSERT_TRUE(join(writer.number, reader));
    for (int i = 1; i <= 200; ++i) {
        EXPECT_EQ(writer.number.write(i), WriteSuccess);
        ASSERT_TRUE(soon([&] { return reader.number.read(got) == NewData && got == i; })) << i;
    }
}

TEST_P(Conformance, TakesTheLastWrittenValueIfThePolicySaysSo) {
    writer.number.write(7);
    ASSERT_TRUE(writer.number.connectTo(seen(reader, reader.number), policy(true)));
    ASSERT_TRUE(readSoon(reader.number, got));
    EXPECT_EQ(got, 7);
}

TEST_P(Conformance, KeepsTheNewestSamplesOfAnythingButABuffer) {
    ASSERT_TRUE(join(writer.number, reader));
    for (int i = 1; i <= 1000; ++i) (void)writer.number.write(i);
    double last = 0;
    if (kind() == ConnPolicy::BUFFER) {
        ASSERT_TRUE(readSoon(reader.number, got));
        EXPECT_EQ(got, 1);
    } else {
        EXPECT_TRUE(soon([&] {
            if (reader.number.read(got, false) == NewData) {
                EXPECT_GT(got, last);
                last = got;
            }
            return last == 1000;
        })) << last;
    }
}

TEST_P(Conformance, CarriesTexts) {
    ASSERT_TRUE(writer.text.connectTo(seen(reader, reader.text), policy()));
    std::string text;
    for (const std::string& sent : {std::string(), std::string("a"), std::string(500, 'x'), std::string("b\0c", 3)}) {
        if (protocol() == kCorba && sent.size() == 3) continue;  // its texts end at a zero
        ASSERT_EQ(writer.text.write(sent), WriteSuccess);
        ASSERT_TRUE(readSoon(reader.text, text));
        EXPECT_EQ(text, sent);
    }
}

TEST_P(Conformance, TriggersTheComponent) {
    ASSERT_TRUE(reader.start());
    ASSERT_TRUE(join(writer.number, reader));
    for (int i = 1; i <= 20; ++i) {
        const int before = reader.events;
        ASSERT_EQ(writer.number.write(i), WriteSuccess);
        ASSERT_TRUE(soon([&] { return reader.events > before; })) << i;
        ASSERT_TRUE(readSoon(reader.number, got));
    }
}

TEST_P(Conformance, EndsAtEitherSideAndBeginsAgain) {
    for (int round = 1; round <= 5; ++round) {
        ASSERT_TRUE(join(writer.number, reader));
        ASSERT_EQ(writer.number.write(round), WriteSuccess);
        ASSERT_TRUE(soon([&] { return reader.number.read(got) == NewData && got == round; })) << round;
        writer.number.disconnect();
        reader.number.disconnect();
        EXPECT_TRUE(endSoon(writer.number, reader.number));
        EXPECT_EQ(writer.number.write(round), NotConnected);
    }
}

TEST_P(Conformance, ConnectsTwoPortsOnce) {
    ASSERT_TRUE(join(writer.number, reader));
    ASSERT_TRUE(join(writer.number, reader));
    EXPECT_TRUE(writer.number.connectedTo(seen(reader, reader.number)));
    if (protocol() != kCorba) {
        EXPECT_TRUE(reader.number.connectedTo(&writer.number));
    }
    ASSERT_EQ(writer.number.write(3), WriteSuccess);
    ASSERT_TRUE(readSoon(reader.number, got));
    EXPECT_EQ(reader.number.read(got), OldData) << "it comes once";
    Reader other("other");
    ASSERT_TRUE(join(writer.number, other));
    EXPECT_TRUE(writer.number.disconnect(seen(reader, reader.number)));
    EXPECT_TRUE(soon([&] { return !reader.number.connected(); }));
    EXPECT_TRUE(writer.number.connected() && other.number.connected());
    if (protocol() == kCorba)
        other.number.disconnect();  // it does not know the name of the writer
    else
        EXPECT_TRUE(other.number.disconnect(&writer.number));
    EXPECT_TRUE(endSoon(writer.number, other.number));
}

TEST_P(Conformance, RefusesOtherTypes) {
    OutputPort<long long> other("other");
    writer.ports()->addPort(other);
    EXPECT_FALSE(other.connectTo(seen(reader, reader.number), policy()));
    EXPECT_FALSE(other.connected() || reader.number.connected());
}

TEST_P(Conformance, EndsWithEitherPort) {
    {
        Reader passing("passing");
        ASSERT_TRUE(join(writer.number, passing));
    }
    EXPECT_TRUE(soon([&] { return !writer.number.connected(); }));
    {
        Writer passing("passing");
        ASSERT_TRUE(join(passing.number, reader));
    }
    EXPECT_TRUE(soon([&] { return !reader.number.connected(); }));
}

TEST_P(Conformance, DoesNotMixConnections) {
    Reader other("other");
    ASSERT_TRUE(join(writer.number, reader));
    ASSERT_TRUE(join(writer.number, other));
    ASSERT_EQ(writer.number.write(3), WriteSuccess);
    ASSERT_TRUE(readSoon(reader.number, got));
    ASSERT_TRUE(readSoon(other.number, got));
    reader.number.disconnect();
    ASSERT_EQ(writer.number.write(4), WriteSuccess);
    ASSERT_TRUE(readSoon(other.number, got));
    EXPECT_EQ(got, 4);
}

#if defined(WITH_CORBA)
#define PROTOCOLS testing::Values(kLocal, kCorba, kQueues)
#else
#define PROTOCOLS testing::Values(kLocal, kQueues)
#endif
INSTANTIATE_TEST_SUITE_P(
    Transports, Conformance,
    testing::Combine(PROTOCOLS, testing::Values(ConnPolicy::DATA, ConnPolicy::BUFFER, ConnPolicy::CIRCULAR_BUFFER),
                     testing::Bool(), testing::Values(ConnPolicy::LOCKED, ConnPolicy::LOCK_FREE)),
    nameOf);
