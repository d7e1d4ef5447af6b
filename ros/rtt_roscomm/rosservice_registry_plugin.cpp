// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt_roscomm/rtt_rosservice_registry_service.h>

ORO_GLOBAL_SERVICE_NAMED_PLUGIN(rtt_roscomm::ROSServiceRegistryService, "rosservice_registry")
