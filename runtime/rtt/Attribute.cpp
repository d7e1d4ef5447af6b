// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Attribute.hpp"

namespace RTT {

base::AttributeBase::~AttributeBase() = default;

const std::string& base::AttributeBase::nameOf(const AttributeBase* other) {
    static const std::string none;
    return other ? other->mname : none;
}

Alias::Alias(const std::string& name, base::DataSourceBase::shared_ptr source) : AttributeBase(name), data(source) {}

base::DataSourceBase::shared_ptr Alias::getDataSource() const { return data; }

Alias* Alias::clone() const { return new Alias(mname, data); }

Alias* Alias::copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& replacements, bool) const {
    return new Alias(mname, data->copy(replacements));
}

}  // namespace RTT
