// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_TEMPLATE_PROTOCOL_HPP
#define ORO_CORBA_TEMPLATE_PROTOCOL_HPP

#include <rtt/Property.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/transports/corba/CorbaTypeTransporter.hpp>
#include <rtt/transports/corba/RTTCorbaConversion.hpp>
#include <rtt/transports/corba/RemoteChannelElement.hpp>

#include <type_traits>
#include <typeinfo>

namespace RTT {
namespace corba {

/**
 * Converts values of T by AnyConversion<T>, whose specialisation must be declared before. Registered for a type by
 * TypeInfo::addProtocol(), it replaces the transporter that knows the type by its members. Any thread may use it;
 * it blocks only if the conversion does.
 */
template <class T>
class CorbaTemplateProtocol : public CorbaTypeTransporter {
public:
    typedef T UserType;
    typedef typename std::remove_cv<typename std::remove_reference<T>::type>::type PropertyType;

    /** Null if the source has another type, or if the conversion fails. */
    CORBA::Any_ptr createAny(base::DataSourceBase::shared_ptr source) const override {
        const PropertyType* const value = valueOf(source);
        return value ? AnyConversion<PropertyType>::createAny(*value) : nullptr;
    }
    bool updateAny(base::DataSourceBase::shared_ptr source, CORBA::Any& any) const override {
        const PropertyType* const value = valueOf(source);
        return value && AnyConversion<PropertyType>::updateAny(*value, any);
    }
    base::DataSourceBase::shared_ptr createDataSource(const CORBA::Any* any) const override {
        const typename internal::ValueDataSource<PropertyType>::shared_ptr made =
            internal::ValueDataSource<PropertyType>::make();
        if (!any || !isUpdated(*any, made->set())) return nullptr;
        return made;
    }
    bool updateFromAny(const CORBA::Any* any, base::DataSourceBase::shared_ptr target) const override {
        auto* const typed = internal::AssignableDataSource<PropertyType>::narrow(target.get());
        if (!any || !typed || !isUpdated(*any, typed->set())) return false;
        typed->updated();
        return true;
    }
    /** The caller owns it. */
    CRemoteChannelElement_i* createChannelElement_i(DataFlowInterface* sender, PortableServer::POA_ptr poa,
                                                    const ConnPolicy& policy) const override {
        return new RemoteChannelElement<PropertyType>(*this, sender, poa, policy);
    }

private:
    /** Also of a source of a reference. */
    static const PropertyType* valueOf(const base::DataSourceBase::shared_ptr& source) {
        const std::type_info* const id = source ? source->getTypeId() : nullptr;
        return id && *id == typeid(PropertyType) ? static_cast<const PropertyType*>(source->getRawConstPointer())
                                                 : nullptr;
    }
    /** The data may come from anybody. */
    static bool isUpdated(const CORBA::Any& any, PropertyType& value) {
        try {
            return AnyConversion<PropertyType>::update(any, value);
        } catch (const CORBA::Exception&) {
            return false;
        }
    }
};

}  // namespace corba
}  // namespace RTT

#endif
