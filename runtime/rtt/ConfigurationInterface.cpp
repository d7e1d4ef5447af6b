// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/ConfigurationInterface.hpp>

#include <rtt/Logger.hpp>

#include <algorithm>
#include <memory>

namespace RTT {

ConfigurationInterface::~ConfigurationInterface() { clear(); }

bool ConfigurationInterface::addAttribute(base::AttributeBase& attribute) {
    return attribute.getDataSource() && setValue(attribute.clone());
}

bool ConfigurationInterface::addConstant(base::AttributeBase& constant) { return addAttribute(constant); }

bool ConfigurationInterface::addProperty(base::PropertyBase& property) {
    if (!hasProperty(property.getName())) return bag_.addProperty(property);
    log(Error) << "property '" << property.getName() << "' was not added: there is one of that name already"
               << endlog();
    return false;
}

void ConfigurationInterface::ownProperty(base::PropertyBase* property) {
    if (hasProperty(property->getName()))
        log(Warning) << "there are two properties named '" << property->getName()
                     << "'; only the first can be found by name" << endlog();
    bag_.ownProperty(property);
}

bool ConfigurationInterface::setValue(base::AttributeBase* attribute) {
    std::unique_ptr<base::AttributeBase> owned(attribute);
    if (!owned || owned->getName().empty() || !owned->getDataSource()) return false;
    values_.push_back(owned.release());
    return true;
}

void ConfigurationInterface::ownValue(base::AttributeBase* value) {
    (value->getName().empty() ? nameless_ : values_).push_back(value);
}

base::AttributeBase* ConfigurationInterface::getValue(const std::string& name) const {
    const auto found =
        std::find_if(values_.begin(), values_.end(), [&](auto* value) { return value->getName() == name; });
    return found == values_.end() ? nullptr : *found;
}

bool ConfigurationInterface::removeValue(const std::string& name) {
    const auto found =
        std::find_if(values_.begin(), values_.end(), [&](auto* value) { return value->getName() == name; });
    if (found == values_.end()) return false;
    delete *found;
    values_.erase(found);
    return true;
}

ConfigurationInterface::AttributeNames ConfigurationInterface::getAttributeNames() const {
    AttributeNames names;
    for (const base::AttributeBase* value : values_) names.push_back(value->getName());
    return names;
}

void ConfigurationInterface::loadValues(const AttributeObjects& values) {
    for (base::AttributeBase* value : values) setValue(value);
}

bool ConfigurationInterface::removeProperty(base::PropertyBase& property) { return bag_.removeProperty(&property); }

void ConfigurationInterface::clear() {
    for (AttributeObjects* const values : {&values_, &nameless_}) {
        for (base::AttributeBase* value : *values) delete value;
        values->clear();
    }
    bag_.clear();
}

}  // namespace RTT
