// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_TASK_CONTEXT_SERVER_HPP
#define ORO_CORBA_TASK_CONTEXT_SERVER_HPP

#include <rtt/os/threads.hpp>
#include <rtt/transports/corba/ApplicationServer.hpp>
#include <rtt/transports/corba/TaskContextC.h>

#include <boost/shared_ptr.hpp>

#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace RTT {
class Service;
class TaskContext;
namespace corba {
namespace detail {
class ServedComponent;
boost::shared_ptr<Service> servedService(CORBA::Object_ptr reference);
TaskContext* servedComponent(CTaskContext_ptr reference);
CService_ptr serve(Service& service);
}  // namespace detail

/**
 * Lets other processes use a component of this one. Any thread may call these functions; they block, and log errors.
 * A component may be destroyed before its server: calls from other processes then fail.
 */
class RTT_API TaskContextServer : public ApplicationServer {
public:
    ~TaskContextServer();
    TaskContextServer(const TaskContextServer&) = delete;
    TaskContextServer& operator=(const TaskContextServer&) = delete;

    /**
     * The server of a component, made if there is none; null if there is no ORB. `use_naming` registers it in the
     * naming service under its name or `alias`, also if it has another name there already. Without a naming service,
     * or if that is not used, the reference is written to the standard error output and to the file NAME.ior, unless
     * `require_name_service`: then this fails.
     */
    static TaskContextServer* Create(TaskContext* tc, bool use_naming = true, bool require_name_service = false);
    static TaskContextServer* Create(TaskContext* tc, const std::string& alias, bool use_naming = true,
                                     bool require_name_service = false);
    /** The reference of a component, or that which a proxy has; the caller owns it. Nil if there is none. Writes no
        file. */
    static CTaskContext_ptr CreateServer(TaskContext* tc, bool use_naming = true, bool require_name_service = false);
    static CTaskContext_ptr CreateServer(TaskContext* tc, const std::string& alias, bool use_naming = true,
                                         bool require_name_service = false);

    static void CleanupServer(TaskContext* tc);
    static void CleanupServers();

    /** Blocks until EndRun() or ShutdownOrb() is called, or, if `endsOn` is not negative, until that file descriptor
        can be read. Calls of other processes are served with or without it, from InitOrb() to ShutdownOrb(). */
    static void RunOrb(int endsOn = -1);
    /** Lets RunOrb() return, as the operation "shutdown" of each component with a server does. */
    static void EndRun();
    /** Calls RunOrb() in a thread of its own, "OrbRunner", with the real-time scheduler and the lowest priority, or
        with those given. Properties OrbRunnerScheduler, OrbRunnerPriority and OrbRunnerCpuAffinity of
        types::GlobalsRepository count for more. Those that exist when InitOrb() is called count for all threads by
        which the ORB serves calls, too. */
    static void ThreadOrb();
    static void ThreadOrb(int scheduler, int priority = os::LowestPriority, unsigned cpu_affinity = 0);
    /** Takes the components out of the naming service and ends the ORB; with `wait`, blocks until calls in progress
        have ended. */
    static void ShutdownOrb(bool wait = true);
    static void DestroyOrb();

    /** The reference as a text; empty if the component has no server. */
    static std::string getIOR(TaskContext* tc);

    /** Borrowed. */
    CTaskContext_ptr server() const { return reference_.in(); }

private:
    struct Servers;
    friend struct Servers;
    friend boost::shared_ptr<Service> detail::servedService(CORBA::Object_ptr reference);
    friend TaskContext* detail::servedComponent(CTaskContext_ptr reference);
    friend CService_ptr detail::serve(Service& service);
    explicit TaskContextServer(TaskContext& component);
    static Servers& servers();
    static std::shared_ptr<TaskContextServer> find(TaskContext& component);
    static std::shared_ptr<TaskContextServer> make(TaskContext* tc, const std::string& alias, bool use_naming,
                                                   bool require, bool emits);
    bool bind(const std::string& name, bool use_naming, bool require, bool emits);
    void remember(const std::string& name);
    void unbind();
    void emit(const std::string& name) const;

    const std::shared_ptr<detail::ServedComponent> served_;
    CTaskContext_var reference_;
    std::mutex mutex_;             // guards bound_
    std::set<std::string> bound_;  // names in the naming service
};

}  // namespace corba
}  // namespace RTT

#endif
