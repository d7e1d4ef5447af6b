// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "properties.hpp"

#include "read_value.hpp"
#include "report.hpp"
#include "xml_to_plan.hpp"

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/detail/property_file.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace OCL::deploy {
namespace {

using RTT::base::PropertyBase;

/** Sets the properties of `target` that the struct names. `owner` is for messages. */
void applyStruct(const xml::Element& properties, RTT::PropertyBag& target, const std::string& owner, diag::Sink& sink) {
    for (const xml::Element& element : properties.children) {
        const Text name = nameOf(element);
        PropertyBase* property = element.name == "description" ? nullptr : target.find(name.value);
        if (!property) continue;
        RTT::PropertyBag read;
        xml::Element one;
        one.name = "struct";
        one.children.push_back(element);
        if (!RTT::marsh::readBag(one, read, sink) || read.empty()) continue;
        if (!property->refresh(read.getItem(0)))
            sink.error(element.where, "DEP052",
                       "property '" + name.value + "' of " + owner + " is of type '" + property->getType() +
                           "', found a value of type '" + read.getItem(0)->getType() + "'");
    }
}

RTT::marsh::LoadMode modeOf(const PropertyFilePlan& file) {
    switch (file.mode) {
        case PropertyFilePlan::Strict: return RTT::marsh::LoadMode::strictRefresh;
        case PropertyFilePlan::Update: return RTT::marsh::LoadMode::refresh;
        case PropertyFilePlan::Load: return RTT::marsh::LoadMode::load;
    }
    return RTT::marsh::LoadMode::refresh;
}

}  // namespace

void applyProperties(Record& record, diag::Sink& sink) {
    for (const xml::Element& properties : record.plan.properties)
        applyStruct(properties, *record.instance->properties(), "component '" + record.name + "'", sink);
    for (const PropertyFilePlan& file : record.plan.propertyFiles) {
        if (RTT::marsh::loadFromFile(*record.instance->properties(), resolveFile(file.file), modeOf(file), sink))
            record.loadedFile = file.file;
        else
            sink.error(
                file.file.where, "DEP052",
                "could not set the properties of component '" + record.name + "' from '" + file.file.value + "'");
    }
}

void autoSave(const Record& record) {
    if (!record.plan.autoSave.value_or(false)) return;
    if (record.loadedFile.empty()) {
        RTT::log(RTT::Error) << "AutoSave of component '" << record.name
                             << "': no property file was loaded that could be written" << RTT::endlog();
        return;
    }
    const std::string path = resolveFile(record.loadedFile);
    diag::Sink sink;
    if (RTT::marsh::saveToFile(*record.instance->properties(), path, RTT::marsh::SaveMode::merge, sink))
        RTT::log(RTT::Info) << "saved the properties of component '" << record.name << "' to " << path << RTT::endlog();
    else
        RTT::log(RTT::Error) << "could not save the properties of component '" << record.name << "' to " << path
                             << RTT::endlog();
    report(sink);
}

void applyGlobals(const std::vector<xml::Element>& globals, diag::Sink& sink) {
    for (const xml::Element& properties : globals)
        applyStruct(properties, *RTT::types::GlobalsRepository::Instance()->properties(), "the process", sink);
}

}  // namespace OCL::deploy
