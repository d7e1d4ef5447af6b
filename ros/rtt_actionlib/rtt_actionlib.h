// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The five ports of an action.
#ifndef RTT_ACTIONLIB_RTT_ACTIONLIB_H
#define RTT_ACTIONLIB_RTT_ACTIONLIB_H

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <rtt/ConnPolicy.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Service.hpp>

#include <functional>
#include <memory>
#include <string>

namespace rtt_actionlib {

/**
 * The ports `_action_goal`, `_action_cancel`, `_action_status`, `_action_result` and `_action_feedback` of a server or a
 * client of an action. It owns those that it created; others must outlive it. One thread at a time may call these
 * functions, except those that give a port. Nothing here is real-time safe.
 */
class ActionBridge {
public:
    typedef std::function<void(RTT::base::PortInterface*)> InputCallback;

    /** As many messages of each topic may wait: as many as in actionlib itself. */
    static constexpr int kWaiting = 50;

    ActionBridge();
    /** Disconnects and removes the ports that it created; waits for their callbacks in other threads. */
    ~ActionBridge();
    ActionBridge(const ActionBridge&) = delete;
    ActionBridge& operator=(const ActionBridge&) = delete;

    /** Makes ports for messages of an action: a server's inputs are goal and cancel, a client's the other three. False
        if there are ports already. */
    template <class ActionSpec>
    bool createServerPorts() {
        if (isValid()) return false;
        return own(input<typename ActionSpec::_action_goal_type>(kGoal), input<actionlib_msgs::GoalID>(kCancel),
                   output<actionlib_msgs::GoalStatusArray>(kStatus),
                   output<typename ActionSpec::_action_result_type>(kResult),
                   output<typename ActionSpec::_action_feedback_type>(kFeedback));
    }
    template <class ActionSpec>
    bool createClientPorts() {
        if (isValid()) return false;
        return own(output<typename ActionSpec::_action_goal_type>(kGoal), output<actionlib_msgs::GoalID>(kCancel),
                   input<actionlib_msgs::GoalStatusArray>(kStatus),
                   input<typename ActionSpec::_action_result_type>(kResult),
                   input<typename ActionSpec::_action_feedback_type>(kFeedback));
    }
    /** Takes ports that belong to others. False, with an error logged, and without a change, if they are neither those
        of a server nor those of a client. */
    bool setPorts(RTT::base::PortInterface* goal, RTT::base::PortInterface* cancel, RTT::base::PortInterface* status,
                  RTT::base::PortInterface* result, RTT::base::PortInterface* feedback);
    /** The same with the ports of those names of a service. */
    bool setPortsFromService(const RTT::Service::shared_ptr& service);
    /** Adds the ports to a service. New samples call `arrived` with their port in the thread of the component, while
        it is running. False, with an error logged, if there are no ports or the service has ports of these names. */
    bool addPortsTo(const RTT::Service::shared_ptr& service, const InputCallback& arrived);

    /** There are five ports, of a server or of a client. */
    bool isValid() const { return isServer() || isClient(); }
    bool isServer() const;
    bool isClient() const;

    /** Connects the ports to the topics `goal`, `cancel`, `status`, `result` and `feedback` of a namespace. A topic that
        a port has already is left as it is. False, with errors logged and without new streams, if one fails. Without a
        policy kWaiting messages may wait, and late clients get the last status. Asks the master, so it blocks. */
    bool createStream(const std::string& action_ns);
    bool createStream(const std::string& action_ns, const RTT::ConnPolicy& policy);
    bool allConnected() const;
    bool anyConnected() const;

    /** A port of this message and direction. Throws std::bad_cast if there is none. Any thread. */
    template <class ActionSpec>
    RTT::InputPort<typename ActionSpec::_action_goal_type>& goalInput() {
        return as<RTT::InputPort<typename ActionSpec::_action_goal_type>>(kGoal);
    }
    template <class ActionSpec>
    RTT::OutputPort<typename ActionSpec::_action_goal_type>& goalOutput() {
        return as<RTT::OutputPort<typename ActionSpec::_action_goal_type>>(kGoal);
    }
    template <class ActionSpec>
    RTT::OutputPort<typename ActionSpec::_action_result_type>& resultOutput() {
        return as<RTT::OutputPort<typename ActionSpec::_action_result_type>>(kResult);
    }
    template <class ActionSpec>
    RTT::InputPort<typename ActionSpec::_action_result_type>& resultInput() {
        return as<RTT::InputPort<typename ActionSpec::_action_result_type>>(kResult);
    }
    template <class ActionSpec>
    RTT::OutputPort<typename ActionSpec::_action_feedback_type>& feedbackOutput() {
        return as<RTT::OutputPort<typename ActionSpec::_action_feedback_type>>(kFeedback);
    }
    template <class ActionSpec>
    RTT::InputPort<typename ActionSpec::_action_feedback_type>& feedbackInput() {
        return as<RTT::InputPort<typename ActionSpec::_action_feedback_type>>(kFeedback);
    }
    RTT::InputPort<actionlib_msgs::GoalID>& cancelInput();
    RTT::OutputPort<actionlib_msgs::GoalID>& cancelOutput();
    RTT::InputPort<actionlib_msgs::GoalStatusArray>& statusInput();
    RTT::OutputPort<actionlib_msgs::GoalStatusArray>& statusOutput();

    /** Disconnects and removes the ports that it created, and forgets the others. */
    void clear();

private:
    enum Part { kGoal, kCancel, kStatus, kResult, kFeedback, kParts };
    static const char* nameOf(Part part);
    static RTT::ConnPolicy inputPolicy();

    template <class Message>
    static RTT::base::PortInterface* input(Part part) {
        return new RTT::InputPort<Message>(nameOf(part), inputPolicy());
    }
    template <class Message>
    static RTT::base::PortInterface* output(Part part) {
        return new RTT::OutputPort<Message>(nameOf(part), false);
    }
    bool own(RTT::base::PortInterface* goal, RTT::base::PortInterface* cancel, RTT::base::PortInterface* status,
             RTT::base::PortInterface* result, RTT::base::PortInterface* feedback);
    bool connect(const std::string& action_ns, const RTT::ConnPolicy& policy, bool keepsStatus);
    template <class Port>
    Port& as(Part part) {
        return dynamic_cast<Port&>(at(part));
    }
    RTT::base::PortInterface& at(Part part) const;

    RTT::base::PortInterface* ports_[kParts] = {};
    std::unique_ptr<RTT::base::PortInterface> owned_[kParts];
};

/** The topic of that name in the namespace of an action. */
std::string actionTopic(const std::string& action_ns, const std::string& name);

}  // namespace rtt_actionlib

#endif
