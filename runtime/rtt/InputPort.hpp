// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The reading end of connections, for samples of T.
#ifndef ORO_INPUT_PORT_HPP
#define ORO_INPUT_PORT_HPP

#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/DataSourceTypeInfo.hpp>
#include <rtt/types/Schema.hpp>
#include <rtt/types/TypeOps.hpp>

namespace RTT {
template <typename T>
class OutputPort;

/** Reading is real-time safe unless a connection's policy says LOCKED, allocates only where assigning a T does, and
    never blocks. It is meant for the component's own thread. If several threads read, each new sample is new for one of
    them. */
template <typename T>
class InputPort : public base::InputPortInterface {
public:
    typedef T value_t;
    typedef T& reference_t;

    /** The compiler fills in the schema, the definition of T in the plugin that makes the port. */
    [[gnu::cold]] InputPort(const std::string& name = "unnamed",
                            const ConnPolicy& default_policy = internal::policyOfPorts(),
                            const types::Schema& schema = types::schemaOf<T>())
        : base::InputPortInterface(name, default_policy, &types::typeOps<T>()) {
        static_assert(types::isSample<T>,
                      "a port makes, copies and assigns samples: this type lacks a default constructor or the copying "
                      "operations, or has a constant member");
        this->setSampleSchema(schema);
    }
    /** Waits for a callback that is using this port in another thread. */
    ~InputPort() override { this->leaveInterface(); }

    /** NewData: a sample that was never read before. OldData: there is no new one, and `sample` is the last one again
        unless copy_old_data is false. NoData: no sample was written yet; `sample` is unchanged. */
    FlowStatus read(reference_t sample, bool copy_old_data = true) { return readSample(&sample, copy_old_data); }
    using base::InputPortInterface::read;
    /** Reads all samples that exist when it begins and gives the last one; NewData if any was new. */
    FlowStatus readNewest(reference_t sample, bool copy_old_data = true) {
        return readNewestSample(&sample, copy_old_data);
    }
    /** A sample of the size of the writer's setDataSample(); `sample` is unchanged if there is none. */
    void getDataSample(reference_t sample) { copyDataSample(&sample); }
    /** The storage that all connections of this port share with the policy PerInputPort or Shared; null if there is
        none. Not real-time safe. */
    [[gnu::cold]] typename base::ChannelElement<T>::shared_ptr getSharedBuffer() const {
        return boost::dynamic_pointer_cast<base::ChannelElement<T>>(this->sharedStorage());
    }

    const types::TypeInfo* getTypeInfo() const override { return internal::DataSourceTypeInfo<T>::getTypeInfo(); }
    [[gnu::cold]] InputPort<T>* clone() const override;
    [[gnu::cold]] base::PortInterface* antiClone() const override;
    /** A new data source of T that reads this port at each evaluation. */
    [[gnu::cold]] base::DataSourceBase* getDataSource() override;
    [[gnu::cold]] void addOperationsTo(Service& object) override;
    [[gnu::cold]] base::ChannelElementBase::shared_ptr buildStorage(ConnPolicy const& policy) const override;
};

}  // namespace RTT

#include <rtt/internal/flow/ports_inl.hpp>

#endif
