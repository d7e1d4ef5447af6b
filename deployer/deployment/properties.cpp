// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "properties.hpp"

#include "report.hpp"
#include "shutdown.hpp"
#include "xml_to_plan.hpp"

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/values/property_update.hpp>
#include <rtt/types/GlobalsRepository.hpp>

namespace OCL::deploy {
namespace {

using RTT::base::PropertyBase;

/** Sets the properties of `target` that the struct names, one element after another. If `target` lacks one of those in
    `users`, adds it first. `owner` is for messages. */
void applyStruct(const xml::Element& properties, RTT::PropertyBag& target, const std::vector<std::string>& users,
                 const std::string& owner, diag::Sink& sink) {
    RTT::PropertyBag read;
    RTT::marsh::Places places;
    diag::Sink unused;  // errors were reported when the file was read
    (void)RTT::marsh::readBag(properties, read, unused, &places);
    for (const std::string& name : users)
        if (const PropertyBase* const given = target.find(name) ? nullptr : read.find(name))
            target.ownProperty(given->clone());
    RTT::internal::detail::BagUpdate how;
    how.report = [&](const PropertyBase* where, const std::string& text) {
        sink.error(places.at(where), "DEP052", owner + ": " + text);
    };
    how.addMissing = how.fillDescriptions = true;  // within properties: bags are meant to be filled
    RTT::internal::detail::NamePairing pairing(read);
    for (PropertyBase* const property : target)
        for (std::size_t next; (next = pairing.next(property->getName())) < read.size();)
            (void)RTT::internal::detail::updateOne(*property, *read.getItem(next), how);
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

void applyProperties(const Session& session, ComponentRecord& record, diag::Sink& sink) {
    std::vector<std::string> users;
    if (record.instance == session.deployer) users = shutdownProperties();
    for (const xml::Element& properties : record.plan.properties)
        applyStruct(properties, *record.instance->properties(), users, "component '" + record.name + "'", sink);
    for (const PropertyFilePlan& file : record.plan.propertyFiles) {
        const auto* read = session.propertyFiles->read(resolveFile(file.file), sink);
        if (read && RTT::marsh::loadFrom(*read, *record.instance->properties(), modeOf(file), sink))
            record.loadedFile = file.file;
        else
            sink.error(
                file.file.where, "DEP052",
                "could not set the properties of component '" + record.name + "' from '" + file.file.value + "'");
    }
}

void autoSave(const ComponentRecord& record) {
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
        applyStruct(properties, *RTT::types::GlobalsRepository::Instance()->properties(), {}, "the process", sink);
}

}  // namespace OCL::deploy
