// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_TASK_CONTEXT_PROXY_HPP
#define ORO_CORBA_TASK_CONTEXT_PROXY_HPP

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/transports/corba/TaskContextC.h>

#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace RTT {
namespace corba {
namespace detail {
class RemotePeer;
class Watch;
}  // namespace detail

/** No proxy can be made. */
struct RTT_API IllegalServer : public std::exception {
    std::string reason;
    IllegalServer() = default;
    explicit IllegalServer(std::string why) : reason(std::move(why)) {}
    ~IllegalServer() override;
    const char* what() const noexcept override { return reason.c_str(); }
};

/**
 * A component of another process. Everything that is done with it is done there: its functions call the other process
 * and block for that; those that only ask something, for three seconds at most. A thread asks once a second whether
 * the other process answers. As long as it does not, functions return false, and operations throw std::runtime_error,
 * at once; the first failure is logged. When a component of that name answers again, also one of a process that was
 * started anew, the proxy stands for it, and ports that were connected with its ports are connected again.
 *
 * Any thread may make and find proxies while others destroy some: Create(), CreateFromFile() and getPeer() give no
 * proxy whose destructor has begun, and of two threads that ask for a component at once both get the same one. They say
 * nothing of the time after they returned: whoever destroys a proxy has to know that no other thread still uses a
 * pointer to it that it got before.
 */
class RTT_API TaskContextProxy : public TaskContext, public ApplicationServer {
public:
    /** Blocks while another thread makes out that it needs this proxy, within Create() or getPeer(), for three seconds
        at most. */
    ~TaskContextProxy() override;

    /** The component of that name in the naming service, or, with `is_ior`, that of a reference "IOR:…". Null, with an
        error logged, if there is none. */
    static TaskContextProxy* Create(std::string name, bool is_ior = false);
    /** By the reference that is the first word of a file. */
    static TaskContextProxy* CreateFromFile(std::string filename);
    /** The component itself if it is in this process and `force_remote` is false. */
    static TaskContext* Create(CTaskContext_ptr task, bool force_remote = false);
    static void DestroyOrb();

    /** Borrowed. Valid as long as the proxy. */
    CTaskContext_ptr server() const;
    static PortableServer::POA_ptr ProxyPOA() { return rootPOA.in(); }
    /** Adds to the interface what the other component has by now. False if it does not answer. */
    bool synchronize();

    bool configure() override;
    bool start() override;
    bool activate() override;
    bool stop() override;
    bool recover() override;
    bool cleanup() override;
    bool isActive() const override;
    bool isRunning() const override;
    bool isConfigured() const override;
    bool inFatalError() const override;
    bool inRunTimeError() const override;
    bool inException() const override;
    /** Init if the other process does not answer. */
    TaskState getTaskState() const override;
    TaskState getTargetState() const override { return getTaskState(); }
    /** The other process answers. Asks it, and looks for it again if it does not. */
    bool ready() override;

    bool addPeer(TaskContext* peer, std::string alias = "") override;
    void removePeer(const std::string& name) override;
    void removePeer(TaskContext* peer) override;
    bool connectPeers(TaskContext* peer) override;
    void disconnectPeers(const std::string& name) override;
    PeerList getPeerList() const override;
    bool hasPeer(const std::string& name) const override;
    /** A proxy of the peer. */
    TaskContext* getPeer(const std::string& name) const override;
    bool connectPorts(TaskContext* peer) override;
    bool connectServices(TaskContext* peer) override;

protected:
    /** These throw IllegalServer. */
    TaskContextProxy(std::string location, bool is_ior);
    explicit TaskContextProxy(CTaskContext_ptr task);
    TaskContextProxy();
    void initFromURIOrTaskname(std::string location, bool is_ior);
    /** The file has the reference of the component also after it was started again. */
    void followFile(const std::string& file);
    /** From now on Create() and getPeer() do not give it any more; blocks as the destructor does, which does the same.
        The destructor of a derived class that has members of its own calls it first. */
    void withdraw();

private:
    class Made;
    static TaskContextProxy* of(CTaskContext_ptr task, const std::string& file);
    static TaskContextProxy* ofLocation(const std::string& location, bool is_ior, const std::string& file);
    void begin(CTaskContext_ptr task);
    void setServer(CTaskContext_ptr task);
    CTaskContext_var limited() const;
    template <class Result, class Call>
    Result ask(Result otherwise, Call call) const;
    /** For questions that are answered at once. */
    template <class Result, class Call>
    Result askBriefly(Result otherwise, Call call) const;
    template <class Result, class Call>
    Result askBy(const CTaskContext_var& reference, Result otherwise, Call call) const;
    CTaskContext_var referenceOf(TaskContext* peer) const;
    void check();
    bool answers();
    bool findAgain();

    mutable std::mutex mutex_;               // guards the next two
    std::vector<CTaskContext_var> servers_;  // the last is valid; server() has lent the others
    CTaskContext_var limited_;
    std::recursive_mutex checkMutex_;  // one check at a time; guards ports_, callers_ and isLossKnown_
    bool isLossKnown_ = false;         // to the ports
    std::string location_, file_;      // location_: the name in the naming service
    std::shared_ptr<detail::RemotePeer> remote_;
    std::vector<std::unique_ptr<base::PortInterface>> ports_;
    std::vector<std::unique_ptr<base::OperationCallerBaseInvoker>> callers_;
    std::unique_ptr<detail::Watch> watch_;
};

}  // namespace corba
}  // namespace RTT

#endif
