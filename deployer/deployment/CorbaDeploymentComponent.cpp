// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/CorbaDeploymentComponent.hpp>

#include <rtt/Logger.hpp>
#include <rtt/Operation.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>

#include <fstream>
#include <stdexcept>

namespace OCL {

namespace {

using RTT::corba::TaskContextProxy;
using RTT::corba::TaskContextServer;

/** One for each name that the deployer gives it, because the deployer deletes it. */
class Remote final : public TaskContextProxy {
public:
    Remote(const std::string& location, bool isReference, const std::string& file = std::string())
        : TaskContextProxy(location, isReference) {
        followFile(file);
    }
};

RTT::TaskContext* byName(std::string name) { return new Remote(name, false); }
RTT::TaskContext* byReference(std::string reference) { return new Remote(reference, true); }
RTT::TaskContext* byFile(std::string file) {
    std::string reference;
    if (!(std::ifstream(file) >> reference))
        throw std::runtime_error("the file '" + file + "' has no reference of a component");
    return new Remote(reference, true, file);
}

/** Before the deployer begins, because its site file may use them. */
const std::string& withTypes(const std::string& name) {
    const RTT::ComponentLoader::shared_ptr loader = RTT::ComponentLoader::Instance();
    loader->addFactory("CORBA", &byName);
    loader->addFactory("TaskContextProxy", &byName);
    loader->addFactory("IORFile", &byFile);
    loader->addFactory("IOR", &byReference);
    return name;
}

bool serve(RTT::TaskContext& component, bool useNamingService) {
    return TaskContextServer::Create(&component, useNamingService) != nullptr;
}

}  // namespace

CorbaDeploymentComponent::CorbaDeploymentComponent(const std::string& name, const std::string& siteFile,
                                                   Purpose purpose)
    : DeploymentComponent(withTypes(name), siteFile, purpose, &serve) {
    addOperation("server", &CorbaDeploymentComponent::createServer, this, RTT::ClientThread)
        .doc("Lets other processes use a component.")
        .arg("tc", "Component")
        .arg("UseNamingService", "Whether the naming service gets its name");
    addOperation("aliasServer", &CorbaDeploymentComponent::createServerAlias, this, RTT::ClientThread)
        .doc("Lets other processes use a component under another name.")
        .arg("tc", "Component")
        .arg("alias", "The other name")
        .arg("UseNamingService", "Whether the naming service gets it");
}

CorbaDeploymentComponent::~CorbaDeploymentComponent() {
    bool unloads = true;
    if (const auto* const wanted = dynamic_cast<const RTT::Property<bool>*>(properties()->find("AutoUnload")))
        unloads = wanted->rvalue();
    if (unloads) (void)kickOutAll();
    TaskContextServer::CleanupServer(this);
}

bool CorbaDeploymentComponent::createServer(const std::string& tc, bool use_naming) {
    return createServerAlias(tc, tc, use_naming);
}

bool CorbaDeploymentComponent::createServerAlias(const std::string& tc, const std::string& alias, bool use_naming) {
    RTT::TaskContext* const component = tc == getName() || tc == "this" ? this : getPeer(tc);
    if (!component) {
        RTT::log(RTT::Error) << "no server: there is no component '" << tc << "'" << RTT::endlog();
        return false;
    }
    if (alias.empty() || alias == "this") return serve(*component, use_naming);
    return TaskContextServer::Create(component, alias, use_naming) != nullptr;
}

void CorbaDeploymentComponent::componentUnloaded(RTT::TaskContext* component) {
    TaskContextServer::CleanupServer(component);
}

}  // namespace OCL
