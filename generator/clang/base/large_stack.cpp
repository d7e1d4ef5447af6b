// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "large_stack.hpp"

#include <pthread.h>

#include <cstddef>
#include <exception>

namespace oroforge::cxx {

namespace {

struct Job {
    const std::function<void()>& work;
    std::exception_ptr thrown;
};

void* runJob(void* argument) {
    Job& job = *static_cast<Job*>(argument);
    try {
        job.work();
    } catch (...) {
        job.thrown = std::current_exception();
    }
    return nullptr;
}

bool runInThread(Job& job, std::size_t stack) {
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    pthread_t thread = {};
    const bool started =
        pthread_attr_setstacksize(&attributes, stack) == 0 && pthread_create(&thread, &attributes, runJob, &job) == 0;
    pthread_attr_destroy(&attributes);
    return started && pthread_join(thread, nullptr) == 0;
}

}  // namespace

void runOnLargeStack(const std::function<void()>& work) {
    Job job{work, nullptr};
    bool ran = false;
    // A smaller stack may work where the address space is limited (ulimit -v).
    for (const std::size_t stack : {std::size_t{512} << 20U, std::size_t{64} << 20U})
        ran = ran || runInThread(job, stack);
    if (!ran) return work();
    if (job.thrown) std::rethrow_exception(job.thrown);
}

}  // namespace oroforge::cxx
