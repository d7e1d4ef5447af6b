// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Stands for the registry of services, so that the plugin can be loaded alone.
#include "added_services.hpp"

std::vector<rtt_roscomm::ServiceEntry>& addedServices() {
    static std::vector<rtt_roscomm::ServiceEntry> all;
    return all;
}

namespace rtt_roscomm {

RTT_EXPORT void addServices(const ServiceEntry* first, std::size_t count);
void addServices(const ServiceEntry* first, std::size_t count) {
    addedServices().insert(addedServices().end(), first, first + count);
}

}  // namespace rtt_roscomm
