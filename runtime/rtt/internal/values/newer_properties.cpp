// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "newer_properties.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace RTT::internal {
namespace {

struct Known {
    std::mutex mutex;
    std::map<const PropertyBag*, std::vector<std::string>> names;
};

/** Never destroyed: static components may end later. */
Known& known() {
    static Known& instance = *new Known;
    return instance;
}

}  // namespace

NewerProperties::NewerProperties(const PropertyBag& all, std::vector<std::string> names) : all_(&all) {
    const std::lock_guard<std::mutex> lock(known().mutex);
    known().names[all_] = std::move(names);
}

NewerProperties::~NewerProperties() {
    const std::lock_guard<std::mutex> lock(known().mutex);
    known().names.erase(all_);
}

bool NewerProperties::has(const PropertyBag& all, const std::string& name) {
    const std::lock_guard<std::mutex> lock(known().mutex);
    const auto found = known().names.find(&all);
    return found != known().names.end() &&
           std::find(found->second.begin(), found->second.end(), name) != found->second.end();
}

}  // namespace RTT::internal
