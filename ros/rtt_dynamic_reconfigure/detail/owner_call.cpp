// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/detail/owner_call.hpp>

#include <rtt/Logger.hpp>
#include <rtt/OperationInterfacePart.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt_dynamic_reconfigure/detail/parameters.hpp>

#include <exception>
#include <utility>
#include <vector>

namespace rtt_dynamic_reconfigure::detail {

using RTT::OperationInterfacePart;
using RTT::PropertyBag;
using RTT::base::DataSourceBase;
using RTT::internal::ValueDataSource;

namespace {

/** Any signature with these arguments, by value or by reference, will do. False if the operation threw, could not be
    called or returned false. */
bool call(RTT::TaskContext& owner, const std::string& name, OperationInterfacePart::Args args, std::string& why) {
    try {
        OperationInterfacePart* const operation = owner.provides()->findOperation(name);
        const DataSourceBase::shared_ptr result = operation->produce(args, owner.engine());
        if (auto* const answer = RTT::internal::DataSource<bool>::narrow(result.get())) {
            if (answer->get()) return true;
            why = "its operation " + name + "() refuses that";
            return false;
        }
        if (result->evaluate()) return true;
        why = "its operation " + name + "() could not be called";
    } catch (const std::exception& error) {
        why = "its operation " + name + "() failed: " + error.what();
    }
    return false;
}

bool setAll(const PropertyBag& target, const PropertyBag& bag, std::string& why) {
    const Parameters own = parametersOf(target);
    std::vector<std::pair<const Parameter*, Value>> changes;
    for (const Parameter& wanted : parametersOf(bag).all) {
        const Parameter* const parameter = own.find(wanted.name);
        if (!parameter) {
            why = "it has no property '" + wanted.name + "'";
            return false;
        }
        const Value value = wanted.value();
        // A number that is too large for a parameter stays as it is.
        if (isEqual(value, parameter->value())) continue;
        if (!parameter->takes(value)) {
            why = "the value of '" + wanted.name + "' does not fit its property";
            return false;
        }
        changes.emplace_back(parameter, value);
    }
    for (const auto& [parameter, value] : changes) parameter->set(value);
    return true;
}

}  // namespace

bool setProperties(RTT::TaskContext& owner, const PropertyBag& bag, std::uint32_t level, std::string& why) {
    if (!owner.provides()->hasOperation("updateProperties")) return setAll(*owner.properties(), bag, why);
    return call(owner, "updateProperties", {new ValueDataSource<PropertyBag>(bag), new ValueDataSource<unsigned>(level)},
                why);
}

void tellChanged(RTT::TaskContext& owner, std::uint32_t level) {
    for (const char* name : {"notifyPropertiesUpdate", "notifyPropertiesUpdated"}) {
        if (!owner.provides()->hasOperation(name)) continue;
        std::string why;
        if (!call(owner, name, {new ValueDataSource<unsigned>(level)}, why))
            RTT::log(RTT::Warning) << "component '" << owner.getName() << "' was not told of its new properties: " << why
                                   << RTT::endlog();
        return;
    }
}

}  // namespace rtt_dynamic_reconfigure::detail
