// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_CHAIN_HPP
#define ORO_OCL_CHAIN_HPP

#include <ocl/ChainStatistics.hpp>
#include <ocl/OCL.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/rtt-config.h>

#include <memory>
#include <string>
#include <vector>

namespace OCL {
namespace chain {
struct Impl;
}

/**
 * Executes other components, its members, one after the other in its own thread: in each period, for each sample on the
 * port `trigger` or `inClock`, or for each call of trigger() or step(). A member is a peer whose activity is a
 * SlaveActivity of this component. It executes its messages, the callbacks of its ports and its hook in its turn.
 *
 * The properties count from start() on. Peers may come, go and restart while the chain runs. A cycle neither allocates
 * nor locks nor waits, as far as its members do not; lists are rebuilt in the thread of the GlobalEngine, which also
 * logs failures, at most once per second. Members may be destroyed at any time, by any thread.
 *
 * Sub-classes call the hooks of this class in theirs, and stopForGood() in their destructor.
 */
class OCL_API Chain : public RTT::TaskContext {
public:
    explicit Chain(const std::string& name);
    ~Chain() override;

    /** These also tell the chain, so that the next cycle has the new list. Not real-time safe. */
    bool addPeer(RTT::TaskContext* peer, std::string alias = "") override;
    void removePeer(const std::string& name) override;
    void removePeer(RTT::TaskContext* peer) override;

    // --- operations; any thread, not real-time safe ------------------------------------------------------------------
    /** Writes the order to standard output. */
    void displaySchedList();
    /** The members in their order: those of the cycle while it runs, else those that start() would find. */
    std::vector<std::string> order();
    /** What was measured. While it runs, the numbers may be of two successive cycles. */
    ChainStatistics stats();
    void resetStats();
    /** The statistics as a table, also of chains that are members. */
    std::string timeReport();
    /** How many of the last periods timeReport() shows; 3000 at first. False, with an error logged, unless it is from 1
        to 1000000. */
    bool setMaxBufferSize(int periods);
    /** What is wrong with the configuration: one line for each finding. Empty if start() would succeed. */
    std::string check();
    /** Order, thread and delays of data as a text of a few lines. */
    std::string describe();
    /** The order and the connections between members, for Graphviz. */
    std::string dot();
    /** One cycle in this thread, which must be that of the component, or act as its activity. False if it does not run
        or is periodic. As real-time safe as the members. */
    bool step();

protected:
    /** `othersFollow`: peers that sched_order does not name follow in alphabetical order, as in FBSched. */
    Chain(const std::string& name, bool othersFollow);

    /** With the property `manage`, also configures the members. */
    bool configureHook() override;
    /** Checks everything, logs all findings as one error; false if there are any. */
    bool startHook() override;
    /** One cycle. */
    void updateHook() override;
    /** Executes the messages of the members only. */
    void errorHook() override;
    void stopHook() override;
    void cleanupHook() override;

    /** The property sched_order. */
    std::vector<std::string> sched_order;
    /** The ports `trigger` and `inClock`. */
    RTT::InputPort<int> trigger_port;
    RTT::InputPort<double> clock_port;

private:
    friend struct chain::Impl;
    const std::unique_ptr<chain::Impl> impl_;
};

}  // namespace OCL

#endif
