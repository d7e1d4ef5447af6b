// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An operation throws, and there is no memory to say what. Takes the place of operator new, so it is a program of its own.
#include "call_memory.hpp"
#include "probe.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>

namespace {
thread_local bool nextFails = false;
std::atomic<unsigned long> allocated{0};
}  // namespace

unsigned long oroforge::test::allocations() { return allocated; }

[[gnu::noinline]] void* operator new(std::size_t size) {
    if (nextFails) {
        nextFails = false;
        throw std::bad_alloc();
    }
    ++allocated;
    if (void* const block = std::malloc(size)) return block;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* block) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { std::free(block); }

using namespace RTT;
using oroforge::test::Probe;

namespace {

/** Whoever asks what it is gets no memory afterwards. */
struct Exhausting : std::exception {
    const char* what() const noexcept override {
        nextFails = true;
        return "exhausted";
    }
};

TEST(NoMemory, TheCallerLearnsThatTheOperationThrew) {
    Probe server("server");
    server.addOperation(
        "an_operation_with_a_long_name", []() -> int { throw Exhausting(); }, OwnThread);
    OperationCaller<int()> caller(server.getOperation("an_operation_with_a_long_name"),
                                  internal::GlobalEngine::Instance());
    SendHandle<int()> handle = caller.send();
    try {
        handle.collect();
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("threw"), std::string::npos);
        EXPECT_EQ(std::string(error.what()).find("exhausted"), std::string::npos) << "memory was not exhausted";
    }
    EXPECT_TRUE(server.inException());
}

}  // namespace
