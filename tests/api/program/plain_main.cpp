// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A program that knows nothing of ORO_main: components on the stack, on the heap and in static memory.
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>

using namespace Orocos;

static RTT::TaskContext early("early");

/** As tests do that start the runtime by hand. */
static bool startsByHand(int argc, char** argv) {
    bool fine = __os_init(argc, argv) == 0 && __os_main_argv()[0] == argv[0];
    {
        Orocos::TaskContext task("task");
        fine = fine && task.start() && task.stop();
    }
    __os_exit();
    return fine;
}

int main(int argc, char** argv) {
    RTT::TaskContext stack("stack");
    RTT::TaskContext* heap = new RTT::TaskContext("heap", RTT::TaskContext::PreOperational);
    bool fine = stack.start() && !heap->start() && heap->configure() && heap->start();
    fine = fine && stack.connectPeers(heap) && early.addPeer(heap) && early.getPeer("heap") == heap;
    fine = fine && stack.isRunning() && heap->stop() && stack.stop();
    delete heap;
    return fine && !early.hasPeer("heap") && startsByHand(argc, argv) ? 0 : 1;
}
