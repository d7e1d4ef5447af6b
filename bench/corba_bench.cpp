// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of another process by CORBA, against calls of omniORB's stubs with the same values; and what a connection with
// another process costs the thread that writes.
#include "pairs.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/transports/corba/DataFlowC.h>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>
#include <rtt/types/Types.hpp>

#include <csignal>
#include <ctime>
#include <memory>
#include <string>

#include <sys/prctl.h>
#include <unistd.h>

namespace {

using namespace RTT;
using corba::TaskContextServer;

constexpr int kCalls = 200;
constexpr int kWrites = 2000;

void beginCorba() {
    plugin::PluginLoader::Instance()->loadTypekit("rtt-typekit");
    char name[] = "bench";
    char* words[] = {name, nullptr};
    (void)TaskContextServer::InitOrb(1, words);
}

/** Answers as plain programs of omniORB do. */
class Plain final : public POA_RTT::corba::CChannelElement {
public:
    CORBA::Boolean inputReady() override { return true; }
    CORBA::Boolean channelReady(const corba::CConnPolicy&) override { return true; }
    corba::CFlowStatus read(CORBA::Any_OUT_arg sample, CORBA::Boolean) override {
        sample = new CORBA::Any();
        *sample <<= CORBA::Double(1.5);
        return corba::CNewData;
    }
    corba::CWriteStatus write(const CORBA::Any&) override { return corba::CWriteSuccess; }
    void writeOneway(const CORBA::Any&) override {}
    void disconnect() override {}
};

class Served : public TaskContext {
public:
    Served() : TaskContext("served") {
        addOperation("half", &Served::half, this);
        addPort("in", in_);
    }

private:
    double half(double value) { return value / 2; }
    InputPort<double> in_;
};

/** The other process, made before this one has threads. Its references come through a pipe. */
class Other {
public:
    Other() {
        int ends[2];
        if (pipe(ends) != 0) std::abort();
        child_ = fork();
        if (child_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);  // it would wait for ever
            serve(ends[1]);
        }
        close(ends[1]);
        FILE* const text = fdopen(ends[0], "r");
        char word[4096];
        for (std::string* one : {&component, &plain})
            if (std::fscanf(text, "%4095s", word) == 1) *one = word;
        std::fclose(text);
    }
    ~Other() { kill(child_, SIGKILL); }

    std::string component, plain;

private:
    [[noreturn]] static void serve(int out) {
        beginCorba();
        static Served served;
        TaskContextServer::CreateServer(&served, false);
        static Plain plain;
        const CORBA::Object_var reference = plain._this();
        const CORBA::String_var text = TaskContextServer::orb->object_to_string(reference);
        const std::string both = TaskContextServer::getIOR(&served) + "\n" + text.in() + "\n";
        if (write(out, both.data(), both.size()) < 0) _exit(1);
        close(out);
        pause();
        _exit(0);
    }
    pid_t child_;
};

struct Connected {
    Connected() {
        beginCorba();
        proxy.reset(corba::TaskContextProxy::Create(other.component, true));
        const CORBA::Object_var object = TaskContextServer::orb->string_to_object(other.plain.c_str());
        plain = corba::CChannelElement::_narrow(object);
    }
    double plainCall() const {
        return bench::timed(CLOCK_MONOTONIC,
                            [this] {
                                for (int i = 0; i != kCalls; ++i) {
                                    CORBA::Any_var any;
                                    (void)plain->read(any.out(), true);
                                    benchmark::DoNotOptimize(any.in());
                                }
                            }) /
               kCalls;
    }
    Other other;
    std::unique_ptr<corba::TaskContextProxy> proxy;
    corba::CChannelElement_var plain;
};

Connected& connected() {
    static auto* const made = new Connected();
    return *made;
}

double callOf(OperationCaller<double(double)>& half) {
    return bench::timed(CLOCK_MONOTONIC,
                        [&half] {
                            for (int i = 0; i != kCalls; ++i) benchmark::DoNotOptimize(half(3.0));
                        }) /
           kCalls;
}

void call(benchmark::State& state) {
    OperationCaller<double(double)> half(connected().proxy->getOperation("half"));
    bench::inPairs(
        state, 1.3, [&] { return callOf(half); }, [] { return connected().plainCall(); });
}
BENCHMARK(call)->Iterations(bench::kPairs)->UseManualTime();

/** In the thread of a component, which executes its messages meanwhile. */
void callOfAComponent(benchmark::State& state) {
    struct Caller : TaskContext {
        Caller() : TaskContext("caller"), half(connected().proxy->getOperation("half"), engine()) {
            addOperation("run", &Caller::run, this, OwnThread);
        }
        ~Caller() override { stopForGood(); }
        double run() { return callOf(half); }
        OperationCaller<double(double)> half;
    } caller;
    OperationCaller<double()> run(caller.getOperation("run"), internal::GlobalEngine::Instance());
    bench::inPairs(
        state, 1.3, [&] { return run(); }, [] { return connected().plainCall(); });
}
BENCHMARK(callOfAComponent)->Iterations(bench::kPairs)->UseManualTime();

/** The time of the thread that writes; the floor is a microsecond. */
void writeToAnotherProcess(benchmark::State& state) {
    TaskContext here("here");
    OutputPort<double> out("out");
    here.addPort(out);
    if (!out.connectTo(connected().proxy->getPort("in"), ConnPolicy::data()))
        return state.SkipWithError("not connected");
    const auto writes = [&] {
        return bench::timed(CLOCK_THREAD_CPUTIME_ID,
                            [&] {
                                for (int i = 0; i != kWrites; ++i) out.write(i);
                            }) /
               kWrites;
    };
    bench::inPairs(state, 1.0, writes, [] { return 1e-6; });
}
BENCHMARK(writeToAnotherProcess)->Iterations(bench::kPairs)->UseManualTime();

/** The process that answers is made before main(), which has threads. */
[[maybe_unused]] const Connected& early = connected();

}  // namespace
