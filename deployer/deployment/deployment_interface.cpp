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

template <class Member>
auto& offer(Self& deployer, const char* name, Member member, const char* what) {
    return deployer.addOperation(name, member, &deployer, ClientThread).doc(what);
}

void addLibraryOperations(Self& deployer) {
    offer(deployer, "import", &Self::import, "Imports a component package, directory or library.")
        .arg("Package", "Name, directory or file");
    offer(deployer, "path", &Self::path, "Adds directories to the search path and imports what is in them.")
        .arg("Paths", "Directories, separated by colons or semicolons");
    offer(deployer, "loadLibrary", &Self::loadLibrary, "Loads one plugin, typekit or component library.")
        .arg("Name", "File");
    offer(deployer, "reloadLibrary", &Self::reloadLibrary, "Loads a component library again.").arg("FilePath", "File");
    offer(deployer, "displayComponentTypes", &Self::displayComponentTypes,
          "Writes the known component types to standard output.");
    offer(deployer, "getComponentTypes", &Self::getComponentTypes, "The known component types.");
}

void addComponentOperations(Self& deployer) {
    offer(deployer, "loadComponent", &Self::loadComponent, "Creates a component.")
        .arg("Name", "Its name")
        .arg("Type", "Its type");
    offer(deployer, "unloadComponent", &Self::unloadComponent, "Deletes a component loaded by this deployer.")
        .arg("Name", "Component");
    offer(deployer, "loadService", twoTexts(&Self::loadService), "Loads a service into a component.")
        .arg("Name", "Component")
        .arg("Service", "Service or plugin");
    offer(deployer, "configureComponent", &Self::configureComponent, "Configures a component.")
        .arg("Name", "Component");
    offer(deployer, "startComponent", &Self::startComponent, "Starts a component.").arg("Name", "Component");
    offer(deployer, "stopComponent", &Self::stopComponent, "Stops a component.").arg("Name", "Component");
}

void addFileOperations(Self& deployer) {
    offer(deployer, "loadComponents", &Self::loadComponents, "Loads what an XML file describes.").arg("File", "File");
    offer(deployer, "loadConfiguration", &Self::loadConfiguration, "Loads what an XML file describes.")
        .arg("File", "File");
    offer(deployer, "loadConfigurationString", &Self::loadConfigurationString, "Loads what an XML text describes.")
        .arg("Text", "Text");
    offer(deployer, "clearConfiguration", &Self::clearConfiguration, "Forgets what files described; components stay.");
    offer(deployer, "configureComponents", &Self::configureComponents,
          "Connects and configures the components of all files.");
    offer(deployer, "startComponents", &Self::startComponents, "Starts the AutoStart components of all files.");
    offer(deployer, "stopComponents", &Self::stopComponents, "Stops all loaded components.");
    offer(deployer, "cleanupComponents", &Self::cleanupComponents, "Cleans up all loaded components.");
    offer(deployer, "unloadComponents", &Self::unloadComponents, "Deletes all loaded components.");
    offer(deployer, "kickStart", text(&Self::kickStart), "Loads, configures and starts an XML file.")
        .arg("File", "File");
    offer(deployer, "kickOutAll", &Self::kickOutAll, "Stops, cleans up and deletes all loaded components.");
    offer(deployer, "kickOutComponent", &Self::kickOutComponent, "Stops, cleans up and deletes a component.")
        .arg("comp_name", "Component");
    offer(deployer, "kickOut", &Self::kickOut, "Stops, cleans up and deletes the components of an XML file.")
        .arg("File", "File");
    offer(deployer, "runScript", &Self::runScript, "Runs a script.").arg("File", "File");
    offer(deployer, "waitForInterrupt", &Self::waitForInterrupt, "Waits for SIGINT, SIGTERM or SIGHUP.");
    offer(deployer, "waitForSignal", &Self::waitForSignal, "Waits for a signal.").arg("signal number", "Its number");
}

void addWiringOperations(Self& deployer) {
    offer(deployer, "connectPeers", twoTexts(&Self::connectPeers), "Makes two components peers of each other.")
        .arg("One", "Component")
        .arg("Two", "Component");
    offer(deployer, "addPeer", twoTexts(&Self::addPeer), "Makes one component a peer of another.")
        .arg("From", "Component")
        .arg("To", "Its new peer");
    offer(deployer, "aliasPeer", &Self::aliasPeer, "Makes one component a peer of another under another name.")
        .arg("From", "Component")
        .arg("To", "Its new peer")
        .arg("Alias", "Name of the peer");
    offer(deployer, "removePeer", static_cast<void (Self::*)(const std::string&)>(&Self::removePeer),
          "Removes a peer of this deployer.")
        .arg("PeerName", "Peer");
    offer(deployer, "connectPorts", twoTexts(&Self::connectPorts), "Connects all ports of the same name.")
        .arg("One", "Component")
        .arg("Two", "Component");
    offer(deployer, "connectTwoPorts", &Self::connectTwoPorts, "Connects two ports.")
        .arg("One", "Component")
        .arg("PortOne", "Its port")
        .arg("Two", "Component")
        .arg("PortTwo", "Its port");
    offer(deployer, "connect", &Self::connect, "Connects two ports.")
        .arg("portOne", "component.port")
        .arg("portTwo", "component.port")
        .arg("policy", "How");
    offer(deployer, "stream", &Self::stream, "Connects a port to a stream.")
        .arg("port", "component.port")
        .arg("policy", "Which and how");
    offer(deployer, "createStream", &Self::createStream, "Connects a port to a stream.")
        .arg("component", "Component")
        .arg("port", "Its port")
        .arg("policy", "Which and how");
    offer(deployer, "connectServices", twoTexts(&Self::connectServices),
          "Connects the services two components require and provide.")
        .arg("One", "Component")
        .arg("Two", "Component");
    offer(deployer, "connectOperations", twoTexts(&Self::connectOperations),
          "Connects an operation that a component requires to one that is provided.")
        .arg("Requested", "component.service.operation")
        .arg("Provided", "component.service.operation");
}

void addActivityOperations(Self& deployer) {
    offer(deployer, "setActivity",
          static_cast<bool (Self::*)(const std::string&, double, int, int)>(&Self::setActivity),
          "Gives a component a thread of its own.")
        .arg("CompName", "Component")
        .arg("Period", "Seconds; 0: not periodic")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER");
    offer(deployer, "setActivityOnCPU", &Self::setActivityOnCPU, "Gives a component a thread of its own on one CPU.")
        .arg("CompName", "Component")
        .arg("Period", "Seconds; 0: not periodic")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER")
        .arg("CPU", "Number of the CPU");
    offer(deployer, "setPeriodicActivity", &Self::setPeriodicActivity,
          "Lets a component run in the thread shared by all of this period and priority.")
        .arg("CompName", "Component")
        .arg("Period", "Seconds")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER");
    offer(deployer, "setFileDescriptorActivity", &Self::setFileDescriptorActivity,
          "Gives a component a thread that waits for file descriptors.")
        .arg("CompName", "Component")
        .arg("Timeout", "Milliseconds; 0: none")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER");
    offer(deployer, "setSequentialActivity", &Self::setSequentialActivity,
          "Lets a component run in the threads of its callers.")
        .arg("CompName", "Component");
    offer(deployer, "setSlaveActivity", &Self::setSlaveActivity,
          "Lets a component run when another calls its update().")
        .arg("CompName", "Component")
        .arg("Period", "Seconds");
    offer(deployer, "setMasterSlaveActivity", &Self::setMasterSlaveActivity,
          "Lets a component run in the thread of another.")
        .arg("Master", "Component that runs")
        .arg("Slave", "Component that is run");
    offer(deployer, "chain", &Self::chain, "Makes a chain, which executes its members in their order in one thread.")
        .arg("Name", "The chain")
        .arg("Period", "Seconds; 0: not periodic")
        .arg("Priority", "Priority")
        .arg("SchedType", "ORO_SCHED_RT or ORO_SCHED_OTHER")
        .arg("Members", "Components in their order, as strings(\"a\", \"b\")");
    offer(deployer, "setWaitPeriodPolicy", &Self::setWaitPeriodPolicy,
          "Chooses how the thread of a component waits for its period.")
        .arg("CompName", "Component")
        .arg("Policy", "ORO_WAIT_ABS or ORO_WAIT_REL");
}

}  // namespace

void DeploymentComponent::addDeploymentInterface() {
    deploy::addTypes();
    impl_->target = OROCOS_TARGET_NAME;
    impl_->session.waitPeriodPolicy = ORO_WAIT_ABS;
    addProperty("RTT_COMPONENT_PATH", impl_->componentPath)
        .doc("Search path of component packages; empty: that of the environment.");
    addProperty("DefaultWaitPeriodPolicy", impl_->session.waitPeriodPolicy)
        .doc("How threads of new activities wait: ORO_WAIT_ABS or ORO_WAIT_REL.");
    addProperty("AutoUnload", impl_->autoUnload)
        .doc("Stop, clean up and unload all components when the deployer ends.");
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
