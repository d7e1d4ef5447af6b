// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Members of ports outside the data path. Not inline, so that `extern template class` keeps them out of users'
// translation units.
#ifndef ORO_INTERNAL_PORTS_INL_HPP
#define ORO_INTERNAL_PORTS_INL_HPP

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#ifndef ORO_TYPEKIT_SOURCE  // generated sources describe types, and are compiled by the hundred
#include <rtt/Service.hpp>
#endif
#include <rtt/internal/flow/port_operations.hpp>

namespace RTT {

template <typename T>
InputPort<T>* InputPort<T>::clone() const {
    return new InputPort<T>(getName(), getDefaultPolicy(), *sampleSchema());
}

template <typename T>
base::PortInterface* InputPort<T>::antiClone() const {
    return new OutputPort<T>(getName(), true, *sampleSchema());
}

template <typename T>
base::DataSourceBase* InputPort<T>::getDataSource() {
    return internal::makePortSource<T>(internal::PortLink(*this), false);
}

template <typename T>
base::ChannelElementBase::shared_ptr InputPort<T>::buildStorage(ConnPolicy const& policy) const {
    return internal::ChannelStorage<T>::make(policy);
}

template <typename T>
void InputPort<T>::addOperationsTo(Service& object) {
    base::InputPortInterface::addOperationsTo(object);
    internal::PortOperation::addRead(object, *this, new internal::PortCaller<FlowStatus(T&)>(),
                                     internal::PortTables<T>::read);
}

template <typename T>
T OutputPort<T>::getLastWrittenValue() const {
    T value = T();
    copyLastWritten(&value);
    return value;
}

template <typename T>
OutputPort<T>* OutputPort<T>::clone() const {
    return new OutputPort<T>(getName(), keepsLastWrittenValue(), *sampleSchema());
}

template <typename T>
base::PortInterface* OutputPort<T>::antiClone() const {
    return new InputPort<T>(getName(), internal::policyOfPorts(), *sampleSchema());
}

template <typename T>
base::DataSourceBase* OutputPort<T>::getDataSource() const {
    return internal::makePortSource<T>(internal::PortLink(*this), false);
}

template <typename T>
base::ChannelElementBase::shared_ptr OutputPort<T>::buildStorage(ConnPolicy const& policy) const {
    return internal::ChannelStorage<T>::make(policy);
}

template <typename T>
void OutputPort<T>::addOperationsTo(Service& object) {
    base::OutputPortInterface::addOperationsTo(object);
    internal::PortOperation::addWrite(object, *this, new internal::PortCaller<WriteStatus(const T&)>(),
                                      internal::PortTables<T>::write);
    internal::PortOperation::addLast(object, *this, new internal::PortCaller<T()>(), internal::PortTables<T>::last);
}

}  // namespace RTT

#endif
