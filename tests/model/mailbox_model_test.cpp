// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/engine/mailbox.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::Mailbox;

struct alignas(8) Message {
    model::Plain<int> value;
};

/** Messages with numbers; how often each was put and taken. */
struct Post {
    Mailbox mailbox;
    std::array<Message, 6> messages;
    std::array<int, 6> in{}, out{};

    void put(int number, Mailbox::Kind kind = Mailbox::Kind::Message) {
        Message& message = messages[static_cast<std::size_t>(number)];
        message.value = number;
        in[static_cast<std::size_t>(number)] += mailbox.put({kind, &message});
    }
    /** The number, or 0. */
    int take() {
        Mailbox::Item item;
        if (!mailbox.take(item) || !item.what) return 0;
        const int number = static_cast<Message*>(item.what)->value;
        ++out[static_cast<std::size_t>(number)];
        return number;
    }
    void settle() {
        for (int i = 0; i < 3; ++i) take();
        require(mailbox.empty(), "not empty");
        require(in == out, "a message is lost or came twice");
    }
};

void twoProducers(Trial& trial) {
    Post post;
    trial.thread([&] { post.put(1); });
    trial.thread([&] { post.put(2); });
    trial.thread([&] {
        post.take();
        post.take();
    });
    trial.go();
    require(post.in[1] == 1 && post.in[2] == 1, "refused though there was room");
    post.settle();
}

void goingRound(Trial& trial) {
    Post post;
    trial.thread([&] {
        for (int number = 1; number <= 4; ++number) post.put(number);
    });
    trial.thread([&] {
        int last = 0;
        for (int i = 0; i < 3; ++i) {
            const int number = post.take();
            require(number == 0 || number > last, "not first in, first out");
            last = number != 0 ? number : last;
        }
    });
    trial.go();
    post.settle();
}

void twoConsumers(Trial& trial) {
    Post post;
    post.put(1);
    trial.thread([&] { post.put(2); });
    for (int i = 0; i < 2; ++i) trial.thread([&] { post.take(); });
    trial.go();
    require(post.out[1] == 1, "there was a message all the time");
    post.settle();
}

/** What is withdrawn is not taken, and the other way round. */
void withdrawing(Trial& trial) {
    Post post;
    post.put(1, Mailbox::Kind::AddFunction);
    bool withdrawn = false;
    trial.thread([&] { withdrawn = post.mailbox.withdraw({Mailbox::Kind::AddFunction, &post.messages[1]}); });
    trial.thread([&] {
        post.take();
        post.put(2);
        post.take();
    });
    trial.go();
    require(withdrawn == (post.out[1] == 0), "withdrawn and taken, or neither");
    if (withdrawn) ++post.out[1];
    post.settle();
}

TEST(Mailbox, two_producers_and_one_consumer) { EXPECT_TRUE(model::holds(twoProducers)); }
TEST(Mailbox, one_producer_and_one_consumer_go_round) { EXPECT_TRUE(model::holds(goingRound)); }
TEST(Mailbox, one_producer_and_two_consumers) { EXPECT_TRUE(model::holds(twoConsumers)); }
TEST(Mailbox, withdrawing) { EXPECT_TRUE(model::holds(withdrawing)); }

TEST(Mailbox, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("mailbox_relaxed_put", twoProducers));
    EXPECT_TRUE(model::catches("mailbox_relaxed_look", twoProducers));
    EXPECT_TRUE(model::catches("mailbox_put_over", twoProducers));
    EXPECT_TRUE(model::catches("mailbox_taken_twice", twoConsumers));
    EXPECT_TRUE(model::catches("mailbox_withdrawn_and_taken", withdrawing));
}

}  // namespace
