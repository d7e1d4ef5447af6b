// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Event ports that end, or are many, while a write is telling their components. What hangs here runs into the time limit.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/ConnID.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace RTT;
using internal::Reclaimer;

namespace {

typedef std::function<void()> Action;

/** True if this thread is within a Reclaimer::Guard, while no other thread is. */
bool withinGuard() {
    static std::atomic<bool> destroyed[1000];
    static std::atomic<unsigned> used{0};
    std::atomic<bool>& mine = destroyed[used++ % 1000];
    mine = false;
    Reclaimer::retire(&mine, [](void* flag) { *static_cast<std::atomic<bool>*>(flag) = true; });
    Reclaimer::collect();
    return !mine;
}

/** Is executed by whoever writes to its ports. */
struct Sequential : TaskContext {
    explicit Sequential(const std::string& name = "c") : TaskContext(name) {
        setActivity(new extras::SequentialActivity);
        start();
    }
    ~Sequential() override { stop(); }
    void listen(base::InputPortInterface& port, Action action) {
        addEventPort(port, [this, action](base::PortInterface*) {
            ++calls;
            if (action) action();
        });
    }
    std::atomic<int> calls{0};
};

/** One output port, and two event ports of one component that it tells of each sample, `first` before `second`. */
struct PortSignals : testing::Test {
    void connect(Action whenFirst) {
        c.listen(first, whenFirst);
        c.listen(*second, Action());
        ASSERT_TRUE(out.createConnection(first));
        ASSERT_TRUE(out.createConnection(*second));
    }
    Sequential c;
    InputPort<int> first{"first"};
    std::unique_ptr<InputPort<int>> second{new InputPort<int>("second")};
    OutputPort<int> out{"out"};
};

}  // namespace

TEST_F(PortSignals, ACallbackRemovesAPortThatTheSameWriteIsAboutToTell) {
    connect([this] { c.ports()->removePort("second"); });
    out.write(1);
    EXPECT_EQ(c.calls, 1);
    EXPECT_FALSE(second->connected());
}

TEST_F(PortSignals, ACallbackDestroysAPortThatTheSameWriteIsAboutToTell) {
    connect([this] { second.reset(); });
    out.write(1);
    EXPECT_EQ(c.calls, 1);
    out.write(2);
    EXPECT_EQ(c.calls, 2);
}

TEST_F(PortSignals, ACallbackWritesAndThenDestroysAPortThatBothWritesTell) {
    connect([this] {
        if (c.calls < 3) out.write(2);
        second.reset();
    });
    out.write(1);
    EXPECT_FALSE(second);
}

TEST_F(PortSignals, AComponentWithTwoPortsDestroysItself) {
    struct Mortal : Sequential {
        Mortal() {
            addEventPort(a, [this](base::PortInterface*) { delete this; });
            addEventPort(b);
        }
        InputPort<int> a{"a"}, b{"b"};
    };
    auto* const mortal = new Mortal;
    ASSERT_TRUE(out.createConnection(mortal->a));
    ASSERT_TRUE(out.createConnection(mortal->b));
    out.write(1);
    EXPECT_FALSE(out.connected());
}

TEST_F(PortSignals, AnElementRemovesAPortThatTheSameWriteHasSignalled) {
    struct Removing : base::ChannelElement<int> {
        explicit Removing(TaskContext& component) : c(component) {}
        WriteStatus write(param_t) override {
            c.ports()->removePort("first");
            return WriteSuccess;
        }
        TaskContext& c;
    };
    c.listen(first, Action());
    ASSERT_TRUE(out.createConnection(first));
    ASSERT_TRUE(out.addConnection(new internal::StreamConnID("x"), new Removing(c), ConnPolicy::data()));
    out.write(1);
    EXPECT_EQ(c.calls, 0);
    EXPECT_EQ(c.ports()->getPort("first"), nullptr);
}

// Each of two threads is told of one port, in whose callback it destroys the port that the other one is telling; and the
// other way round the port that the other one is only about to tell.
TEST_F(PortSignals, TwoThreadsDestroyPortsThatTheOtherOneTells) {
    for (const bool delivered : {true, false}) {
        std::unique_ptr<InputPort<int>> ports[2][2];
        std::vector<std::unique_ptr<Sequential>> components;
        OutputPort<int> outs[2];
        std::atomic<int> within{0};
        for (int i : {0, 1})
            for (int k : {0, 1}) {
                ports[i][k].reset(new InputPort<int>("in"));
                components.emplace_back(new Sequential);
                components.back()->listen(*ports[i][k], [&, i, k] {
                    if (k != 0) return;
                    ++within;
                    while (within != 2) std::this_thread::yield();
                    ports[1 - i][delivered ? 0 : 1].reset();
                });
                ASSERT_TRUE(outs[i].createConnection(*ports[i][k]));
            }
        std::thread other([&] { outs[1].write(1); });
        outs[0].write(1);
        other.join();
        for (int i : {0, 1}) EXPECT_FALSE(ports[i][delivered ? 0 : 1]);
    }
}

// The callback calls an operation of the component that waits for the callback's return.
TEST_F(PortSignals, AComponentThatEndsAPortExecutesMessagesMeanwhile) {
    TaskContext owner("owner");
    std::atomic<bool> removing{false}, served{false}, ended{false};
    owner.addOperation(
        "serve", [&] { served = true; }, OwnThread);
    owner.addOperation(
        "end",
        [&] {
            removing = true;
            first.disconnect();
            c.ports()->removePort("first");
            ended = true;
        },
        OwnThread);
    OperationCaller<void()> serve(owner.getOperation("serve"), c.engine());
    OperationCaller<void()> end(owner.getOperation("end"));
    c.listen(first, [&] {
        end.send();
        while (!removing) std::this_thread::yield();
        serve();
    });
    ASSERT_TRUE(out.createConnection(first));
    std::thread writer([&] { out.write(1); });
    writer.join();
    EXPECT_TRUE(served);
    while (!ended) std::this_thread::yield();
}

TEST_F(PortSignals, NoneOfManyComponentsIsToldWithinTheGuardOfTheWrite) {
    std::vector<std::unique_ptr<Sequential>> components;
    std::vector<std::unique_ptr<InputPort<int>>> ports;
    std::atomic<int> within{0};
    for (int i = 0; i != 40; ++i) {
        components.emplace_back(new Sequential);
        ports.emplace_back(new InputPort<int>("in"));
        components.back()->listen(*ports.back(), [&] { within += withinGuard(); });
        ASSERT_TRUE(out.createConnection(*ports.back()));
    }
    for (int n = 1; n != 3; ++n) {
        out.write(n);
        for (const auto& one : components) EXPECT_EQ(one->calls, n);
    }
    EXPECT_EQ(within, 0);
}

// While another thread stands still in the first of its signals, and has yet to give the others.
TEST_F(PortSignals, NoneOfManyIsToldWithinTheGuardWhileAnotherThreadTellsThemToo) {
    std::vector<std::unique_ptr<Sequential>> components;
    std::vector<std::unique_ptr<InputPort<int>>> ports;
    OutputPort<int> other("other");
    std::atomic<int> within{0}, last[40];
    std::promise<void> stands, go;
    Sequential standing;
    InputPort<int> stop("stop");
    standing.listen(stop, [&] {
        stands.set_value();
        go.get_future().wait();
    });
    ASSERT_TRUE(other.createConnection(stop));
    for (int i = 0; i != 40; ++i) {
        components.emplace_back(new Sequential);
        ports.emplace_back(new InputPort<int>("in", ConnPolicy::data()));
        InputPort<int>& in = *ports.back();
        std::atomic<int>& seen = last[i];
        seen = 0;
        components.back()->listen(in, [&] {
            within += withinGuard();
            int got = 0;
            while (in.read(got) == NewData) seen = std::max<int>(seen, got);
        });
        ASSERT_TRUE(other.createConnection(in));
        ASSERT_TRUE(out.createConnection(in));
    }
    std::thread teller([&] { other.write(1); });
    stands.get_future().wait();
    out.write(2);
    go.set_value();
    teller.join();
    for (const std::atomic<int>& seen : last) EXPECT_EQ(seen, 2);
    EXPECT_EQ(within, 0);
}

namespace {

/** A sample that looks, while it is copied, whether a port may be destroyed meanwhile. */
struct Looking {
    Looking() = default;
    Looking(const Looking&) {}
    Looking& operator=(const Looking&) {
        within = withinGuard();
        return *this;
    }
    static bool within;
};
bool Looking::within = false;

}  // namespace

TEST_F(PortSignals, ADataSourceKeepsItsPortWhileItAsksIt) {
    OutputPort<Looking> port("port");
    port.write(Looking());
    const base::DataSourceBase::shared_ptr source(port.getDataSource());
    Looking::within = false;
    EXPECT_TRUE(source->evaluate());
    EXPECT_TRUE(Looking::within);
}

namespace {

/** Counts how often somebody asks whether to wake it. */
struct Asked : TaskContext {
    Asked() : TaskContext("asked") { addEventPort(in); }
    bool dataOnPortHook(base::PortInterface*) override { return ++asked, false; }
    int takeAsked() {
        const int n = asked;
        asked = 0;
        return n;
    }
    InputPort<int> in{"in"};
    int asked = 0;
};

ConnPolicy withInit(int owner) {
    ConnPolicy policy = ConnPolicy::buffer(4);
    policy.buffer_policy = owner;
    policy.init = true;
    return policy;
}

}  // namespace

TEST_F(PortSignals, AnInitialValueIsSignalledOnceByEachWriter) {
    Asked reader;
    OutputPort<int> writers[2];
    for (OutputPort<int>& writer : writers) {
        writer.write(1);
        ASSERT_TRUE(writer.createConnection(reader.in, withInit(PerInputPort)));
        EXPECT_EQ(reader.takeAsked(), 1);
    }
}

TEST_F(PortSignals, AnInitialValueIsSignalledToTheNewReaderOfASharedBufferOnly) {
    for (const int owner : {int(PerOutputPort), int(Shared)}) {
        Asked readers[2];
        OutputPort<int> writer("writer");
        writer.write(1);
        for (Asked& reader : readers) {
            ASSERT_TRUE(writer.createConnection(reader.in, withInit(owner)));
            EXPECT_EQ(reader.takeAsked(), owner == PerOutputPort || &reader == &readers[0]) << owner;
        }
        EXPECT_EQ(readers[0].takeAsked(), 0);
    }
}

TEST_F(PortSignals, AnInitialValueOfASecondWriterOfASharedConnectionIsSignalledOnce) {
    Asked readers[2];
    OutputPort<int> writers[2];
    for (OutputPort<int>& writer : writers) writer.write(1);
    ASSERT_TRUE(writers[0].createConnection(readers[0].in, withInit(Shared)));
    const auto shared = writers[0].getSharedConnection();
    ASSERT_TRUE(readers[1].in.createConnection(shared));
    for (Asked& reader : readers) reader.takeAsked();
    ASSERT_TRUE(writers[1].createConnection(shared, withInit(Shared)));
    for (Asked& reader : readers) EXPECT_EQ(reader.takeAsked(), 1);
}
