// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An input port without the type of its samples.
#ifndef ORO_INPUT_PORT_INTERFACE_HPP
#define ORO_INPUT_PORT_INTERFACE_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/flow/deferred_calls.hpp>

namespace RTT {
namespace base {
class DataSourceBase;
class OutputPortInterface;

class RTT_API InputPortInterface : public PortInterface {
public:
    InputPortInterface(const std::string& name, const ConnPolicy& default_policy = ConnPolicy(),
                       const types::TypeOps* ops = nullptr);
    ~InputPortInterface() override;

    InputPortInterface* asInput() override { return this; }
    const InputPortInterface* asInput() const override { return this; }

    /** The policy used when connecting without one. */
    const ConnPolicy& getDefaultPolicy() const { return default_policy_; }

    /** Reads into a data source of the port's type; another type gives NoData and logs an error. */
    virtual FlowStatus read(boost::intrusive_ptr<DataSourceBase> source, bool copy_old_data = true);
    /** Drops all samples; NoData until the next write. Real-time safe. */
    virtual void clear();

    /** A new data source that reads the port whenever it is evaluated. */
    virtual DataSourceBase* getDataSource() = 0;

    /** The same as connecting from the output port. */
    bool connectTo(PortInterface* other, ConnPolicy const& policy) override;
    bool connectTo(PortInterface* other) override;
    bool createStream(ConnPolicy const& policy) override;
    bool createConnection(boost::intrusive_ptr<internal::SharedConnectionBase> shared_connection,
                          ConnPolicy const& policy) override;
    using PortInterface::createConnection;

    void addOperationsTo(Service& object) override;

    /** Called last when a connection is made; false refuses it. */
    virtual bool channelReady(ChannelElementBase::shared_ptr const& channel, ConnPolicy const& policy,
                              internal::ConnID* id = nullptr);

    /** For a proxy: connects the port that it stands for. This one logs an error and returns false. */
    virtual bool connectFrom(OutputPortInterface& output, ConnPolicy const& policy);

    /** Turns notification of the component by new samples on or off. */
    void signalInterface(bool on);
    bool signalsInterface() const;
    /** Signals a new sample to the component in the writer's thread; as real-time safe as dataOnPortHook(). */
    void newDataAvailable();
    /** For the port's endpoint, inside a Reclaimer::Guard: newDataAvailable() follows after the Guard. */
    void signalLater();
    /** For a thread that has taken the port out of its component: waits until no other thread signals samples to that,
        and drops this thread's pending signals. With `executesMessages` the components that this thread is executing
        execute their messages meanwhile. One of two threads that wait for each other continues. Not real-time safe. */
    void finishSignals(bool executesMessages = false);

protected:
    // The data path; `sample` points to an object of the port's type. Real-time safe, see InputPort.
    FlowStatus readSample(void* sample, bool copyOld);
    FlowStatus readNewestSample(void* sample, bool copyOld);
    bool copyDataSample(void* sample) const;

private:
    friend class internal::PortLink;
    static void deliverSignal(void*& self);
    bool unpin();
    void forgetSignals();
    FlowStatus readSeveral(const internal::ChannelArray& channels, void* sample, bool copyOld);

    ConnPolicy default_policy_;
    static constexpr std::uint32_t kAgain = 1u << 31;
    std::atomic<std::uint32_t> pinned_{0};  // signals pending or in delivery, and kAgain if one more is owed
    internal::DeferredCalls::Call signal_;  // of the thread that pinned the port first
    // The channel of the last new sample. Only compared with entries of the current list, never dereferenced.
    std::atomic<const ChannelElementBase*> current_{nullptr};
};

}  // namespace base
}  // namespace RTT

#endif
