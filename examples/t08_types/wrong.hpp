// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#pragma once
#include <memory>
struct Sample {
    int good;
    const char* name;
    std::shared_ptr<Sample> next;
};
