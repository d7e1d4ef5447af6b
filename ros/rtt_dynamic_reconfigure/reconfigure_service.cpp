// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/auto_config.h>

RTT_DYNAMIC_RECONFIGURE_SERVICE_PLUGIN(rtt_dynamic_reconfigure::AutoConfig, "reconfigure")
