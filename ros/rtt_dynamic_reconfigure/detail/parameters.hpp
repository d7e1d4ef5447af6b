// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DYNAMIC_RECONFIGURE_DETAIL_PARAMETERS_HPP
#define RTT_DYNAMIC_RECONFIGURE_DETAIL_PARAMETERS_HPP

#include <dynamic_reconfigure/Config.h>
#include <rtt/PropertyBag.hpp>
#include <rtt/base/DataSourceBase.hpp>

#include <string>
#include <variant>
#include <vector>

namespace rtt_dynamic_reconfigure::detail {

/** A value that dynamic_reconfigure knows. */
typedef std::variant<bool, int, double, std::string> Value;

/** A property, or a member of one, that holds such a value. */
struct Parameter {
    enum class Kind { Bool, Int, UInt, Float, Double, String };

    std::string name;               ///< with the names of the bags and structs around it: `a__b`
    std::vector<std::string> path;  ///< the same in parts
    std::string description;
    Kind kind;
    std::size_t group;  ///< 0 for a property of its own
    RTT::base::DataSourceBase::shared_ptr source;

    /** "bool", "int", "double" or "str". */
    const char* type() const;
    Value value() const;
    /** False if there is no such value of this kind, or it is not within the limits of the kind. */
    bool takes(const Value& value) const;
    /** Only values that it takes. */
    void set(const Value& value) const;
    Value lowest() const;
    Value highest() const;
};

/** Parameters with common names around theirs. */
struct ParameterGroup {
    std::string name;
    std::size_t parent;
};

struct Parameters {
    std::vector<Parameter> all;
    std::vector<ParameterGroup> groups;  ///< the first is that of all

    const Parameter* find(const std::string& name) const;
    void append(dynamic_reconfigure::Config& config) const;
    void appendGroups(dynamic_reconfigure::Config& config) const;
};

/** What in a bag dynamic_reconfigure can change. They refer to the values in the bag. Of two with one name the first. */
Parameters parametersOf(const RTT::PropertyBag& bag);

/** A value for `parameter` below a path of bags, which are made where they are missing. One of the same kind stays. */
Parameter keepParameter(RTT::PropertyBag& bag, const Parameter& parameter, const Value& value);
/** Removes all values that `wanted` does not have, and the bags that then are empty. */
void keepOnly(RTT::PropertyBag& bag, const Parameters& wanted);

void append(dynamic_reconfigure::Config& config, const std::string& name, const Value& value);
/** False if there is none of that name. An int is found as a double if that is the type. */
bool valueIn(const dynamic_reconfigure::Config& config, const std::string& name, const std::string& type, Value& value);
/** Two values that are no numbers are equal, too. */
bool isEqual(const Value& one, const Value& other);

}  // namespace rtt_dynamic_reconfigure::detail

#endif
