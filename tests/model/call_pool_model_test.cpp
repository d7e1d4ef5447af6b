// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/calls/call_pool.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::CallPool;

/** Who has a block writes on it; if two had the same, that would be a data race. */
struct Users {
    std::array<model::Plain<int>, 3> mark;
    void use(void* block) {
        if (CallPool::owns(block)) mark[number(block)] = static_cast<int>(model::self());
    }
    void finish(void* block) {
        if (CallPool::owns(block))
            require(mark[number(block)] == static_cast<int>(model::self()), "two have the same block");
        CallPool::give(block);
    }
    static std::size_t number(void* block) {
        using namespace RTT::internal;
        return smallBlocks.owns(block)
                   ? static_cast<std::size_t>(
                         (static_cast<unsigned char*>(block) - reinterpret_cast<unsigned char*>(smallBlocks.blocks_)) /
                         256)
                   : 2;
    }
};

/** From the start: blocks that were never used. */
void fresh(Trial& trial) {
    Users users;
    for (int i = 0; i < 3; ++i)
        trial.thread([&] {
            void* block = CallPool::take(100);
            users.use(block);
            users.finish(block);
        });
    trial.go();
    require(model::liveBlocks() <= 8, "blocks of the heap are lost");
}

/** One takes two, the other takes two and gives them back in another order: the first one's exchange must notice. */
void takenAndGiven(Trial& trial) {
    Users users;
    void* first = CallPool::take(100);
    void* second = CallPool::take(100);
    CallPool::give(second);
    CallPool::give(first);
    trial.thread([&] {
        void* a = CallPool::take(100);
        users.use(a);
        void* b = CallPool::take(100);
        users.use(b);
        users.finish(b);
        users.finish(a);
    });
    trial.thread([&] {
        void* a = CallPool::take(100);
        users.use(a);
        void* b = CallPool::take(100);
        users.use(b);
        users.finish(a);
        users.finish(b);
    });
    trial.go();
    void* again[2] = {CallPool::take(100), CallPool::take(100)};
    require(again[0] != again[1] && CallPool::owns(again[0]) && CallPool::owns(again[1]), "a block is lost");
}

TEST(CallPool, fresh_blocks) { EXPECT_TRUE(model::holds(fresh)); }
TEST(CallPool, blocks_taken_and_given) { EXPECT_TRUE(model::holds(takenAndGiven)); }

TEST(CallPool, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("pool_without_tag", takenAndGiven));
    EXPECT_TRUE(model::catches("pool_relaxed_take", takenAndGiven));
    EXPECT_TRUE(model::catches("pool_relaxed_give", takenAndGiven));
    EXPECT_TRUE(model::catches("pool_fresh_twice", fresh));
}

}  // namespace
