// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which calls --rt-check watches, and how it tells where they came from.
#include "counted_calls.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <thread>

#include <dlfcn.h>
#include <sched.h>

namespace {

using rt_check_test::counted;

void* volatile block;

TEST(Watch, CoversWhatIsNestedAndNothingElse) {
    const auto allocate = [] { block = std::malloc(10); };
    EXPECT_EQ("", counted(allocate, 0));
    EXPECT_EQ("RTC001 malloc 2", counted([&] {
                  oroforge_rt_check_begin("inner", OROFORGE_RT_UPDATE, 0);  // in the thread of one that is watched
                  allocate();
                  oroforge_rt_check_end();
                  allocate();
              }));
    EXPECT_EQ("RTC001 malloc 1", counted(
                                     [&] {
                                         oroforge_rt_check_begin("inner", OROFORGE_RT_UPDATE, 1);
                                         allocate();
                                         oroforge_rt_check_end();
                                         allocate();
                                     },
                                     0));
    EXPECT_EQ("RTC001 malloc 20", counted([&] {
                  for (int i = 0; i != 20; ++i) oroforge_rt_check_begin("deep", OROFORGE_RT_UPDATE, 0), allocate();
                  for (int i = 0; i != 20; ++i) oroforge_rt_check_end();
              }));
    EXPECT_EQ("", counted([] {}));
}

TEST(Watch, CoversItsOwnThreadOnly) {
    std::atomic<int> stage{0};
    std::thread other([&stage] {
        while (stage != 1) std::this_thread::yield();
        block = std::malloc(10);
        stage = 2;
    });
    EXPECT_EQ("", counted([&stage] {
                  stage = 1;
                  while (stage != 2) sched_yield();
              }));
    other.join();
}

TEST(Watch, KnowsWhatWasInALibraryThatIsClosedNow) {
    void* const library = dlopen(CLOSED_LIBRARY, RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(nullptr, library) << dlerror();
    const auto allocate = reinterpret_cast<void* (*)()>(dlsym(library, "allocateInClosedLibrary"));
    oroforge_rt_check_begin("closed", OROFORGE_RT_UPDATE, 1);
    block = allocate();
    oroforge_rt_check_end();
    std::free(block);
    ASSERT_EQ(0, dlclose(library));
    ASSERT_EQ(nullptr, dlopen(CLOSED_LIBRARY, RTLD_NOW | RTLD_NOLOAD)) << "it is still there";
    std::string frame;
    oroforge_rt_check_findings(
        [](void* to, const oroforge_rt_finding* finding) {
            if (std::strcmp(finding->component, "closed") == 0) *static_cast<std::string*>(to) = finding->frames[0];
        },
        &frame);
    EXPECT_EQ(0u, frame.find("'allocateInClosedLibrary' (" CLOSED_LIBRARY "+0x")) << frame;
}

/** Loads a library, lets its function allocate, and closes it; the address of the function. */
void* allocateIn(const char* library, const char* function) {
    void* const handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(nullptr, handle) << dlerror();
    void* const address = dlsym(handle, function);
    oroforge_rt_check_begin("one of two", OROFORGE_RT_UPDATE, 1);
    block = reinterpret_cast<void* (*)()>(address)();
    oroforge_rt_check_end();
    std::free(block);
    EXPECT_EQ(0, dlclose(handle));
    return address;
}

TEST(Watch, TellsLibrariesApartThatCameToTheSameAddressOneAfterTheOther) {
    void* const first = allocateIn(CLOSED_LIBRARY, "allocateInClosedLibrary");
    if (allocateIn(OTHER_CLOSED_LIBRARY, "allocateInOtherLibrary") != first) GTEST_SKIP() << "it has another address";
    (void)allocateIn(CLOSED_LIBRARY, "allocateInClosedLibrary");
    std::map<std::string, unsigned long> found;
    oroforge_rt_check_findings(
        [](void* to, const oroforge_rt_finding* finding) {
            if (std::strcmp(finding->component, "one of two") != 0) return;
            const std::string frame = finding->frames[0];
            (*static_cast<std::map<std::string, unsigned long>*>(to))[frame.substr(0, frame.find(' '))] +=
                finding->count;
        },
        &found);
    EXPECT_EQ((std::map<std::string, unsigned long>{{"'allocateInClosedLibrary'", 2}, {"'allocateInOtherLibrary'", 1}}),
              found);
}

[[gnu::noinline]] char* printedToMemory() {
    char* text = nullptr;
    EXPECT_EQ(4, asprintf(&text, "%d", 1234));
    return text;
}

/** libc allocates in more than one place for it. */
TEST(Watch, WhatALibraryDoesForOneCallIsOneFinding) {
    oroforge_rt_check_begin("printing", OROFORGE_RT_UPDATE, 1);
    block = printedToMemory();
    oroforge_rt_check_end();
    std::free(block);
    struct Found {
        int findings = 0;
        unsigned long calls = 0;
        std::string last;
    } found;
    oroforge_rt_check_findings(
        [](void* to, const oroforge_rt_finding* finding) {
            if (std::strcmp(finding->component, "printing") != 0 || finding->fault != OROFORGE_RT_ALLOCATION) return;
            auto& all = *static_cast<Found*>(to);
            ++all.findings;
            all.calls += finding->count;
            all.last = finding->frames[finding->depth - 1];
        },
        &found);
    EXPECT_EQ(1, found.findings);
    EXPECT_LE(2u, found.calls);
    EXPECT_NE(std::string::npos, found.last.find("rt_check_calls_test")) << found.last;
}

TEST(Watch, KeepsTheErrorNumber) {
    counted([] {
        errno = 99;
        block = std::malloc(10);
        EXPECT_EQ(99, errno);
    });
}

}  // namespace
