// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/detail/merge.hpp>

#include <rtt_dynamic_reconfigure/detail/parameters.hpp>

#include <cmath>
#include <set>

namespace rtt_dynamic_reconfigure::detail {

using dynamic_reconfigure::Config;

namespace {

Value limited(const Config& min, const Config& max, const std::string& name, const std::string& type, Value value) {
    Value limit;
    if (type == "str" || type == "bool") return value;
    if (valueIn(max, name, type, limit) && value > limit) value = limit;
    if (valueIn(min, name, type, limit) && value < limit) value = limit;
    return value;
}

/** True if the request has a name that the server lacks, or with another type. */
bool isOdd(const Config& request, const std::set<std::string>& known, std::string& why) {
    const auto isOddIn = [&](const auto& list, const char* type) {
        for (const auto& one : list) {
            if (known.count(one.name + ' ' + type)) continue;
            why = "there is no parameter '" + one.name + "' of type " + type;
            return true;
        }
        return false;
    };
    return isOddIn(request.bools, "bool") || isOddIn(request.ints, "int") || isOddIn(request.strs, "str") ||
           isOddIn(request.doubles, "double");
}

}  // namespace

bool merge(const dynamic_reconfigure::ConfigDescription& description, const Config& present, const Config& request,
           Config& merged, std::uint32_t& level, std::string& why) {
    merged = Config();
    level = 0;
    std::set<std::string> known;
    for (const dynamic_reconfigure::Group& group : description.groups)
        for (const dynamic_reconfigure::ParamDescription& one : group.parameters) {
            known.insert(one.name + ' ' + one.type);
            if (one.type == "double") known.insert(one.name + " int");
            Value value, wanted;
            if (!valueIn(present, one.name, one.type, value)) continue;
            if (valueIn(request, one.name, one.type, wanted) && !isEqual(wanted, value)) {
                const double* const number = std::get_if<double>(&wanted);
                if (number && std::isnan(*number)) {
                    why = "the value of '" + one.name + "' is not a number";
                    return false;
                }
                wanted = limited(description.min, description.max, one.name, one.type, wanted);
                if (!isEqual(wanted, value)) level |= one.level;
                value = wanted;
            }
            append(merged, one.name, value);
        }
    merged.groups = present.groups;
    for (dynamic_reconfigure::GroupState& group : merged.groups)
        for (const dynamic_reconfigure::GroupState& wanted : request.groups)
            if (wanted.id == group.id && wanted.name == group.name) group.state = wanted.state;
    return !isOdd(request, known, why);
}

}  // namespace rtt_dynamic_reconfigure::detail
