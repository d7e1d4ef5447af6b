// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The element that represents a port at the end of its channels.
#ifndef ORO_INTERNAL_PORT_ENDPOINT_HPP
#define ORO_INTERNAL_PORT_ENDPOINT_HPP

#include <rtt/base/ChannelElementBase.hpp>

namespace RTT {
namespace base {
class InputPortInterface;
}
namespace internal {

/** One per port, shared by all its channels. Outlives the port: channels that still hold it find the port gone. */
class RTT_API PortEndpoint final : public base::ChannelElementBase {
public:
    explicit PortEndpoint(base::PortInterface& port) : port_(&port) { setQuiet(true); }

    base::PortInterface* getPort() const override { return port_.load(std::memory_order_acquire); }
    std::string getElementName() const override { return "PortEndpoint"; }

    /** A channel of this input port has new data: signals the port. */
    bool signal() override;
    using base::ChannelElementBase::inputReady;
    bool inputReady(shared_ptr const& caller) override;
    bool channelReady(shared_ptr const& caller, ConnPolicy const& policy, ConnID* id) override;
    void clear() override {}
    /** The channel broke: the port removes it. */
    bool disconnect(shared_ptr const& channel, bool forward) override;
    void disconnect(bool forward) override;
    bool connectTo(shared_ptr const& output, bool mandatory = true) override;
    bool connectFrom(shared_ptr const& input) override;

    /** For the input port itself. Set once, so that signal() need not ask for the port's kind. */
    void setInputPort(base::InputPortInterface* port) { input_.store(port, std::memory_order_release); }
    /** Whether signal() signals the port. Kept here, so that signal() need not look at the port. */
    void setSignals(bool on) { setQuiet(!on); }
    bool signals() const { return !isQuiet(); }
    /** For the port's destructor, which then waits for threads in signal(). */
    void detach();

private:
    std::atomic<base::PortInterface*> port_;
    std::atomic<base::InputPortInterface*> input_{nullptr};
};

}  // namespace internal
}  // namespace RTT

#endif
