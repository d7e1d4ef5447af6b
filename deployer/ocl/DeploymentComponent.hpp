// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_DEPLOYMENT_COMPONENT_HPP
#define ORO_DEPLOYMENT_COMPONENT_HPP

#include <ocl/OCL.hpp>
#include <rtt/Component.hpp>  // users get the macros from here
#include <rtt/TaskContext.hpp>
#include <rtt/rtt-config.h>

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
class ConnPolicy;
namespace base {
class PortInterface;
}
}  // namespace RTT

namespace OCL {

/**
 * A component that imports component libraries, creates components, connects, configures, starts and removes them,
 * either by single operations or as an XML file describes.
 *
 * A component is given by the name of one of the deployer's peers; the deployer itself by its own name or "this". Ports
 * and services are given by paths, `component[.service…].port`. The functions below are also operations of the same
 * names, executed in the calling thread. They are not real-time, may block, log failures and return false; errors in
 * files are also written to standard error with their places. Do not call them from several threads at once.
 */
class OCL_API DeploymentComponent : public RTT::TaskContext {
public:
    /** What the deployer does with files. */
    enum class Purpose {
        Deploy,
        Check,    ///< components are created but not started, neither by the deployer nor by scripts
        PlanOnly  ///< the site file is only checked, as by planOnly()
    };

    /**
     * @param name the name of this component
     * @param siteFile a file that is deployed at once; empty: `<name>-site.cpf`. If it does not exist, imports the
     *        component library `ocl` instead. Errors are logged; the constructor does not fail.
     */
    explicit DeploymentComponent(std::string name = "Deployer", std::string siteFile = std::string(),
                                 Purpose purpose = Purpose::Deploy);
    /** If the property AutoUnload is set, stops, cleans up and unloads everything that this component loaded. */
    ~DeploymentComponent() override;

    // --- libraries -------------------------------------------------------------------------------------------------
    /** Imports a package, directory or library file. @throw std::runtime_error if a library in it cannot be loaded. */
    bool import(const std::string& package);
    /** Adds directories to the search path and imports the libraries directly in them. */
    void path(const std::string& paths);
    /** Loads one plugin, typekit or component library file. */
    bool loadLibrary(const std::string& name);
    /** Unloads a component library, of which no components may exist, and loads it again. */
    bool reloadLibrary(const std::string& filepath);
    /** Writes the known component types to standard output. */
    void displayComponentTypes() const;
    std::vector<std::string> getComponentTypes() const;

    // --- single components -----------------------------------------------------------------------------------------
    /** Creates a component of an imported type and makes it a peer. */
    bool loadComponent(const std::string& name, const std::string& type);
    /** Deletes a component that this deployer loaded and that does not run. */
    bool unloadComponent(const std::string& name);
    /** Loads a service into a component; true also if it is loaded already. */
    bool loadService(const std::string& name, const std::string& service);
    bool configureComponent(const std::string& name);
    bool startComponent(const std::string& name);
    bool stopComponent(const std::string& name);
    bool cleanupComponent(const std::string& name);

    // --- files -----------------------------------------------------------------------------------------------------
    /** Reads a file, imports and creates what it says; undoes that if there is an error. */
    bool loadComponents(const std::string& file);
    bool loadConfiguration(const std::string& file) { return loadComponents(file); }
    /** As loadConfiguration, from a text. */
    bool loadConfigurationString(const std::string& text);
    /** Forgets what files say about components and connections; components stay. */
    void clearConfiguration();
    /** Connects and configures the components of all files, in order. */
    bool configureComponents();
    /** Starts the AutoStart components of all files, in order. */
    bool startComponents();
    bool stopComponents();
    bool cleanupComponents();
    bool unloadComponents();
    /** Loads, configures and starts a file; undoes all of it in reverse order if one step fails. */
    bool kickStart(const std::string& file);
    /** As kickStart, or without starting anything. */
    bool kickStart2(const std::string& file, bool start);
    /** Reads a file, does its imports and checks it, together with files that were checked so before; creates
        nothing. */
    bool planOnly(const std::string& file);
    /** What the files given to planOnly() describe: "3 components, 4 connections"; empty if there was none. */
    std::string planSummary() const;
    /**
     * Checks a script for this component, see rtt/scripting/check.hpp, and does the imports that the script will do.
     * With Purpose::Deploy, logs the diagnostics if there are errors; otherwise nothing, because running the script
     * reports the rest. With other purposes, creates the components that the script will create, to know their
     * operations, and writes the diagnostics to standard error.
     */
    bool checkScript(const std::string& file);
    /** Order, threads and data delays of all chains, a few lines for each; those of files given to planOnly() as far as
        files and libraries tell. */
    std::string chains() const;
    /** True if there is a site file and it has errors. */
    bool siteFileFailed() const;
    /** The components, connections and peers as a graph for Graphviz. */
    std::string graph() const;
    /** Stops, cleans up and unloads all components loaded by this deployer, the last created first. */
    bool kickOutAll();
    bool kickOutComponent(const std::string& name);
    /** Stops, cleans up and unloads the components that a file names. */
    void kickOut(const std::string& file);
    /** Runs a script in the deployer; needs the scripting service. */
    bool runScript(const std::string& file);
    /** Tells the component "Application" to end, and waits for it; called by programs before they end. */
    void shutdownDeployment();

    // --- waiting ---------------------------------------------------------------------------------------------------
    /** Blocks until SIGINT, SIGTERM or SIGHUP. */
    void waitForInterrupt();
    /** Blocks until the signal comes. False if it cannot be caught, or if a signal came that ends the program. */
    bool waitForSignal(int signal);

    // --- peers, ports, services ------------------------------------------------------------------------------------
    using RTT::TaskContext::connectPeers;
    using RTT::TaskContext::connectPorts;
    using RTT::TaskContext::connectServices;
    using RTT::TaskContext::loadService;
    using RTT::TaskContext::setActivity;
    bool connectPeers(const std::string& one, const std::string& two);
    /** False for a name with control characters or '/', which a deployer does not allow. */
    bool addPeer(RTT::TaskContext* peer, std::string alias = "") override;
    bool addPeer(const std::string& from, const std::string& to);
    bool aliasPeer(const std::string& from, const std::string& to, const std::string& alias);
    /** Connects the ports of two components that have the same names. */
    bool connectPorts(const std::string& one, const std::string& two);
    bool connectTwoPorts(const std::string& one, const std::string& portOne, const std::string& two,
                         const std::string& portTwo);
    /** Connects two ports, in any order. */
    bool connect(const std::string& portOne, const std::string& portTwo, RTT::ConnPolicy policy);
    /** Connects a port to a stream of the policy's transport. */
    bool stream(const std::string& port, RTT::ConnPolicy policy);
    bool createStream(const std::string& component, const std::string& port, RTT::ConnPolicy policy);
    bool connectServices(const std::string& one, const std::string& two);
    /** Connects an operation that a component requires, `component[.service...].operation`, to one that another
        component provides. False if it is connected already. */
    bool connectOperations(const std::string& requested, const std::string& provided);

    // --- activities: periods in seconds; the component must not run -------------------------------------------------
    bool setActivity(const std::string& name, double period, int priority, int scheduler);
    bool setActivityOnCPU(const std::string& name, double period, int priority, int scheduler, unsigned int cpu);
    bool setPeriodicActivity(const std::string& name, double period, int priority, int scheduler);
    /** Sets an activity that waits for file descriptors; `timeout` in milliseconds, 0 for none. */
    bool setFileDescriptorActivity(const std::string& name, double timeout, int priority, int scheduler);
    bool setSequentialActivity(const std::string& name);
    bool setSlaveActivity(const std::string& name, double period);
    bool setMasterSlaveActivity(const std::string& master, const std::string& slave);
    /**
     * Makes a chain (OCL::Chain) with a thread, and its members slaves of it, in that order. "*" stands for all other
     * slaves. If a component of that name is there already, which must be a chain, it gets the thread and the members.
     */
    bool chain(const std::string& name, double period, int priority, int scheduler,
               const std::vector<std::string>& members);
    /** Sets how the component's thread waits for its period: ORO_WAIT_ABS or ORO_WAIT_REL. */
    bool setWaitPeriodPolicy(const std::string& name, int policy);

    /** Fills or applies the property RTT_COMPONENT_PATH. */
    bool configureHook() override;

protected:
    /** Lets other processes use a component, by the naming service or without it. False, with an error logged, if that
        fails. */
    typedef std::function<bool(RTT::TaskContext& component, bool useNamingService)> Serve;
    /** For a deployer that can do that: `serve` is called for the element `Server` of files. */
    DeploymentComponent(std::string name, std::string siteFile, Purpose purpose, Serve serve);

    /** Called after a component was created. False refuses it; then it is deleted. */
    virtual bool componentLoaded(RTT::TaskContext* component);
    /** Called before a component is deleted. */
    virtual void componentUnloaded(RTT::TaskContext* component);

private:
    void addDeploymentInterface();

    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace OCL

#endif
