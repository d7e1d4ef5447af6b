// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One link of the chain between an output port and an input port, for samples of any type.
//
//   OutputPort -> [storage element] -> InputPort                      a local connection
//   OutputPort -> [storage element] -> [transport element]            an output stream
//   [transport element] -> [storage element] -> InputPort             an input stream
//
// Both ends of a complete chain are the endpoint elements of the ports.
#ifndef ORO_CHANNEL_ELEMENT_BASE_HPP
#define ORO_CHANNEL_ELEMENT_BASE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/rtt-config.h>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <string>

namespace RTT {
class ConnPolicy;
namespace internal {
class ConnID;
class ConnectionManager;
class StorageCore;
}  // namespace internal

namespace base {
class PortInterface;

/** Reference counted; create with new, hold in a shared_ptr. One thread may change links while others use them. */
class RTT_API ChannelElementBase {
public:
    typedef boost::intrusive_ptr<ChannelElementBase> shared_ptr;

    ChannelElementBase() = default;
    virtual ~ChannelElementBase();
    ChannelElementBase(const ChannelElementBase&) = delete;
    ChannelElementBase& operator=(const ChannelElementBase&) = delete;

    /** The neighbour on the writer's, or the reader's, side; null if there is none. Lock-free. */
    shared_ptr getInput() const;
    shared_ptr getOutput() const;

    /** Makes `output` the next element and this its previous one. Not real-time safe. */
    virtual bool connectTo(shared_ptr const& output, bool mandatory = true);
    virtual bool connectFrom(shared_ptr const& input);
    /** Name of connectTo() before 2.9. */
    void setOutput(shared_ptr const& output);

    /** Asks, from the reader towards the writer, whether data can flow. A transport overrides one of the two. */
    virtual bool inputReady(shared_ptr const& caller);
    virtual bool inputReady();
    /** Announces, from the writer towards the reader, that the channel is complete. False refuses it. */
    virtual bool channelReady(shared_ptr const& caller, ConnPolicy const& policy, internal::ConnID* id = nullptr);

    /** Drops all samples; passed on towards the writer. */
    virtual void clear();
    /** Signals a new sample to the reader's side. Real-time safe; false if there is no reader. */
    virtual bool signal();

    /** Breaks the chain from here towards the reader (forward) or the writer. The port at that end drops the
        channel. */
    virtual void disconnect(bool forward);
    /** The same, on behalf of the neighbour `channel` (null: all neighbours). */
    virtual bool disconnect(shared_ptr const& channel, bool forward);

    /** The first, and last, element of the chain. */
    shared_ptr getInputEndPoint();
    shared_ptr getOutputEndPoint();
    /** The port of an endpoint; null for all other elements, and when the port is gone. */
    virtual PortInterface* getPort() const;
    /** The policy this element was made for; null if it has none. */
    virtual const ConnPolicy* getConnPolicy() const;

    /** True if the element on the other side of this one lives in another process. */
    virtual bool isRemoteElement() const;
    virtual std::string getRemoteURI() const;
    virtual std::string getLocalURI() const;
    virtual std::string getElementName() const;

    /** The untyped data path, which ports use inside an internal::Reclaimer::Guard. ChannelElement<T> calls its typed
        functions. `sample` points to a sample of the channel's type. Real-time safe if the element is. */
    virtual WriteStatus writeErased(const void* sample);
    virtual FlowStatus readErased(void* sample, bool copyOld);
    /** Sizes the storage; with `reset` also drops all samples. Never makes data visible. Not real-time safe. */
    virtual WriteStatus sampleErased(const void* sample, bool reset);
    /** Copies the last sample given to sampleErased(); false if there was none. Not real-time safe. */
    virtual bool getSampleErased(void* sample);

    /** The storage in this element, for connecting and for statistics; null if it stores nothing. */
    virtual internal::StorageCore* storageCore();

    void ref() { references_.fetch_add(1, std::memory_order_relaxed); }
    /** The last one deletes the element. */
    void deref();

protected:
    /** For ChannelElement::data_sample(): exists while the form with `reset` calls the other one of the same element in
        this thread. Lives on the stack. */
    class RTT_API SampleCall {
    public:
        SampleCall(const ChannelElementBase& element, bool reset);
        ~SampleCall();
        SampleCall(const SampleCall&) = delete;
        SampleCall& operator=(const SampleCall&) = delete;
        /** Null if there is none, or if the innermost one belongs to another element. */
        static const SampleCall* of(const ChannelElementBase& element);
        bool reset() const { return reset_; }

    private:
        const ChannelElementBase& element_;
        const bool reset_;
        const SampleCall* const outer_;
        static thread_local const SampleCall* innermost_;
    };

    /** The neighbour without a reference. Valid only while an internal::Reclaimer::Guard exists. */
    ChannelElementBase* inputUnderGuard() const { return input_.load(std::memory_order_acquire); }
    ChannelElementBase* outputUnderGuard() const { return output_.load(std::memory_order_acquire); }
    /** signal() of this class, for a thread that is inside a Guard already. */
    bool signalUnderGuard() {
        ChannelElementBase* output = outputUnderGuard();
        return output && (output->quiet_.load(std::memory_order_relaxed) || output->signal());
    }
    /** True if signal() of this element has nothing to do, so a writer need not call it. */
    void setQuiet(bool quiet) { quiet_.store(quiet, std::memory_order_relaxed); }
    bool isQuiet() const { return quiet_.load(std::memory_order_relaxed); }

private:
    friend class internal::ConnectionManager;
    friend class internal::StorageCore;
    static void exchangeLink(std::atomic<ChannelElementBase*>& link, ChannelElementBase* to);
    static void dropLink(std::atomic<ChannelElementBase*>& link, ChannelElementBase* expected);

    std::atomic<ChannelElementBase*> input_{nullptr};   // each holds one reference,
    std::atomic<ChannelElementBase*> output_{nullptr};  // released through the Reclaimer
    std::atomic<int> references_{0};
    std::atomic<bool> quiet_{false};
};

inline void intrusive_ptr_add_ref(ChannelElementBase* element) { element->ref(); }
inline void intrusive_ptr_release(ChannelElementBase* element) { element->deref(); }

}  // namespace base
}  // namespace RTT

#endif
