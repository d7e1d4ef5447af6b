// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Members of the ports that are not on the data path. Not inline, so that `extern template class` keeps them out of users'
// translation units.
#ifndef ORO_INTERNAL_PORTS_INL_HPP
#define ORO_INTERNAL_PORTS_INL_HPP

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Service.hpp>
#include <rtt/internal/PortSources.hpp>

namespace RTT {

template <typename T>
InputPort<T>* InputPort<T>::clone() const {
    return new InputPort<T>(getName(), getDefaultPolicy());
}

template <typename T>
base::PortInterface* InputPort<T>::antiClone() const {
    return new OutputPort<T>(getName());
}

template <typename T>
base::DataSourceBase* InputPort<T>::getDataSource() {
    return new internal::PortSource<T, InputPort<T>>(getEndpoint());
}

template <typename T>
base::ChannelElementBase::shared_ptr InputPort<T>::buildStorage(ConnPolicy const& policy) const {
    return internal::ConnFactory::buildStorage<T>(policy, nullptr);
}

template <typename T>
Service* InputPort<T>::createPortObject() {
    Service* object = base::InputPortInterface::createPortObject();
    object->addSynchronousOperation("read", &InputPort<T>::readOperation, this)
        .doc("Reads a sample from the port.")
        .arg("sample", "Where the sample goes.");
    return object;
}

template <typename T>
T OutputPort<T>::getLastWrittenValue() const {
    T value = T();
    copyLastWritten(&value);
    return value;
}

template <typename T>
OutputPort<T>* OutputPort<T>::clone() const {
    return new OutputPort<T>(getName(), keepsLastWrittenValue());
}

template <typename T>
base::PortInterface* OutputPort<T>::antiClone() const {
    return new InputPort<T>(getName());
}

template <typename T>
base::DataSourceBase* OutputPort<T>::getDataSource() const {
    return new internal::PortSource<T, const OutputPort<T>>(getEndpoint());
}

template <typename T>
base::ChannelElementBase::shared_ptr OutputPort<T>::buildStorage(ConnPolicy const& policy) const {
    return internal::ConnFactory::buildStorage<T>(policy, nullptr);
}

template <typename T>
Service* OutputPort<T>::createPortObject() {
    Service* object = base::OutputPortInterface::createPortObject();
    object->addSynchronousOperation("write", &OutputPort<T>::writeOperation, this)
        .doc("Writes a sample to the port.")
        .arg("sample", "The sample.");
    object->addSynchronousOperation("last", &OutputPort<T>::lastOperation, this)
        .doc("Gives the last written value, a default one if there is none.");
    return object;
}

}  // namespace RTT

#endif
