// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/config_bag.hpp>

#include <rtt/Property.hpp>
#include <rtt_dynamic_reconfigure/detail/parameters.hpp>

namespace rtt_dynamic_reconfigure {

using detail::Parameter;
using detail::Parameters;
using detail::Value;
using RTT::PropertyBag;

namespace {

template <class T, class List>
bool setAll(const List& list, const Parameters& parameters, PropertyBag& bag) {
    bool areAllSet = true;
    for (const auto& one : list) {
        const Value value = static_cast<T>(one.value);
        if (const Parameter* const parameter = parameters.find(one.name)) {
            if (parameter->takes(value))
                parameter->set(value);
            else
                areAllSet = false;
        } else if (bag.find(one.name)) {
            areAllSet = false;
        } else {
            bag.ownProperty(new RTT::Property<T>(one.name, "", static_cast<T>(one.value)));
        }
    }
    return areAllSet;
}

template <class List>
bool getAll(List& list, const char* type, const dynamic_reconfigure::Config& values) {
    bool areAllThere = true;
    for (auto& one : list) {
        Value value;
        if (!detail::valueIn(values, one.name, type, value)) {
            areAllThere = false;
            continue;
        }
        std::visit(
            [&](const auto& known) {
                if constexpr (std::is_convertible_v<decltype(known), decltype(one.value)>) one.value = known;
            },
            value);
    }
    return areAllThere;
}

}  // namespace

bool bagFromConfig(const dynamic_reconfigure::Config& config, PropertyBag& bag) {
    const Parameters parameters = detail::parametersOf(bag);
    const bool isFine[] = {setAll<bool>(config.bools, parameters, bag), setAll<int>(config.ints, parameters, bag),
                           setAll<double>(config.doubles, parameters, bag),
                           setAll<std::string>(config.strs, parameters, bag)};
    return isFine[0] && isFine[1] && isFine[2] && isFine[3];
}

bool configFromBag(const PropertyBag& bag, dynamic_reconfigure::Config& config) {
    dynamic_reconfigure::Config values;
    detail::parametersOf(bag).append(values);
    const bool isFine[] = {getAll(config.bools, "bool", values), getAll(config.ints, "int", values),
                           getAll(config.doubles, "double", values), getAll(config.strs, "str", values)};
    return isFine[0] && isFine[1] && isFine[2] && isFine[3];
}

}  // namespace rtt_dynamic_reconfigure
