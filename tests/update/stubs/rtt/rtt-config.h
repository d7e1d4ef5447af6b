// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UPDATE_STUB_CONFIG_H
#define OROFORGE_TESTS_UPDATE_STUB_CONFIG_H

#define OROFORGE_GENERATED_API 1

#endif
