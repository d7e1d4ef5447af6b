// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The name of <rtt_roscomm/rostopic.h> in old packages.
#ifndef RTT_ROSCOMM_RTT_ROSTOPIC_H
#define RTT_ROSCOMM_RTT_ROSTOPIC_H

#warning "<rtt_roscomm/rtt_rostopic.h> is deprecated: include <rtt_roscomm/rostopic.h>"
#include <rtt_roscomm/rostopic.h>

#endif
