// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An output port without the type of its samples.
#ifndef ORO_OUTPUT_PORT_INTERFACE_HPP
#define ORO_OUTPUT_PORT_INTERFACE_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/base/PortInterface.hpp>

namespace RTT {
namespace internal {
struct ChannelArray;
class SampleBox;
class SampleStore;
}  // namespace internal
namespace base {
class DataSourceBase;
class InputPortInterface;

class RTT_API OutputPortInterface : public PortInterface {
public:
    OutputPortInterface(const std::string& name, const types::TypeOps* ops = nullptr, bool keep_last = false);
    ~OutputPortInterface() override;

    OutputPortInterface* asOutput() override { return this; }
    const OutputPortInterface* asOutput() const override { return this; }

    /** Writes the value of a data source of the port's type; any other gives WriteFailure and an error. */
    virtual WriteStatus write(boost::intrusive_ptr<DataSourceBase> source);

    /** Whether write() keeps its value, for new connections with `init` and for getLastWrittenValue(). Switching on
        allocates. */
    void keepLastWrittenValue(bool keep);
    /** Keeps only the value of the next write(). */
    void keepNextWrittenValue(bool keep);
    bool keepsNextWrittenValue() const { return keep_next_.load(std::memory_order_relaxed); }
    bool keepsLastWrittenValue() const { return keep_last_.load(std::memory_order_relaxed); }
    /** True if a value was written and is kept. Real-time safe. */
    bool hasLastWrittenValue() const { return has_last_.load(std::memory_order_acquire); }
    /** Drops the last written value, and empties the storage that this port owns or shares. */
    virtual void clear();

    /** A new data source that gives the last written value. */
    virtual DataSourceBase* getDataSource() const = 0;

    virtual bool createConnection(InputPortInterface& sink, ConnPolicy const& policy);
    bool createConnection(InputPortInterface& sink);
    bool createDataConnection(InputPortInterface& sink, int lock_policy = ConnPolicy::LOCK_FREE);
    bool createBufferConnection(InputPortInterface& sink, int size, int lock_policy = ConnPolicy::LOCK_FREE);
    bool createConnection(boost::intrusive_ptr<internal::SharedConnectionBase> shared_connection,
                          ConnPolicy const& policy) override;
    using PortInterface::createConnection;
    bool connectTo(PortInterface* other, ConnPolicy const& policy) override;
    bool connectTo(PortInterface* other) override;
    bool createStream(ConnPolicy const& policy) override;

    bool addConnection(internal::ConnID* id, ChannelElementBase::shared_ptr channel, ConnPolicy const& policy) override;

    /** Gives a new channel the sample that sizes it and, if `init`, the last written value. Not real-time safe. */
    bool initialise(ChannelElementBase& channel, bool init);

protected:
    // The data path; `sample` points to an object of the port's type. Real-time safe, see OutputPort.
    WriteStatus writeSample(const void* sample);
    bool copyLastWritten(void* sample) const;
    void setSample(const void* sample);

private:
    friend class internal::PortLink;
    void allocateLast();
    void remember(const void* sample);
    class DeadChannels;
    static WriteStatus writeToAll(const internal::ChannelArray& channels, const void* sample, DeadChannels& dead);
    WriteStatus dropDead(const DeadChannels& dead, WriteStatus worst);

    std::atomic<bool> keep_last_{false};
    std::atomic<bool> keep_next_{false};
    std::atomic<bool> has_last_{false};
    std::atomic<internal::SampleStore*> last_{nullptr};   // made when first needed; exists as long as the port
    std::shared_ptr<const internal::SampleBox> initial_;  // of setDataSample(); std::atomic_load/store only
};

}  // namespace base
}  // namespace RTT

#endif
