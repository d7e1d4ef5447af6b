// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that call each other: in whose thread an operation runs, calls and sends, results and exceptions, services
// and requesters, signals.
#include <rtt/RTT.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/os/main.h>

#include <iostream>
#include <stdexcept>

using namespace RTT;

namespace {

const char* yesOrNo(bool answer) { return answer ? "yes" : "no"; }

/** Moves one axis. What touches its state runs in its own thread; what does not, in that of the caller. */
class Axis : public TaskContext {
public:
    explicit Axis(const std::string& name) : TaskContext(name), arrived("arrived") {
        addEventOperation(arrived.signals().doc("Called after each move.").arg("position", "in m"));
        addOperation("move", &Axis::move, this, OwnThread).doc("Moves to a position.").arg("position", "in m, 0 to 1");
        addOperation("where", &Axis::where, this, OwnThread).doc("Where it is.").arg("position", "in m");
        addOperation(
            "inOwnThread", [this] { return engine()->isSelf(); }, OwnThread);
        addOperation(
            "inCallersThread", [this] { return !engine()->isSelf(); }, ClientThread);
        provides("limits")->addOperation("maximum", [] { return 1.0; }).doc("The largest position, in m.");
        arrive_ = getOperation("arrived");
    }
    ~Axis() override { stopForGood(); }

    Operation<void(double)> arrived;  // only a signal

private:
    double move(double position) {
        if (position < 0 || position > 1) throw std::out_of_range("position " + std::to_string(position));
        const double way = position - position_;
        position_ = position;
        arrive_(position);
        return way;
    }
    void where(double& position) { position = position_; }

    double position_ = 0;
    OperationCaller<void(double)> arrive_;
};

/** Says what it needs from others; who provides it is decided from outside. */
class Planner : public TaskContext {
public:
    explicit Planner(const std::string& name) : TaskContext(name), move_("move"), maximum_("maximum") {
        requires()->addOperationCaller(move_);
        requires("limits")->addOperationCaller(maximum_);
        addOperation("plan", &Planner::plan, this, OwnThread);
    }
    ~Planner() override { stopForGood(); }

private:
    double plan() { return move_(maximum_()); }

    OperationCaller<double(double)> move_;
    OperationCaller<double()> maximum_;
};

void callAndSend(Axis& axis) {
    // Callers outside of components name an engine, too: that of the process.
    ExecutionEngine* const self = internal::GlobalEngine::Instance();
    OperationCaller<bool()> own(axis.getOperation("inOwnThread"), self);
    OperationCaller<bool()> client(axis.getOperation("inCallersThread"), self);
    std::cout << "OwnThread runs in the component: " << yesOrNo(own()) << "\n";
    std::cout << "ClientThread runs in the caller: " << yesOrNo(client()) << "\n";

    OperationCaller<double(double)> move(axis.getOperation("move"), self);
    OperationCaller<void(double&)> where(axis.getOperation("where"), self);
    SendHandle<double(double)> sent = move.send(0.75);  // goes on at once
    double way = 0, position = 0;
    if (sent.collect(way) == SendSuccess) std::cout << "moved by " << way << "\n";
    where(position);
    std::cout << "now at " << position << "\n";
}

/** Called without a result type and with an int: both are converted. */
void otherTypes(Axis& axis) {
    OperationCaller<void(int)> move(axis.getOperation("move"), internal::GlobalEngine::Instance());
    std::cout << "can be called with an int: " << yesOrNo(move.ready()) << "\n";
    move(0);
    OperationCaller<void(TaskContext*)> wrong(axis.getOperation("move"), internal::GlobalEngine::Instance());
    std::cout << "can be called with a component: " << yesOrNo(wrong.ready()) << "\n";
}

/** Whoever is connected is called in the thread that calls the operation. */
void signals(Axis& axis) {
    OperationCaller<double(double)> move(axis.getOperation("move"), internal::GlobalEngine::Instance());
    double heard = -1;
    {
        ScopedHandle handle(axis.arrived.signals([&heard](double position) { heard = position; }));
        move(0.25);
    }
    std::cout << "heard of " << heard << "\n";
    move(0.5);
    std::cout << "and no more: " << heard << "\n";
}

void services(Axis& axis, Planner& planner) {
    std::cout << "planner is complete: " << yesOrNo(planner.requires()->ready() && planner.requires("limits")->ready())
              << "\n";
    std::cout << "connected: " << yesOrNo(planner.connectServices(&axis)) << "\n";
    OperationCaller<double()> plan(planner.getOperation("plan"), internal::GlobalEngine::Instance());
    std::cout << "planned a way of " << plan() << "\n";
}

void exceptions(Axis& axis) {
    OperationCaller<double(double)> move(axis.getOperation("move"), internal::GlobalEngine::Instance());
    try {
        move(2);
    } catch (const std::runtime_error& error) {
        std::cout << "the caller gets: " << error.what() << "\n";
    }
    std::cout << "the component is in Exception: " << yesOrNo(axis.inException()) << "\n";
    std::cout << "it can be used again: " << yesOrNo(axis.recover() && axis.start()) << "\n";
}

}  // namespace

int ORO_main(int, char**) {
    Logger::Instance()->setLogLevel(Logger::Never);  // what is logged carries the time
    Axis axis("axis");
    Planner planner("planner");
    axis.start();
    planner.start();
    callAndSend(axis);
    otherTypes(axis);
    signals(axis);
    services(axis, planner);
    exceptions(axis);
    return 0;
}
