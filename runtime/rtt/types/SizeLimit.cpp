// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "SizeLimit.hpp"

#include <atomic>

namespace RTT::types {

namespace {

std::atomic<std::size_t> limit{kUsualSizeLimit};

}  // namespace

void setSizeLimit(std::size_t elements) noexcept { limit.store(elements, std::memory_order_relaxed); }

std::size_t sizeLimit() noexcept { return limit.load(std::memory_order_relaxed); }

std::string beyondSizeLimit(std::size_t elements) {
    return std::to_string(elements) + " elements: the limit is " + std::to_string(sizeLimit()) +
           "; the option --max-elements of the deployer, or RTT::types::setSizeLimit(), raises it";
}

}  // namespace RTT::types
