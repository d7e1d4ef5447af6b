// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The properties, attributes and operations that the deployer offers to scripts and consoles.
#include "deployment_parts.hpp"
#include "types.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/Operation.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/threads.hpp>

namespace OCL {

namespace {

using Self = DeploymentComponent;
using RTT::ClientThread;

// Scripts see only the C++ overloads that take names of components.
auto text(bool (Self::*member)(const std::string&)) { return member; }
auto twoTexts(bool (Self::*member)(const std::string&, const std::string&)) { return member; }

void addLibraryOperations(Self& deployer) {
    deployer.addOperation("import", &Self::import, &deployer, ClientThread)
        .doc("Imports a component package, directory or library")
        .arg("Package", "Name, directory or file");
    deployer.addOperation("path", &Self::path, &deployer, ClientThread)
        .doc("Adds directories to the search path and imports what lies in them")
        .arg("Paths", "Directories, separated by colons or semicolons");
    deployer.addOperation("loadLibrary", &Self::loadLibrary, &deployer, ClientThread)
        .doc("Loads one plugin, typekit or component library")
        .arg("Name", "File");
    deployer.addOperation("reloadLibrary", &Self::reloadLibrary, &deployer, ClientThread)
        .doc("Loads a component library anew")
        .arg("FilePath", "File");
    deployer.addOperation("displayComponentTypes", &Self::displayComponentTypes, &deployer, ClientThread)
        .doc("Writes the known component types to standard output");
    deployer.addOperation("getComponentTypes", &Self::getComponentTypes, &deployer, ClientThread)
        .doc("The known component types");
}

void addComponentOperations(Self& deployer) {
    deployer.addOperation("loadComponent", &Self::loadComponent, &deployer, ClientThread)
        .doc("Creates a component")
        .arg("Name", "Its name")
        .arg("Type", "Its type");
    deployer.addOperation("unloadComponent", &Self::unloadComponent, &deployer, ClientThread)
        .doc("Deletes a component loaded by this deployer")
        .arg("Name", "Component");
    deployer.addOperation("loadService", twoTexts(&Self::loadService), &deployer, ClientThread)
        .doc("Loads a service into a component")
        .arg("Name", "Component")
        .arg("Service", "Service or plugin");
    deployer.addOperation("configureComponent", &Self::configureComponent, &deployer, ClientThread)
        .doc("Configures a component")
        .arg("Name", "Component");
    deployer.addOperation("startComponent", &Self::startComponent, &deployer, ClientThread)
        .doc("Starts a component")
        .arg("Name", "Component");
    deployer.addOperation("stopComponent", &Self::stopComponent, &deployer, ClientThread)
        .doc("Stops a component")
        .arg("Name", "Component");
}

void addFileOperations(Self& deployer) {
    deployer.addOperation("loadComponents", &Self::loadComponents, &deployer, ClientThread)
        .doc("Loads what an XML file describes")
        .arg("File", "File");
    deployer.addOperation("loadConfiguration", &Self::loadConfiguration, &deployer, ClientThread)
        .doc("Loads what an XML file describes")
        .arg("File", "File");
    deployer.addOperation("loadConfigurationString", &Self::loadConfigurationString, &deployer, ClientThread)
        .doc("Loads what an XML text describes")
        .arg("Text", "Text");
    deployer.addOperation("clearConfiguration", &Self::clearConfiguration, &deployer, ClientThread)
        .doc("Forgets what files said; components stay");
    deployer.addOperation("configureComponents", &Self::configureComponents, &deployer, ClientThread)
        .doc("Connects and configures the components of all files");
    deployer.addOperation("startComponents", &Self::startComponents, &deployer, ClientThread)
        .doc("Starts the AutoStart components of all files");
    deployer.addOperation("stopComponents", &Self::stopComponents, &deployer, ClientThread)
        .doc("Stops all loaded components");
    deployer.addOperation("cleanupComponents", &Self::cleanupComponents, &deployer, ClientThread)
        .doc("Cleans up all loaded components");
    deployer.addOperation("unloadComponents", &Self::unloadComponents, &deployer, ClientThread)
        .doc("Deletes all loaded components");
    deployer.addOperation("kickStart", text(&Self::kickStart), &deployer, ClientThread)
        .doc("Loads, configures and starts an XML file")
        .arg("File", "File");
    deployer.addOperation("kickOutAll", &Self::kickOutAll, &deployer, ClientThread)
        .doc("Stops, cleans up and deletes all loaded components");
    deployer.addOperation("kickOutComponent", &Self::kickOutComponent, &deployer, ClientThread)
        .doc("Stops, cleans up and deletes a component")
        .arg("comp_name", "Component");
    deployer.addOperation("kickOut", &Self::kickOut, &deployer, ClientThread)
        .doc("Stops, cleans up and deletes the components of an XML file")
        .arg("File", "File");
    deployer.addOperation("runScript", &Self::runScript, &deployer, ClientThread)
        .doc("Runs a script")
        .arg("File", "File");
    deployer.addOperation("waitForInterrupt", &Self::waitForInterrupt, &deployer, ClientThread)
        .doc("Waits for SIGINT, SIGTERM or SIGHUP");
    deployer.addOperation("waitForSignal", &Self::waitForSignal, &deployer, ClientThread)
        .doc("Waits for a signal")
        .arg("signal number", "Its number");
}

void addWiringOperations(Self& deployer) {
    deployer.addOperation("connectPeers", twoTexts(&Self::connectPeers), &deployer, ClientThread)
        .doc("Makes two components peers of each other")
        .arg("One", "Component")
        .arg("Two", "Component");
    deployer.addOperation("addPeer", twoTexts(&Self::addPeer), &deployer, ClientThread)
        .doc("Makes one component a peer of another")
        .arg("From", "Component")
        .arg("To", "Its new peer");
    deployer.addOperation("aliasPeer", &Self::aliasPeer, &deployer, ClientThread)
        .doc("Makes one component a peer of another under another name")
        .arg("From", "Component")
        .arg("To", "Its new peer")
        .arg("Alias", "Name of the peer");
    deployer
        .addOperation("removePeer", static_cast<void (Self::*)(const std::string&)>(&Self::removePeer), &deployer,
                      ClientThread)
        .doc("Removes a peer of this deployer")
        .arg("PeerName", "Peer");
    deployer.addOperation("connectPorts", twoTexts(&Self::connectPorts), &deployer, ClientThread)
        .doc("Connects all ports of the same name")
        .arg("One", "Component")
        .arg("Two", "Component");
    deployer.addOperation("connectTwoPorts", &Self::connectTwoPorts, &deployer, ClientThread)
        .doc("Connects two ports")
        .arg("One", "Component")
        .arg("PortOne", "Its port")
        .arg("Two", "Component")
        .arg("PortTwo", "Its port");
    deployer.addOperation("connect", &Self::connect, &deployer, ClientThread)
        .doc("Connects two ports")
        .arg("portOne", "component.port")
        .arg("portTwo", "component.port")
        .arg("policy", "How");
    deployer.addOperation("stream", &Self::stream, &deployer, ClientThread)
        .doc("Connects a port to a stream")
        .arg("port", "component.port")
        .arg("policy", "Which and how");
    deployer.addOperation("createStream", &Self::createStream, &deployer, ClientThread)
        .doc("Connects a port to a stream")
        .arg("component", "Component")
        .arg("port", "Its port")
        .arg("policy", "Which and how");
    deployer.addOperation("connectServices", twoTexts(&Self::connectServices), &deployer, ClientThread)
        .doc("Connects the services two components require and provide")
        .arg("One", "Component")
        .arg("Two", "Component");
    deployer.addOperation("connectOperations", twoTexts(&Self::connectOperations), &deployer, ClientThread)
        .doc("Connects an operation that a component requires to one that is provided")
        .arg("Requested", "component.service.operation")
        .arg("Provided", "component.service.operation");
}

void addActivityOperations(Self& deployer) {
    deployer
        .addOperation("setActivity",
                      static_cast<bool (Self::*)(const std::string&, double, int, int)>(&Self::setActivity), &deployer,
                      ClientThread)
        .doc("Gives a component a thread of its own")
        .arg("CompName", "Component")
        .arg("Period", "Seconds; 0: not periodic")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER");
    deployer.addOperation("setActivityOnCPU", &Self::setActivityOnCPU, &deployer, ClientThread)
        .doc("Gives a component a thread of its own on one CPU")
        .arg("CompName", "Component")
        .arg("Period", "Seconds; 0: not periodic")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER")
        .arg("CPU", "Number of the CPU");
    deployer.addOperation("setPeriodicActivity", &Self::setPeriodicActivity, &deployer, ClientThread)
        .doc("Has a component run in a thread shared by all of this period and priority")
        .arg("CompName", "Component")
        .arg("Period", "Seconds")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER");
    deployer.addOperation("setFileDescriptorActivity", &Self::setFileDescriptorActivity, &deployer, ClientThread)
        .doc("Gives a component a thread that waits for file descriptors")
        .arg("CompName", "Component")
        .arg("Timeout", "Milliseconds; 0: none")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER");
    deployer.addOperation("setSequentialActivity", &Self::setSequentialActivity, &deployer, ClientThread)
        .doc("Has a component run in the threads of its callers")
        .arg("CompName", "Component");
    deployer.addOperation("setSlaveActivity", &Self::setSlaveActivity, &deployer, ClientThread)
        .doc("Has a component run when another calls its update()")
        .arg("CompName", "Component")
        .arg("Period", "Seconds");
    deployer.addOperation("setMasterSlaveActivity", &Self::setMasterSlaveActivity, &deployer, ClientThread)
        .doc("Has a component run in the thread of another")
        .arg("Master", "Component that runs")
        .arg("Slave", "Component that is run");
    deployer.addOperation("setWaitPeriodPolicy", &Self::setWaitPeriodPolicy, &deployer, ClientThread)
        .doc("How a component's thread waits for its period")
        .arg("CompName", "Component")
        .arg("Policy", "ORO_WAIT_ABS or ORO_WAIT_REL");
}

}  // namespace

void DeploymentComponent::addDeploymentInterface() {
    deploy::addTypes();
    impl_->target = OROCOS_TARGET_NAME;
    impl_->session.waitPeriodPolicy = ORO_WAIT_ABS;
    addProperty("RTT_COMPONENT_PATH", impl_->componentPath)
        .doc("Search path of component packages; empty: that of the environment");
    addProperty("DefaultWaitPeriodPolicy", impl_->session.waitPeriodPolicy)
        .doc("How threads of new activities wait: ORO_WAIT_ABS or ORO_WAIT_REL");
    addProperty("AutoUnload", impl_->autoUnload).doc("Stop, clean up and unload all components when the deployer ends");
    addAttribute("Target", impl_->target);
    addAttribute("Valid", impl_->files.valid);
    // Constants that own their values: addConstant() would refer to temporaries.
    const std::pair<const char*, int> numbers[] = {{"ORO_SCHED_RT", ORO_SCHED_RT},
                                                   {"ORO_SCHED_OTHER", ORO_SCHED_OTHER},
                                                   {"LowestPriority", RTT::os::LowestPriority},
                                                   {"HighestPriority", RTT::os::HighestPriority}};
    for (const auto& [name, number] : numbers) provides()->setValue(new RTT::Constant<int>(name, number));

    // The inherited operation can load only into the deployer.
    provides()->removeOperation("loadService");
    addLibraryOperations(*this);
    addComponentOperations(*this);
    addFileOperations(*this);
    addWiringOperations(*this);
    addActivityOperations(*this);
}

}  // namespace OCL
