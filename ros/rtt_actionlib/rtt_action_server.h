// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An action server whose topics are ports of a component.
#ifndef RTT_ACTIONLIB_RTT_ACTION_SERVER_H
#define RTT_ACTIONLIB_RTT_ACTION_SERVER_H

#include <actionlib/server/action_server_base.h>
#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt_actionlib/rtt_actionlib.h>
#include <rtt_actionlib/status_timer.hpp>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace rtt_actionlib {

/**
 * As actionlib::ActionServer, with ports instead of topics. Goals and cancel requests come in the component's thread,
 * while it is running. Goal handles may be used by any thread. A thread of its own writes the status at regular
 * intervals. Nothing here is real-time safe: messages allocate, and a mutex is taken.
 *
 * A server that is shut down or destroyed ends the goals that it still has: it rejects the pending ones, and aborts the
 * others. Destroy it in another thread than one of its callbacks.
 */
template <class ActionSpec>
class RTTActionServer : public actionlib::ActionServerBase<ActionSpec> {
    typedef actionlib::ActionServerBase<ActionSpec> Base;
    typedef boost::recursive_mutex::scoped_lock Lock;
    typedef actionlib_msgs::GoalStatus Status;

public:
    ACTION_DEFINITION(ActionSpec)
    typedef typename Base::GoalHandle GoalHandle;
    typedef boost::function<void(GoalHandle)> Callback;

    /** The period of the status is in seconds. */
    explicit RTTActionServer(double status_period = 0.200, int sched = ORO_SCHED_OTHER)
        : RTTActionServer("rtt_actionlib_status", status_period, sched) {}
    /** The name is that of the thread that writes the status. */
    explicit RTTActionServer(const std::string& name, double status_period = 0.200, int sched = ORO_SCHED_OTHER)
        : Base(Callback(), Callback(), false), timer_(name, status_period, sched, [this] { tick(); }) {
        this->status_list_timeout_ = ros::Duration(5.0);
        this->goal_callback_ = [this](GoalHandle goal) { onGoal(goal); };
        this->cancel_callback_ = [this](GoalHandle goal) { onCancel(goal); };
        (void)now();  // Times of messages are needed without a node, too.
    }
    ~RTTActionServer() override {
        shutdown();
        this->guard_->destruct();  // From now on goal handles do nothing.
        bridge_.clear();
    }
    RTTActionServer(const RTTActionServer&) = delete;
    RTTActionServer& operator=(const RTTActionServer&) = delete;

    /** Adds the ports of the action to a service, and connects them to topics of that namespace if asked to. False,
        with an error logged, if that fails. Once; before start(). */
    bool addPorts(RTT::Service::shared_ptr service, bool create_topics = false,
                  const std::string& topic_namespace = "") {
        if (!bridge_.createServerPorts<ActionSpec>()) {
            RTT::log(RTT::Error) << "this action server has its ports already" << RTT::endlog();
            return false;
        }
        if (!bridge_.addPortsTo(service, [this](RTT::base::PortInterface* port) { arrived(port); })) {
            bridge_.clear();
            return false;
        }
        engine_ = service->getOwnerExecutionEngine();
        return !create_topics || bridge_.createStream(topic_namespace);
    }
    /** All ports are connected. */
    bool ready() const { return bridge_.allConnected(); }
    ActionBridge& bridge() { return bridge_; }

    /** Goals and cancel requests are taken, and the status is written. What came earlier is dropped. */
    void start() {
        if (!bridge_.isServer()) {
            RTT::log(RTT::Error) << "an action server without ports does not start; call addPorts() first"
                                 << RTT::endlog();
            return;
        }
        {
            const Lock lock(this->lock_);
            if (this->started_) return;
            ActionGoal goal;
            actionlib_msgs::GoalID cancel;
            while (bridge_.template goalInput<ActionSpec>().read(goal, false) == RTT::NewData) continue;
            while (bridge_.cancelInput().read(cancel, false) == RTT::NewData) continue;
            this->started_ = true;
        }
        initialize();
        publishStatus();
    }
    /** Ends all goals and takes no others. It can be started again. Waits for the thread that writes the status. */
    void shutdown() {
        (void)timer_.stop();
        const Lock lock(this->lock_);
        if (!this->started_) return;
        this->started_ = false;
        std::vector<Status> ended;
        for (actionlib::StatusTracker<ActionSpec>& one : this->status_list_)
            if (one.goal_ && end(one.status_)) ended.push_back(one.status_);
        for (const Status& one : ended) publishResult(one, Result());
    }

    /** Takes goals, in the component's thread. The last function or operation is the one that counts; without one,
        goals are rejected. */
    void registerGoalCallback(Callback callback) {
        const std::lock_guard<std::mutex> lock(callbacks_);
        onGoal_ = std::move(callback);
    }
    /** Is told of requests to cancel a goal. */
    void registerCancelCallback(Callback callback) {
        const std::lock_guard<std::mutex> lock(callbacks_);
        onCancel_ = std::move(callback);
    }
    /** The same with an operation `void(GoalHandle)`. After addPorts(). False, with an error logged, if it has another
        signature. */
    bool registerGoalOperation(RTT::OperationInterfacePart* operation) {
        const Callback callback = callbackOf(operation);
        if (callback) registerGoalCallback(callback);
        return !callback.empty();
    }
    bool registerCancelOperation(RTT::OperationInterfacePart* operation) {
        const Callback callback = callbackOf(operation);
        if (callback) registerCancelCallback(callback);
        return !callback.empty();
    }

    /** Writes the states of all goals. Any thread. */
    void publishStatus() override {
        const Lock lock(this->lock_);
        if (!bridge_.isServer()) return;
        actionlib_msgs::GoalStatusArray array;
        array.header.stamp = now();
        array.status_list.reserve(this->status_list_.size());
        for (const actionlib::StatusTracker<ActionSpec>& one : this->status_list_)
            array.status_list.push_back(one.status_);
        (void)bridge_.statusOutput().write(array);
    }

protected:
    void initialize() override { (void)timer_.start(); }

    void publishResult(const Status& status, const Result& result) override {
        const Lock lock(this->lock_);
        if (!bridge_.isServer()) return;
        ActionResult message;
        message.header.stamp = now();
        message.status = status;
        message.result = result;
        (void)bridge_.template resultOutput<ActionSpec>().write(message);
        publishStatus();
    }

    void publishFeedback(const Status& status, const Feedback& feedback) override {
        const Lock lock(this->lock_);
        if (!bridge_.isServer()) return;
        ActionFeedback message;
        message.header.stamp = now();
        message.status = status;
        message.feedback = feedback;
        (void)bridge_.template feedbackOutput<ActionSpec>().write(message);
    }

private:
    static bool end(Status& status) {
        switch (status.status) {
            case Status::PENDING: status.status = Status::REJECTED; break;
            case Status::RECALLING: status.status = Status::RECALLED; break;
            case Status::ACTIVE:
            case Status::PREEMPTING: status.status = Status::ABORTED; break;
            default: return false;
        }
        status.text = "the action server was shut down";
        return true;
    }

    void arrived(RTT::base::PortInterface* port) {
        // A goal comes before its own cancel request, whichever of the two ports signals first.
        RTT::InputPort<ActionGoal>& goals = bridge_.template goalInput<ActionSpec>();
        for (;;) {
            const boost::shared_ptr<ActionGoal> goal(new ActionGoal);
            if (goals.read(*goal, false) != RTT::NewData) break;
            this->goalCallback(goal);
        }
        if (port == &goals) return;
        for (;;) {
            const boost::shared_ptr<actionlib_msgs::GoalID> id(new actionlib_msgs::GoalID);
            if (bridge_.cancelInput().read(*id, false) != RTT::NewData) break;
            this->cancelCallback(id);
        }
    }

    void onGoal(GoalHandle& goal) {
        Callback callback;
        {
            const std::lock_guard<std::mutex> lock(callbacks_);
            callback = onGoal_;
        }
        if (callback) return callback(goal);
        RTT::log(RTT::Error) << "an action server rejects a goal, because it has no callback for goals; call "
                                "registerGoalCallback()"
                             << RTT::endlog();
        goal.setRejected(Result(), "the action server has no callback for goals");
    }

    void onCancel(GoalHandle& goal) {
        Callback callback;
        {
            const std::lock_guard<std::mutex> lock(callbacks_);
            callback = onCancel_;
        }
        if (callback) callback(goal);
    }

    Callback callbackOf(RTT::OperationInterfacePart* operation) const {
        typedef RTT::OperationCaller<void(GoalHandle)> Caller;
        const auto caller = std::make_shared<Caller>();
        if (operation) *caller = Caller(operation, engine_);
        if (operation && caller->ready()) return [caller](GoalHandle goal) { (*caller)(goal); };
        RTT::log(RTT::Error) << "operation '" << (operation ? operation->getName() : std::string())
                             << "' cannot take goals of an action; its signature should be void(GoalHandle)"
                             << RTT::endlog();
        return Callback();
    }

    void tick() {
        const Lock lock(this->lock_);
        if (!this->started_) return;
        forgetOldGoals();
        publishStatus();
        missed_.tellOnce(bridge_.template goalInput<ActionSpec>(), bridge_.cancelInput());
    }

    // Called by the timer alone: the base keeps places in the list while it publishes.
    void forgetOldGoals() {
        const ros::Time time = now();
        const auto timeout = static_cast<std::uint64_t>(this->status_list_timeout_.toNSec());
        this->status_list_.remove_if([&](actionlib::StatusTracker<ActionSpec>& one) {
            // The base takes times of clients for it, which may be zero or far in the future.
            ros::Time& end = one.handle_destruction_time_;
            if (end > time || (end.isZero() && one.handle_tracker_.expired())) end = time;
            return !end.isZero() && end.toNSec() + timeout < time.toNSec();
        });
    }

    ActionBridge bridge_;
    std::mutex callbacks_;  // guards the two functions
    Callback onGoal_, onCancel_;
    RTT::ExecutionEngine* engine_ = nullptr;
    MissedSamples missed_;
    StatusTimer timer_;
};

}  // namespace rtt_actionlib

#endif
