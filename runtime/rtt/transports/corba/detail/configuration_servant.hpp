// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_CONFIGURATION_SERVANT_HPP
#define ORO_CORBA_DETAIL_CONFIGURATION_SERVANT_HPP

#include <rtt/transports/corba/detail/service_part.hpp>

namespace RTT {
namespace corba {
namespace detail {

/** The properties and attributes of a service. */
class ConfigurationServant : public virtual POA_RTT::corba::CConfigurationInterface, protected virtual ServicePart {
public:
    /** ServiceServant makes the ServicePart. */
    ConfigurationServant() : ServicePart(nullptr, nullptr) {}

    corba::CConfigurationInterface::CAttributeNames* getAttributeList() override;
    corba::CConfigurationInterface::CPropertyNames* getPropertyList() override;
    CORBA::Any* getAttribute(const char* name) override;
    CORBA::Boolean setAttribute(const char* name, const CORBA::Any& value) override;
    CORBA::Boolean hasAttribute(const char* name) override;
    CORBA::Boolean hasProperty(const char* name) override;
    CORBA::Any* getProperty(const char* name) override;
    CORBA::Boolean setProperty(const char* name, const CORBA::Any& value) override;
    char* getPropertyType(const char* name) override;
    char* getAttributeType(const char* name) override;
    char* getPropertyTypeName(const char* name) override;
    char* getAttributeTypeName(const char* name) override;
    char* attributeToString(const char* name) override;
    char* propertyToString(const char* name) override;
    CORBA::Boolean attributeFromString(const char* name, const char* value) override;
    CORBA::Boolean propertyFromString(const char* name, const char* value) override;
    CORBA::Boolean isAttributeAssignable(const char* name) override;

private:
    typedef base::DataSourceBase::shared_ptr Source;
    /** Null if there is none. */
    Source attribute(const std::string& name) const;
    Source property(const std::string& name) const;
    CORBA::Any* valueOf(const Source& source, const char* kind, const char* name) const;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
