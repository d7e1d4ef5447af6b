// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_ROSSERVICE_REGISTRY_SERVICE_H
#define RTT_ROSCOMM_ROSSERVICE_REGISTRY_SERVICE_H

#include <rtt_roscomm/rtt_rosservice_registry_service.h>

#endif
