// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_CONN_FACTORY_HPP
#define ORO_TEMPLATE_CONN_FACTORY_HPP

#include "TypeThunks.hpp"

namespace RTT {
namespace types {

/** A port factory that uses the thunks of T, for classes that are passed to TypeInfo::setPortFactory(). */
template <class T>
class TemplateConnFactory : public internal::ConnFactory {
public:
    base::InputPortInterface* inputPort(const std::string& name) const override { return new InputPort<T>(name); }
    base::OutputPortInterface* outputPort(const std::string& name) const override { return new OutputPort<T>(name); }
    base::ChannelElementBase::shared_ptr buildDataStorage(const ConnPolicy& policy) const override {
        return internal::ConnFactory::buildDataStorage<T>(policy);
    }
};

}  // namespace types
}  // namespace RTT

#endif
