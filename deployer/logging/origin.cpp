// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "origin.hpp"

#include <atomic>
#include <sys/prctl.h>

namespace OCL::logging {
namespace {

std::atomic<unsigned> threads{0};
// In the block that each thread has from its start, so that reaching it cannot allocate.
__thread Origin own __attribute__((tls_model("initial-exec")));

}  // namespace

const Origin& origin() noexcept {
    if (__builtin_expect(own.number != 0, 1)) return own;
    if (::prctl(PR_GET_NAME, own.name, 0, 0, 0) != 0) own.name[0] = '\0';
    own.number = threads.fetch_add(1, std::memory_order_relaxed) + 1;
    if (own.number == 0) own.number = 1;
    return own;
}

}  // namespace OCL::logging
