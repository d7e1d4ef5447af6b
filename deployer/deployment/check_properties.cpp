// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "check_properties.hpp"

#include "read_value.hpp"
#include "session.hpp"
#include "shutdown.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/values/property_update.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <iterator>

namespace OCL::deploy {
namespace {

using RTT::PropertyBag;
using RTT::base::DataSourceBase;
using RTT::base::PropertyBase;
using RTT::internal::detail::bagOf;
using RTT::types::TypeInfo;

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/** The members of the type, and those with which its values are written to files. */
std::vector<std::string> memberNames(const TypeInfo& type, const DataSourceBase::shared_ptr& value) {
    std::vector<std::string> names = type.getMemberNames();
    const DataSourceBase::shared_ptr written = type.decomposeType(value);
    if (!written || !written->getTypeId() || *written->getTypeId() != typeid(PropertyBag)) return names;
    for (const std::string& name : static_cast<const PropertyBag*>(written->getRawConstPointer())->list())
        if (!contains(names, name)) names.push_back(name);
    return names;
}

/** True if at least one known name is given, perhaps misspelt. */
bool resembles(const PropertyBag& given, const std::vector<std::string>& known) {
    return std::any_of(given.begin(), given.end(), [&](const PropertyBase* item) {
        return contains(known, item->getName()) || diag::nearestMatch(item->getName(), known);
    });
}

/** True if at most one letter is wrong, or two of a long name; more could be another name. */
bool isSlipOf(const std::string& name, const std::vector<std::string>& known) {
    const std::size_t most = name.size() < 8 ? 1 : 2;
    return std::any_of(known.begin(), known.end(),
                       [&](const std::string& one) { return diag::editDistance(name, one) <= most; });
}

bool isSequence(const TypeInfo& type) { return type.getMemberNames() == std::vector<std::string>{"size", "capacity"}; }

/** Looks for given members that do not exist, which the runtime ignores. */
class MemberCheck {
public:
    /** `grows`: members are added to bags of the component. */
    MemberCheck(const ComponentRecord& record, const RTT::marsh::Places& places, bool grows, diag::Sink& sink)
        : record_(record), places_(places), grows_(grows), sink_(sink) {}

    void checkItem(const PropertyBase& item, const PropertyBase& target, const std::string& path) {
        const PropertyBag* const given = bagOf(item);
        if (!given) return;
        if (const PropertyBag* const bag = bagOf(target))
            checkBag(*given, *bag, path);
        else if (target.getTypeInfo())
            checkMembers(*given, *target.getTypeInfo(), path);
    }

    void ignored(const PropertyBase& item, const std::string& what, const std::vector<std::string>& known) {
        sink_.warning(places_.at(&item), "DEP058",
                      "ignored: " + what + " '" + item.getName() + "'" + diag::didYouMean(item.getName(), known));
    }

private:
    std::string owner(const std::string& path) const {
        return "property '" + path + "' of component '" + record_.name + "'";
    }

    void checkBag(const PropertyBag& given, const PropertyBag& bag, const std::string& path) {
        for (const PropertyBase* item : given) {
            if (item->getName().empty()) continue;
            if (const PropertyBase* const target = bag.find(item->getName()))
                checkItem(*item, *target, path + "." + item->getName());
            else if (!grows_)
                ignored(*item, owner(path) + " holds no", bag.list());
        }
    }

    void checkMembers(const PropertyBag& given, const TypeInfo& type, const std::string& path) {
        // Of a new value, because the one of the component may have other elements.
        const DataSourceBase::shared_ptr value = type.buildValue();
        if (!value) return;
        if (isSequence(type)) return checkElements(given, type, value, path);
        // Code of the type may accept other forms.
        if (!given.getType().empty() && given.getType() != "PropertyBag" && given.getType() != type.getTypeName())
            return;
        const std::vector<std::string> known = memberNames(type, value);
        if (!resembles(given, known)) return;
        for (const PropertyBase* item : given) {
            const std::string& name = item->getName();
            if (name.empty()) continue;
            const DataSourceBase::shared_ptr member = value->getMember(name);  // the type may know it by another name
            if (member)
                checkInner(*item, *member, path + "." + name);
            else if (!contains(known, name))
                ignored(*item, owner(path) + ", of type " + type.getTypeName() + ", has no member", known);
        }
    }

    void checkElements(const PropertyBag& given, const TypeInfo& type, const DataSourceBase::shared_ptr& value,
                       const std::string& path) {
        (void)type.resize(value, static_cast<int>(given.size()));
        for (std::size_t i = 0; i != given.size(); ++i) {
            const std::string index = std::to_string(i);
            const PropertyBase& item = *given.getItem(i);
            const DataSourceBase::shared_ptr element = bagOf(item) ? value->getMember(index) : nullptr;
            if (element) checkInner(item, *element, path + "." + index);
        }
    }

    void checkInner(const PropertyBase& item, const DataSourceBase& member, const std::string& path) {
        const PropertyBag* const given = bagOf(item);
        if (given && member.getTypeInfo()) checkMembers(*given, *member.getTypeInfo(), path);
    }

    const ComponentRecord& record_;
    const RTT::marsh::Places& places_;
    const bool grows_;
    diag::Sink& sink_;
};

void checkStruct(const xml::Element& properties, const ComponentRecord& record, const std::vector<std::string>& known,
                 diag::Sink& sink) {
    for (const xml::Element& property : properties.children) {
        const Text name = nameOf(property);
        if (property.name == "description" || name.empty() || contains(known, name.value)) continue;
        sink.error(name.where, "DEP043",
                   "component '" + record.name + "' has no property '" + name.value + "'" +
                       diag::didYouMean(name.value, known));
    }
    PropertyBag read;
    RTT::marsh::Places places;
    diag::Sink unused;  // errors were reported when the file was read
    (void)RTT::marsh::readBag(properties, read, unused, &places);
    MemberCheck check(record, places, /*grows=*/true, sink);
    for (const PropertyBase* item : read)
        if (const PropertyBase* const target = record.instance->properties()->find(item->getName()))
            check.checkItem(*item, *target, item->getName());
}

/** True if any component has the property: a property file may be for several. */
bool isOfAny(const Session& session, const std::string& name) {
    return std::any_of(session.records.all.begin(), session.records.all.end(), [&](const ComponentRecord& record) {
        return record.instance->properties()->find(name) != nullptr;
    });
}

void checkFile(const PropertyFilePlan& file, const Session& session, const ComponentRecord& record,
               const std::vector<std::string>& known, diag::Sink& sink) {
    const RTT::marsh::PropertyFile* const read = session.propertyFiles->readAgain(resolveFile(file.file));
    if (!read) return;
    const bool grows = file.mode == PropertyFilePlan::Load;
    // A misspelt name cannot mean a property that the file has as well.
    std::vector<std::string> others;
    std::copy_if(known.begin(), known.end(), std::back_inserter(others),
                 [&](const std::string& name) { return !read->bag.find(name); });
    MemberCheck check(record, read->places, grows, sink);
    for (const PropertyBase* item : read->bag) {
        const std::string& name = item->getName();
        if (const PropertyBase* const target = record.instance->properties()->find(name))
            check.checkItem(*item, *target, name);
        else if (!grows && !name.empty() && isSlipOf(name, others) && !isOfAny(session, name))
            check.ignored(*item, "component '" + record.name + "' has no property", others);
    }
}

}  // namespace

void checkProperties(const Session& session, int group, diag::Sink& sink) {
    for (const ComponentRecord& record : session.records.all) {
        if (record.optionsGroup != group) continue;
        const std::vector<std::string> own = record.instance->properties()->list();
        std::vector<std::string> known = own;
        if (record.instance == session.deployer)
            for (const std::string& name : shutdownProperties()) known.push_back(name);
        for (const xml::Element& properties : record.plan.properties) checkStruct(properties, record, known, sink);
        for (const PropertyFilePlan& file : record.plan.propertyFiles) checkFile(file, session, record, own, sink);
    }
}

}  // namespace OCL::deploy
