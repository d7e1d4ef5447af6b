// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A client of an action whose topics are ports of a component.
#ifndef RTT_ACTIONLIB_RTT_ACTION_CLIENT_H
#define RTT_ACTIONLIB_RTT_ACTION_CLIENT_H

#include <actionlib/client/client_helpers.h>
#include <rtt/Logger.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt_actionlib/rtt_actionlib.h>
#include <rtt_actionlib/status_timer.hpp>

#include <atomic>
#include <mutex>
#include <string>
#include <utility>

namespace rtt_actionlib {

/**
 * As actionlib::ActionClient, with ports instead of topics. The callbacks of goals are called in the component's thread,
 * while it is running. Any thread may call the functions below and use goal handles. Nothing here is real-time safe.
 * Destroy it in another thread than one of its callbacks. As with actionlib, goal handles that are left may then only
 * be destroyed.
 */
template <class ActionSpec>
class RTTActionClient {
public:
    ACTION_DEFINITION(ActionSpec)
    typedef actionlib::ClientGoalHandle<ActionSpec> GoalHandle;
    typedef boost::function<void(GoalHandle)> TransitionCallback;
    typedef boost::function<void(GoalHandle, const FeedbackConstPtr&)> FeedbackCallback;

    RTTActionClient() : guard_(new actionlib::DestructionGuard()), manager_(guard_) {
        (void)now();
        manager_.registerSendGoalFunc([this](const ActionGoalConstPtr& goal) { send(*goal); });
        manager_.registerCancelFunc([this](const actionlib_msgs::GoalID& id) { cancel(id); });
    }
    ~RTTActionClient() {
        guard_->destruct();
        bridge_.clear();
    }
    RTTActionClient(const RTTActionClient&) = delete;
    RTTActionClient& operator=(const RTTActionClient&) = delete;

    /** Adds the ports of the action to a service, and connects them to topics of that namespace if asked to. False,
        with an error logged, if that fails. Once. */
    bool addPorts(RTT::Service::shared_ptr service, bool create_topics = false,
                  const std::string& topic_namespace = "") {
        if (!bridge_.createClientPorts<ActionSpec>()) {
            RTT::log(RTT::Error) << "this action client has its ports already" << RTT::endlog();
            return false;
        }
        if (!bridge_.addPortsTo(service, [this](RTT::base::PortInterface*) { arrived(); })) {
            bridge_.clear();
            return false;
        }
        return !create_topics || bridge_.createStream(topic_namespace);
    }
    /** All ports are connected; that does not mean that there is a server. */
    bool ready() const { return bridge_.allConnected(); }
    /** The status of a server came during the last seconds, so there is a server. */
    bool isServerConnected(RTT::Seconds within = 1.0) const {
        const RTT::nsecs last = lastStatus_;
        return last != 0 && RTT::os::TimeService::Instance()->getNSecs() - last < RTT::Seconds_to_nsecs(within);
    }
    ActionBridge& bridge() { return bridge_; }

    /** Writes a goal. Its progress is followed as long as a copy of the handle exists. A goal that is written before
        the server's topics are connected gets lost; GoalHandle::resend() writes it again. */
    GoalHandle sendGoal(const Goal& goal, TransitionCallback transition = TransitionCallback(),
                        FeedbackCallback feedback = FeedbackCallback()) {
        return manager_.initGoal(goal, std::move(transition), std::move(feedback));
    }
    void cancelAllGoals() { cancel(actionlib_msgs::GoalID()); }
    void cancelGoalsAtAndBeforeTime(const ros::Time& time) {
        actionlib_msgs::GoalID id;
        id.stamp = time;
        cancel(id);
    }
    /** Is called after each status, in the component's thread. Set it before the component is started. */
    void setStatusHook(boost::function<void()> hook) { statusHook_ = std::move(hook); }

private:
    void send(const ActionGoal& goal) {
        const std::lock_guard<std::mutex> lock(writing_);
        if (bridge_.isClient()) (void)bridge_.template goalOutput<ActionSpec>().write(goal);
    }
    void cancel(const actionlib_msgs::GoalID& id) {
        const std::lock_guard<std::mutex> lock(writing_);
        if (bridge_.isClient()) (void)bridge_.cancelOutput().write(id);
    }

    // Takes the messages in the order in which a server writes them, whichever port signals first: after its result, a
    // goal has no feedback.
    void arrived() {
        for (;;) {
            const ActionFeedbackPtr feedback(new ActionFeedback);
            if (bridge_.template feedbackInput<ActionSpec>().read(*feedback, false) != RTT::NewData) break;
            manager_.updateFeedbacks(feedback);
        }
        for (;;) {
            const ActionResultPtr result(new ActionResult);
            if (bridge_.template resultInput<ActionSpec>().read(*result, false) != RTT::NewData) break;
            manager_.updateResults(result);
        }
        for (;;) {
            const actionlib_msgs::GoalStatusArrayPtr status(new actionlib_msgs::GoalStatusArray);
            if (bridge_.statusInput().read(*status, false) != RTT::NewData) break;
            lastStatus_ = RTT::os::TimeService::Instance()->getNSecs();
            manager_.updateStatuses(status);
            if (statusHook_) statusHook_();
        }
    }

    ActionBridge bridge_;
    std::mutex writing_;
    std::atomic<RTT::nsecs> lastStatus_{0};
    boost::function<void()> statusHook_;
    boost::shared_ptr<actionlib::DestructionGuard> guard_;
    actionlib::GoalManager<ActionSpec> manager_;
};

}  // namespace rtt_actionlib

#endif
