// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replay_record.hpp"

#include "../deployment/replaced.hpp"
#include "../schedule/schedule.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/Property.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/deployment/ComponentLoader.hpp>

#include <vector>

namespace OCL::deploy {
namespace {

constexpr char kName[] = "replay.recorder";  // no component of a file has such a name

template <class T>
void set(RTT::TaskContext& component, const char* name, const T& value) {
    if (auto* const property = dynamic_cast<RTT::Property<T>*>(component.getProperty(name))) property->set(value);
}

/** The paths of the output ports, "service.port" for those of services. */
void addOutputs(const RTT::Service& service, const std::string& prefix, std::vector<std::string>& paths) {
    for (RTT::base::PortInterface* const port : const_cast<RTT::Service&>(service).getPorts())
        if (port->asOutput()) paths.push_back(prefix + port->getName());
    for (const std::string& name : service.getProviderNames()) {
        const RTT::Service::shared_ptr inner = const_cast<RTT::Service&>(service).getService(name);
        if (inner) addOutputs(*inner, prefix + name + ".", paths);
    }
}

}  // namespace

ReplayRecord::ReplayRecord(const std::string& file, DeploymentComponent& deployer, schedule::Schedule& schedule,
                           std::string& error) {
    const RTT::ComponentLoader::shared_ptr loader = RTT::ComponentLoader::Instance();
    std::string why;
    (void)loader->importInstalled("ocl", why);
    recorder_ = loader->loadComponent(kName, "OCL::McapReporting", why);
    if (!recorder_) {
        error = "--record cannot record: " + why;
        return;
    }
    set<std::string>(*recorder_, "ReportFile", file);
    set<std::string>(*recorder_, "Clock", "component");
    set<bool>(*recorder_, "Reproducible", true);
    RTT::OperationCaller<bool(std::string, std::string)> report(recorder_->getOperation("reportPort"));
    for (const std::string& name : deployer.getPeerList()) {
        RTT::TaskContext* const peer = deployer.getPeer(name);
        if (!peer || peer->getName() != name || isStandIn(*peer)) continue;
        (void)recorder_->addPeer(peer);
        std::vector<std::string> ports;
        addOutputs(*peer->provides(), "", ports);
        for (const std::string& port : ports) (void)report(name, port);
    }
    schedule.executeLast(*recorder_);
    if (!recorder_->configure() || !recorder_->start()) error = "--record cannot record; the log says why";
}

ReplayRecord::~ReplayRecord() {
    if (!recorder_) return;
    (void)finish();
    (void)recorder_->cleanup();
    recorder_->disconnect();
    (void)RTT::ComponentLoader::Instance()->unloadComponent(recorder_);
}

bool ReplayRecord::finish() {
    if (!recorder_->isRunning()) return recorder_->getTaskState() == RTT::TaskContext::Stopped;
    const bool stopped = recorder_->stop();
    const auto* const lost = dynamic_cast<RTT::Attribute<unsigned long>*>(recorder_->getAttribute("LostRows"));
    return stopped && !(lost && lost->get() != 0);
}

}  // namespace OCL::deploy
