// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The other process of mqueue_process_test.cpp: `mqueue_peer write|read QUEUE`, samples are int. "write" writes 1, 2, 3, …
// every millisecond; "read" prints every hundredth.
#include <rtt/Port.hpp>
#include <rtt/os/main.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/transports/mqueue/MQLib.hpp>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>

namespace {

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

int write(const RTT::ConnPolicy& policy) {
    RTT::OutputPort<int> port("out");
    if (!port.createStream(policy)) return 1;
    std::cout << "ready" << std::endl;
    for (int i = 1;; ++i, pause()) port.write(i);
}

int read(const RTT::ConnPolicy& policy) {
    RTT::InputPort<int> port("in");
    if (!port.createStream(policy)) return 1;
    std::cout << "ready" << std::endl;
    int sample = 0, last = 0;
    for (int count = 0;; pause()) {
        while (port.read(sample, false) == RTT::NewData) {
            if (sample < last) std::cout << "the sender began anew" << std::endl;
            last = sample;
            if (++count % 100 == 0) std::cout << "received " << count << std::endl;
        }
    }
}

}  // namespace

int ORO_main(int argc, char** argv) {
    if (argc != 3) return 2;
    RTT::ConnPolicy policy = RTT::ConnPolicy::circularBuffer(10);
    policy.transport = ORO_MQUEUE_PROTOCOL_ID;
    policy.name_id = argv[2];
    return std::string(argv[1]) == "write" ? write(policy) : read(policy);
}
