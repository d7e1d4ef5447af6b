// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An action server with one active and one pending goal.
#ifndef RTT_ACTIONLIB_RTT_SIMPLE_ACTION_SERVER_H
#define RTT_ACTIONLIB_RTT_SIMPLE_ACTION_SERVER_H

#include <rtt_actionlib/rtt_action_server.h>

#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace rtt_actionlib {

/**
 * A new goal is pending until it is accepted or rejected; the next one rejects it. Accepting it aborts the goal that is
 * active. Hooks are called in the component's thread, while it is running. Any thread may call the functions; those that
 * change or ask for a goal return false or null if there is none. Nothing here is real-time safe.
 */
template <class ActionSpec>
class RTTSimpleActionServer {
    typedef RTTActionServer<ActionSpec> Server;
    typedef std::lock_guard<std::mutex> Lock;

public:
    ACTION_DEFINITION(ActionSpec)
    typedef typename Server::GoalHandle GoalHandle;
    typedef std::function<void(const Goal&)> GoalHook;
    typedef std::function<void()> CancelHook;

    /** Adds the ports to `service`; an error is logged if that fails. */
    explicit RTTSimpleActionServer(RTT::Service::shared_ptr service, double status_period = 0.200,
                                   int sched = ORO_SCHED_OTHER)
        : server_(status_period, sched) {
        (void)server_.addPorts(std::move(service));
        server_.registerGoalCallback([this](GoalHandle goal) { onGoal(goal); });
        server_.registerCancelCallback([this](GoalHandle goal) { onCancel(goal); });
    }
    RTTSimpleActionServer(const RTTSimpleActionServer&) = delete;
    RTTSimpleActionServer& operator=(const RTTSimpleActionServer&) = delete;

    /** Is called with a goal that has become pending; usually calls acceptPending() or rejectPending(). */
    void setGoalHook(GoalHook hook) {
        const Lock lock(mutex_);
        goalHook_ = std::move(hook);
    }
    /** Is called when the client asks to cancel the active goal; that stays active until cancelActive() or another of
        the functions below ends it. A pending goal is cancelled without it. */
    void setCancelHook(CancelHook hook) {
        const Lock lock(mutex_);
        cancelHook_ = std::move(hook);
    }

    /** All ports are connected. */
    bool ready() const { return server_.ready(); }
    /** Goals and cancel requests are taken, see RTTActionServer. False if there are no ports. */
    bool start() {
        server_.start();
        return server_.bridge().isServer();
    }
    /** Aborts the active goal, rejects the pending one and takes no others. */
    void shutdown() {
        server_.shutdown();
        const Lock lock(mutex_);
        active_ = pending_ = GoalHandle();
    }
    Server& server() { return server_; }

    bool isActive() const { return hasStatus(active_, Status::ACTIVE, Status::PREEMPTING); }
    /** The client has asked to cancel the active goal. */
    bool isPreempting() const { return hasStatus(active_, Status::PREEMPTING, Status::PREEMPTING); }
    bool isPending() const { return hasStatus(pending_, Status::PENDING, Status::PENDING); }
    GoalConstPtr getActiveGoal() const { return goalOf(active_); }
    GoalConstPtr getPendingGoal() const { return goalOf(pending_); }

    /** Makes the pending goal the active one; a goal that was active is aborted with `result` and `msg`. */
    bool acceptPending(const Result& result, const std::string& msg = "") {
        const Lock lock(mutex_);
        if (!isValid(pending_)) return false;
        if (isValid(active_)) active_.setAborted(result, msg);
        active_ = std::exchange(pending_, GoalHandle());
        active_.setAccepted();
        return true;
    }
    bool rejectPending(const Result& result, const std::string& msg = "") {
        return end(pending_, [&](GoalHandle& goal) { goal.setRejected(result, msg); });
    }
    bool publishFeedback(const Feedback& feedback) {
        const Lock lock(mutex_);
        if (!isValid(active_)) return false;
        active_.publishFeedback(feedback);
        return true;
    }
    bool abortActive(const Result& result, const std::string& msg = "") {
        return end(active_, [&](GoalHandle& goal) { goal.setAborted(result, msg); });
    }
    bool cancelActive(const Result& result, const std::string& msg = "") {
        return end(active_, [&](GoalHandle& goal) { goal.setCanceled(result, msg); });
    }
    bool succeedActive(const Result& result, const std::string& msg = "") {
        return end(active_, [&](GoalHandle& goal) { goal.setSucceeded(result, msg); });
    }

private:
    typedef actionlib_msgs::GoalStatus Status;

    static bool isValid(const GoalHandle& goal) { return goal.getGoal() != nullptr; }

    bool hasStatus(const GoalHandle& goal, int one, int other) const {
        const Lock lock(mutex_);
        if (!isValid(goal)) return false;
        const int status = goal.getGoalStatus().status;
        return status == one || status == other;
    }
    GoalConstPtr goalOf(const GoalHandle& goal) const {
        const Lock lock(mutex_);
        return goal.getGoal();
    }
    template <class How>
    bool end(GoalHandle& goal, How&& how) {
        const Lock lock(mutex_);
        if (!isValid(goal)) return false;
        how(goal);
        goal = GoalHandle();
        return true;
    }

    void onGoal(GoalHandle& goal) {
        GoalHook hook;
        {
            const Lock lock(mutex_);
            if (isValid(pending_)) pending_.setRejected(Result(), "another goal came before this one was accepted");
            pending_ = goal;
            hook = goalHook_;
        }
        const GoalConstPtr content = goal.getGoal();
        if (hook && content) hook(*content);
    }

    void onCancel(GoalHandle& goal) {
        CancelHook hook;
        {
            const Lock lock(mutex_);
            if (goal == pending_) {
                pending_.setCanceled(Result(), "the goal was cancelled before it was accepted");
                pending_ = GoalHandle();
                return;
            }
            if (goal != active_) return;
            hook = cancelHook_;
        }
        if (hook) hook();
    }

    mutable std::mutex mutex_;  // guards all but the server, which has its own
    GoalHandle active_, pending_;
    GoalHook goalHook_;
    CancelHook cancelHook_;
    Server server_;  // the first to go: it calls the functions above
};

}  // namespace rtt_actionlib

#endif
