// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "described_values.hpp"

#include "missing_typekits.hpp"
#include "xml_to_plan.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/internal/values/property_update.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <boost/core/demangle.hpp>

#include <cstring>
#include <map>

namespace OCL::deploy {
namespace {

using RTT::PropertyBag;
using RTT::base::PropertyBase;

class ValueCheck {
public:
    ValueCheck(const ComponentPlan& component, const RTT::internal::ComponentDescription& description,
               PropertyFiles& files, diag::Sink& sink)
        : component_(component), files_(files), sink_(sink) {
        for (const auto& property : description.properties) {
            if (std::strchr(property.name, '.')) continue;  // of a service
            const auto* type = RTT::types::TypeInfoRepository::Instance()->getTypeById(property.type);
            PropertyBase* const made = type ? type->buildProperty(property.name, "") : nullptr;
            if (made)
                properties_.ownProperty(made);
            else
                unknown_[property.name] = property.type;
        }
    }

    void checkStruct(const xml::Element& properties) {
        PropertyBag read;
        RTT::marsh::Places places;
        diag::Sink reported;  // errors were reported when the file was read
        (void)RTT::marsh::readBag(properties, read, reported, &places);
        RTT::internal::detail::BagUpdate how;
        how.addMissing = true;  // bags are meant to be filled
        how.report = [&](const PropertyBase* where, const std::string& text) {
            sink_.error(places.at(where), "DEP052", owner() + ": " + text);
        };
        for (const PropertyBase* item : read)
            if (PropertyBase* const target = properties_.find(item->getName()))
                (void)RTT::internal::detail::updateOne(*target, *item, how);
            else
                checkType(item->getName(), places.at(item));
    }

    void checkFile(const PropertyFilePlan& file) {
        const auto* read = whyUnreadable(file.file).empty() ? files_.readAgain(resolveFile(file.file)) : nullptr;
        if (!read) return;
        for (const PropertyBase* item : read->bag) checkType(item->getName(), read->places.at(item));
        (void)RTT::marsh::loadFrom(*read, properties_, RTT::marsh::LoadMode::refresh, sink_);
    }

private:
    std::string owner() const { return "component '" + component_.name.value + "'"; }

    void checkType(const std::string& name, const diag::Location& where) {
        const auto found = unknown_.find(name);
        if (found == unknown_.end()) return;
        sink_
            .error(where, "DEP065",
                   owner() + ": no loaded typekit has the type '" + boost::core::demangle(found->second->name()) +
                       "' of property '" + name + "'")
            .hint(typekitAdvice(*found->second));
    }

    const ComponentPlan& component_;
    PropertyFiles& files_;
    diag::Sink& sink_;
    PropertyBag properties_;
    std::map<std::string, const std::type_info*> unknown_;  // types in no typekit, by property
};

}  // namespace

void checkDescribedValues(const ComponentPlan& component, const RTT::internal::ComponentDescription& description,
                          PropertyFiles& files, diag::Sink& sink) {
    ValueCheck check(component, description, files, sink);
    for (const xml::Element& properties : component.properties) check.checkStruct(properties);
    for (const PropertyFilePlan& file : component.propertyFiles) check.checkFile(file);
}

}  // namespace OCL::deploy
