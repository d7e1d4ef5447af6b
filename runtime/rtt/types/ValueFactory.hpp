// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_VALUE_FACTORY_HPP
#define ORO_VALUE_FACTORY_HPP

#include <rtt/base/DataSourceBase.hpp>

namespace RTT {
namespace base {
class AttributeBase;
class PropertyBase;
}  // namespace base

namespace types {

/** Makes values, variables and properties of one type, in place of the thunks of its TypeInfo. */
class RTT_API ValueFactory {
public:
    virtual ~ValueFactory();

    virtual base::AttributeBase* buildConstant(std::string name, base::DataSourceBase::shared_ptr value,
                                               int sizehint) const = 0;
    virtual base::AttributeBase* buildVariable(std::string name, int sizehint) const = 0;
    virtual base::AttributeBase* buildAlias(std::string name, base::DataSourceBase::shared_ptr source) const = 0;
    virtual base::DataSourceBase::shared_ptr buildActionAlias(base::ActionInterface* action,
                                                              base::DataSourceBase::shared_ptr source) const = 0;
    virtual base::PropertyBase* buildProperty(const std::string& name, const std::string& description,
                                              base::DataSourceBase::shared_ptr source = nullptr) const = 0;
    virtual base::AttributeBase* buildAttribute(std::string name,
                                                base::DataSourceBase::shared_ptr source = nullptr) const = 0;
    virtual base::DataSourceBase::shared_ptr buildValue() const = 0;
    virtual base::DataSourceBase::shared_ptr buildReference(void* value) const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
