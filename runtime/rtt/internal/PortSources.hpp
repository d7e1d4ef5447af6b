// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources that read an input port, or give the last value written to an output port.
#ifndef ORO_INTERNAL_PORT_SOURCES_HPP
#define ORO_INTERNAL_PORT_SOURCES_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/PortEndpoint.hpp>

#include <map>

namespace RTT {
namespace internal {

/** Shared by both: P is the port class, which has `bool sourceValue(T&)`. When the port is gone the last value stays. */
template <typename T, typename P>
class PortSource : public DataSource<T> {
public:
    typedef typename DataSource<T>::result_t result_t;
    typedef typename DataSource<T>::const_reference_t const_reference_t;

    explicit PortSource(base::ChannelElementBase::shared_ptr endpoint) : endpoint_(endpoint), value_() {}

    /** False if the port has no value, or is gone. */
    bool evaluate() const override {
        P* port = static_cast<P*>(endpoint_->getPort());
        return port && port->sourceValue(value_);
    }
    result_t get() const override {
        evaluate();
        return value_;
    }
    result_t value() const override { return value_; }
    const_reference_t rvalue() const override { return value_; }

    PortSource* clone() const override { return new PortSource(endpoint_); }
    PortSource* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return const_cast<PortSource*>(this);
    }

private:
    base::ChannelElementBase::shared_ptr endpoint_;
    mutable T value_;
};

}  // namespace internal
}  // namespace RTT

#endif
