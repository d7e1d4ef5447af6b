// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_FOSI_H
#define ORO_FOSI_H

/**
 * @file
 * The C layer over GNU/Linux.
 */
#include <rtt/os/fosi_base.h>
#include <rtt/os/fosi_sync.h>

#endif
