// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>

namespace RTT::types::builtin {

namespace {

/** The members of a bag are its properties, so each bag has its own. */
class BagInfo : public TemplateTypeInfo<PropertyBag, true>, public MemberFactory {
public:
    BagInfo() : TemplateTypeInfo<PropertyBag, true>("PropertyBag") {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<PropertyBag, true>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<BagInfo>(getSharedPtr()));
        return false;
    }
    using MemberFactory::getMember;
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               const std::string& name) const override {
        const auto* bag = static_cast<const PropertyBag*>(types::detail::valueOfType(item, typeid(PropertyBag)));
        const base::PropertyBase* property = bag ? bag->find(name) : nullptr;
        return property ? property->getDataSource() : nullptr;
    }
};

}  // namespace

void addBags() { Types()->addType(new BagInfo()); }

}  // namespace RTT::types::builtin
