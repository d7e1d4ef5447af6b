// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A client of an action with one goal at a time.
#ifndef RTT_ACTIONLIB_RTT_SIMPLE_ACTION_CLIENT_H
#define RTT_ACTIONLIB_RTT_SIMPLE_ACTION_CLIENT_H

#include <actionlib/client/simple_client_goal_state.h>
#include <rtt_actionlib/rtt_action_client.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace rtt_actionlib {

/**
 * Follows the goal that it sent last. Hooks are called in the component's thread, while it is running; set them before.
 * Any thread may call the other functions. Nothing here is real-time safe.
 */
template <class ActionSpec>
class RTTSimpleActionClient {
    typedef RTTActionClient<ActionSpec> Client;
    typedef std::lock_guard<std::mutex> Lock;

public:
    ACTION_DEFINITION(ActionSpec)
    typedef typename Client::GoalHandle GoalHandle;
    typedef actionlib::SimpleClientGoalState State;
    typedef std::function<void(const State&, const ResultConstPtr&)> DoneHook;
    typedef std::function<void()> ActiveHook;
    typedef std::function<void(const FeedbackConstPtr&)> FeedbackHook;

    /** Adds the ports to `service`; an error is logged if that fails. */
    explicit RTTSimpleActionClient(RTT::Service::shared_ptr service) {
        (void)client_.addPorts(std::move(service));
        client_.setStatusHook([this] { onStatus(); });
    }
    ~RTTSimpleActionClient() {
        GoalHandle last;
        const Lock lock(mutex_);
        ++number_;
        last = handle_;
        handle_ = GoalHandle();
    }
    RTTSimpleActionClient(const RTTSimpleActionClient&) = delete;
    RTTSimpleActionClient& operator=(const RTTSimpleActionClient&) = delete;

    /** Is called once, when the goal has ended. */
    void setDoneHook(DoneHook hook) { doneHook_ = std::move(hook); }
    /** Is called once, when the server has accepted the goal. */
    void setActiveHook(ActiveHook hook) { activeHook_ = std::move(hook); }
    void setFeedbackHook(FeedbackHook hook) { feedbackHook_ = std::move(hook); }

    /** All ports are connected; that does not mean that there is a server. */
    bool ready() const { return client_.ready(); }
    /** See RTTActionClient. */
    bool isServerConnected(RTT::Seconds within = 1.0) const { return client_.isServerConnected(within); }
    Client& client() { return client_; }

    /** Sends a goal, again and again until the server knows of it. The one before, if any, is not cancelled, but no
        longer followed. */
    void sendGoal(const Goal& goal) {
        unsigned number = 0;
        {
            const Lock lock(mutex_);
            number = ++number_;
            state_ = State(State::PENDING);
            result_.reset();
        }
        missing_ = 0;
        const GoalHandle made = client_.sendGoal(
            goal, [this, number](GoalHandle handle) { onTransition(handle, number); },
            [this, number](GoalHandle, const FeedbackConstPtr& feedback) { onFeedback(feedback, number); });
        GoalHandle previous;
        const Lock lock(mutex_);
        if (number != number_) return;
        previous = handle_;
        handle_ = made;
    }
    /** Asks the server to cancel the goal, which ends when the server says so. False if there is none. */
    bool cancelGoal() {
        GoalHandle handle;
        {
            const Lock lock(mutex_);
            if (handle_.isExpired() || state_.isDone()) return false;
            handle = handle_;
        }
        handle.cancel();
        return true;
    }
    /** PENDING or ACTIVE until the goal has ended; LOST if none was sent. */
    State getState() const {
        const Lock lock(mutex_);
        return state_;
    }
    bool isDone() const { return getState().isDone(); }
    /** Null until the goal has ended. */
    ResultConstPtr getResult() const {
        const Lock lock(mutex_);
        return result_;
    }

private:
    typedef actionlib::CommState Comm;

    static State stateOf(const actionlib::TerminalState& end) {
        switch (end.state_) {
            case actionlib::TerminalState::RECALLED: return State(State::RECALLED, end.getText());
            case actionlib::TerminalState::REJECTED: return State(State::REJECTED, end.getText());
            case actionlib::TerminalState::PREEMPTED: return State(State::PREEMPTED, end.getText());
            case actionlib::TerminalState::ABORTED: return State(State::ABORTED, end.getText());
            case actionlib::TerminalState::SUCCEEDED: return State(State::SUCCEEDED, end.getText());
            default: return State(State::LOST, end.getText());
        }
    }

    void onTransition(const GoalHandle& handle, unsigned number) {
        const Comm comm = handle.getCommState();
        const bool isActive = comm == Comm::ACTIVE || comm == Comm::PREEMPTING;
        if (!isActive && comm != Comm::DONE) return;
        State state(State::ACTIVE);
        ResultConstPtr result;
        if (!isActive) {
            state = stateOf(handle.getTerminalState());
            result = handle.getResult();
        }
        {
            const Lock lock(mutex_);
            if (number != number_ || state_.isDone() || state_ == state) return;
            state_ = state;
            result_ = result;
        }
        if (isActive && activeHook_) activeHook_();
        if (!isActive && doneHook_) doneHook_(state, result);
    }

    void onFeedback(const FeedbackConstPtr& feedback, unsigned number) {
        {
            const Lock lock(mutex_);
            if (number != number_) return;
        }
        if (feedbackHook_) feedbackHook_(feedback);
    }

    /** A goal that was sent before all topics were connected is unknown to the server. It ignores those it knows. */
    void onStatus() {
        GoalHandle handle;
        {
            const Lock lock(mutex_);
            if (handle_.isExpired() || state_ != State::PENDING) return;
            handle = handle_;
        }
        if (handle.getCommState() == Comm::WAITING_FOR_GOAL_ACK && ++missing_ > kPatience) {
            missing_ = 0;
            handle.resend();
        }
    }

    static constexpr int kPatience = 2;  // statuses without the goal

    // Never held while a function of `client_` is called, or while the last copy of a handle goes: those take a mutex that
    // is held by the callbacks.
    mutable std::mutex mutex_;
    State state_{State::LOST};
    ResultConstPtr result_;
    unsigned number_ = 0;
    std::atomic<int> missing_{0};
    GoalHandle handle_;
    DoneHook doneHook_;
    ActiveHook activeHook_;
    FeedbackHook feedbackHook_;
    Client client_;  // the first to go: it calls the functions above
};

}  // namespace rtt_actionlib

#endif
