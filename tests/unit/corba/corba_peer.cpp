// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The other process of corba_process_test.cpp: one component, whose reference it prints.
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/main.h>
#include <rtt/transports/corba/TaskContextServer.hpp>

#include <atomic>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace RTT;

namespace {

class Peer : public TaskContext {
public:
    Peer() : TaskContext("peer", PreOperational) {
        addPort("in", in).doc("Samples come back from here.");
        addEventPort("echo", echo, [this](base::PortInterface*) {
            double sample = 0;
            while (echo.read(sample) == NewData) {
                out.write(2 * sample);
                tripled.write(3 * sample);
            }
        });
        addPort("out", out);
        addPort("tripled", tripled);
        addProperty("gain", gain).doc("A number.");
        addProperty("label", label);
        inner.ownProperty(new Property<double>("limit", "Within a bag.", 7));
        bag.set(inner);
        addProperty("settings", bag);
        addAttribute("level", level);
        addConstant("pi", 3.5);
        addOperation("add", &Peer::add, this).doc("Adds.").arg("a", "The first.").arg("b", "The second.");
        addOperation("own", &Peer::own, this, OwnThread);
        addOperation("change", &Peer::change, this, OwnThread);
        addOperation("fail", &Peer::fail, this, OwnThread);
        addOperation("nothing", &Peer::nothing, this, OwnThread);
        addOperation("count", &Peer::count, this);
        addOperation("sum", &Peer::sum, this);
        provides("sub")->addOperation("twice", &Peer::twice, this);
        provides("sub")->provides("deep")->addOperation("thrice", &Peer::thrice, this);
        provides("other")->addOperation("twice", &Peer::twice, this);
        requires_("wish")->addOperationCaller(wished);
        addOperation("callWished", &Peer::callWished, this, OwnThread);
        addOperation("callBack", &Peer::callBack, this, ClientThread);
    }
    ~Peer() override { stopForGood(); }

private:
    int add(int a, int b) { return a + b; }
    std::string own(const std::string& text) { return text + (engine()->isSelf() ? " own" : " other"); }
    int change(double& number, std::string& text) {
        number *= 2;
        text += "!";
        return 5;
    }
    void fail() { throw std::runtime_error("on purpose"); }
    void nothing() { ++calls_; }
    int count() { return calls_; }
    double sum(const std::vector<double>& numbers) {
        double all = 0;
        for (const double one : numbers) all += one;
        return all;
    }
    int twice(int a) { return 2 * a; }
    int thrice(int a) { return 3 * a; }
    int callWished(int a) { return wished.ready() ? wished(a) : -1; }

    /** Has a peer add from several threads at once, and tells how many results are right. */
    int callBack(const std::string& name, int threads, int count) {
        TaskContext* const other = getPeer(name);
        if (!other) return -1;
        std::atomic<int> right{0};
        std::vector<std::thread> all;
        for (int t = 0; t != threads; ++t)
            all.emplace_back([&, t] {
                OperationCaller<int(int, int)> there(other->getOperation("add"));
                for (int i = 0; i != count; ++i) right += there(i, t) == i + t;
            });
        for (std::thread& one : all) one.join();
        return right;
    }

    InputPort<double> in, echo;
    OutputPort<double> out, tripled;
    double gain = 1.5, level = 0.5;
    std::string label = "first";
    PropertyBag inner;
    Property<PropertyBag> bag{"settings", "A bag."};
    OperationCaller<int(int)> wished{"wished"};
    int calls_ = 0;
};

}  // namespace

int ORO_main(int argc, char** argv) {
    if (!corba::TaskContextServer::InitOrb(argc, argv)) return 1;
    Peer peer;
    TaskContext friendly("friendly");
    peer.addPeer(&friendly);
    if (!corba::TaskContextServer::Create(&peer, false)) return 1;
    std::cout << "reference " << corba::TaskContextServer::getIOR(&peer) << std::endl;
    corba::TaskContextServer::RunOrb();
    corba::TaskContextServer::DestroyOrb();
    std::cout << "ended" << std::endl;
    return 0;
}
