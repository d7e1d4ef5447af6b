// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a sample meets on its way: storage that keeps the newest, a queue that fills, a queue that forgets, a late reader,
// a component that is woken, and a queue that two writers share.
#include <rtt/RTT.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/os/main.h>

#include <iostream>

using namespace RTT;

namespace {

/** Takes all that is in the port. */
void drain(const char* what, InputPort<int>& port) {
    std::cout << what << ":";
    int sample = 0;
    FlowStatus status = port.read(sample);
    if (status != NewData) std::cout << " " << status;
    for (; status == NewData; status = port.read(sample)) std::cout << " " << sample;
    std::cout << "\n";
}

void storages() {
    OutputPort<int> out("out");
    InputPort<int> newest("newest"), first("first"), last("last");
    out.createConnection(newest, ConnPolicy::data());
    out.createConnection(first, ConnPolicy::buffer(3));
    out.createConnection(last, ConnPolicy::circularBuffer(3));
    for (int i = 1; i <= 5; ++i) {
        const WriteStatus status = out.write(i);
        std::cout << "wrote " << i << ": " << status << "\n";
    }
    drain("data keeps the newest", newest);
    drain("a buffer refuses what does not fit", first);
    drain("a circular buffer forgets the oldest", last);
    drain("nothing new", newest);

    InputPort<int> late("late");
    ConnPolicy initialised = ConnPolicy::buffer(3);
    initialised.init = true;
    out.createConnection(late, initialised);
    drain("a late reader of an initialised connection", late);
}

/** Sums what arrives; runs in the thread of whoever writes to its port. */
class Sum : public TaskContext {
public:
    explicit Sum(const std::string& name) : TaskContext(name) {
        setActivity(new extras::SequentialActivity());
        addEventPort("in", in).doc("What is added.");
        addPort("out", out).doc("The sum so far.");
    }
    ~Sum() override { stopForGood(); }

    InputPort<int> in;
    OutputPort<int> out;

private:
    void updateHook() override {
        int sample = 0;
        while (in.read(sample) == NewData) out.write(sum_ += sample);
    }
    int sum_ = 0;
};

void eventPort() {
    Sum sum("sum");
    OutputPort<int> numbers("numbers");
    InputPort<int> sums("sums");
    numbers.createConnection(sum.in, ConnPolicy::buffer(10));
    sum.out.createConnection(sums, ConnPolicy::buffer(10));
    numbers.write(1);  // not running: the sample waits
    sum.start();
    for (int i = 2; i <= 4; ++i) numbers.write(i);
    drain("sums of a component that is woken by its port", sums);
}

void sharedQueue() {
    OutputPort<int> ones("ones"), tens("tens");
    InputPort<int> worker("worker"), other("other");
    ConnPolicy queue = ConnPolicy::buffer(10);
    queue.buffer_policy = Shared;
    queue.name_id = "jobs";
    for (OutputPort<int>* writer : {&ones, &tens}) writer->createConnection(worker, queue);
    ones.createConnection(other, queue);
    for (int i = 1; i <= 2; ++i) {
        ones.write(i);
        tens.write(10 * i);
    }
    int job = 0;
    worker.read(job);
    std::cout << "the worker took " << job << " from the shared queue\n";
    drain("the other one takes the rest", other);
}

}  // namespace

int ORO_main(int, char**) {
    storages();
    eventPort();
    sharedQueue();
    return 0;
}
