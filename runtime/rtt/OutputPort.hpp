// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The writing end of connections, for samples of T.
#ifndef ORO_OUTPUT_PORT_HPP
#define ORO_OUTPUT_PORT_HPP

#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/ConnFactory.hpp>
#include <rtt/internal/DataSourceTypeInfo.hpp>
#include <rtt/types/Schema.hpp>
#include <rtt/types/TypeOps.hpp>

namespace RTT {
template <typename T>
class InputPort;

/** Writing is real-time safe unless a connection's policy says LOCKED, allocates only where assigning a T does (avoid
    that by setDataSample()), and never blocks. Several threads may write. */
template <typename T>
class OutputPort : public base::OutputPortInterface {
public:
    typedef T value_t;
    typedef const T& param_t;
    typedef T& reference_t;

    /** The compiler fills in the schema, the definition of T in the plugin that makes the port. */
    [[gnu::cold]] OutputPort(const std::string& name = "unnamed", bool keep_last_written_value = true,
                             const types::Schema& schema = types::schemaOf<T>())
        : base::OutputPortInterface(name, &types::typeOps<T>(), keep_last_written_value) {
        static_assert(types::isSample<T>,
                      "a port makes, copies and assigns samples: this type lacks a default constructor or the copying "
                      "operations, or has a constant member");
        this->setSampleSchema(schema);
    }

    /** NotConnected if there is no connection, WriteFailure if a mandatory one did not take it, or WriteSuccess. */
    WriteStatus write(param_t sample) { return writeSample(&sample); }
    using base::OutputPortInterface::write;
    /** Sizes the storage of all connections, also later ones, for samples like this one. Readers never see it; drops
        samples that they have not read yet, and the last written value. Not real-time safe. */
    void setDataSample(param_t sample) { setSample(&sample); }

    /** A default value if no value was written or kept. */
    value_t getLastWrittenValue() const;
    /** False, with `sample` unchanged, if no value was written or kept. */
    bool getLastWrittenValue(reference_t sample) const { return copyLastWritten(&sample); }

    /** The storage that all connections of this port share with the policy PerOutputPort or Shared; null if there is
        none. Not real-time safe. */
    [[gnu::cold]] typename base::ChannelElement<T>::shared_ptr getSharedBuffer() const {
        return boost::dynamic_pointer_cast<base::ChannelElement<T>>(this->sharedStorage());
    }

    const types::TypeInfo* getTypeInfo() const override { return internal::DataSourceTypeInfo<T>::getTypeInfo(); }
    [[gnu::cold]] OutputPort<T>* clone() const override;
    [[gnu::cold]] base::PortInterface* antiClone() const override;
    /** A new data source of T that gives the last written value. */
    [[gnu::cold]] base::DataSourceBase* getDataSource() const override;
    [[gnu::cold]] void addOperationsTo(Service& object) override;
    [[gnu::cold]] base::ChannelElementBase::shared_ptr buildStorage(ConnPolicy const& policy) const override;
};

}  // namespace RTT

#include <rtt/internal/flow/ports_inl.hpp>

#endif
