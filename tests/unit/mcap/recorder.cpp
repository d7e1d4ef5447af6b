// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A process that records as fast as 1 kHz until it is killed: recorder FILE COMPRESSION
#include <ocl/McapReporting.hpp>
#include <rtt/Activity.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>

#include <chrono>
#include <cstdio>
#include <dlfcn.h>
#include <thread>

namespace {

template <class T>
void set(RTT::TaskContext& component, const char* name, const T& value) {
    dynamic_cast<RTT::Property<T>&>(*component.getProperty(name)).set(value);
}

int record(const char* file, const char* compression) {
    RTT::TaskContext machine("Machine");
    RTT::OutputPort<double> speed("speed");
    RTT::OutputPort<std::vector<double>> levels("levels");
    machine.addPort(speed);
    machine.addPort(levels);
    OCL::McapReporting recorder("Recorder");
    recorder.addPeer(&machine);
    recorder.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.005));
    set<std::string>(recorder, "ReportFile", file);
    set<std::string>(recorder, "Compression", compression);
    set(recorder, "ChunkTime", 0.05);
    set(recorder, "ChunkSize", 20000U);
    if (!recorder.reportComponent("Machine") || !recorder.start()) return 1;
    std::puts("ready");
    std::fflush(stdout);
    for (int i = 0;; ++i) {
        speed.write(i);
        levels.write(std::vector<double>(50, i));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace

int main(int count, char** words) {
    if (count != 3 || __os_init(count, words) != 0) return 2;
    void* const typekit = dlopen(RTT_TYPEKIT_FILE, RTLD_NOW);
    if (!typekit) return 3;
    if (!reinterpret_cast<bool (*)(RTT::TaskContext*)>(dlsym(typekit, "loadRTTPlugin"))(nullptr)) return 3;
    return record(words[1], words[2]);
}
