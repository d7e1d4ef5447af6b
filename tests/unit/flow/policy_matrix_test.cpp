// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Every combination of the fields of a policy that means something within one process.
#include <rtt/Port.hpp>
#include <rtt/internal/ConnectionManager.hpp>

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

using namespace RTT;

namespace {

constexpr int kTypes[] = {ConnPolicy::DATA, ConnPolicy::BUFFER, ConnPolicy::CIRCULAR_BUFFER};
constexpr int kLocks[] = {ConnPolicy::UNSYNC, ConnPolicy::LOCKED, ConnPolicy::LOCK_FREE};
constexpr int kOwners[] = {UnspecifiedBufferPolicy, PerConnection, PerInputPort, PerOutputPort, Shared};

template <class T>
T number(int i);
template <>
double number<double>(int i) {
    return i;
}
template <>
std::string number<std::string>(int i) {
    return "a string too long to be stored in place: " + std::to_string(i);
}

/** Type and lock policy; the other fields are gone through in each test. */
class EveryPolicy : public testing::TestWithParam<std::tuple<int, int>> {
protected:
    template <class F>
    void forEach(F check) {
        std::tie(policy.type, policy.lock_policy) = GetParam();
        for (const int owner : kOwners)
            for (const int flags : {0, 1, 2, 3, 4, 5, 6, 7})
                for (const int size : {0, 1, 3}) {
                    policy.buffer_policy = owner;
                    policy.pull = flags & 1;
                    policy.init = flags & 2;
                    policy.mandatory = flags & 4;
                    policy.size = size;
                    policy.name_id.clear();
                    check();
                    if (HasFailure()) FAIL() << "with " << policy;
                }
    }
    bool isData() const { return policy.type == ConnPolicy::DATA; }
    bool refuses() const { return !isData() && policy.size == 0; }
    /** Buffers that several readers empty have no old data. */
    bool hasOldData() const {
        return isData() || (policy.buffer_policy != PerOutputPort && policy.buffer_policy != Shared);
    }
    WriteStatus refusal() const { return policy.mandatory ? WriteFailure : WriteSuccess; }

    /** What a reader finds in storage that should hold the numbers from first to last. */
    template <class T>
    void expectNumbers(InputPort<T>& in, int first, int last) {
        T got = number<T>(99);
        for (int i = first; i <= last; ++i) {
            ASSERT_EQ(in.read(got), NewData) << policy << " sample " << i;
            ASSERT_EQ(got, number<T>(i)) << policy;
        }
        got = number<T>(99);
        const bool read = last >= first;
        EXPECT_EQ(in.read(got, false), read && hasOldData() ? OldData : NoData) << policy;
        EXPECT_EQ(got, number<T>(99)) << policy;
        EXPECT_EQ(in.read(got), read && hasOldData() ? OldData : NoData) << policy;
        EXPECT_EQ(got, number<T>(read && hasOldData() ? last : 99)) << policy;
    }

    template <class T>
    void check() {
        OutputPort<T> out("out");
        InputPort<T> in("in");
        out.setDataSample(number<T>(50));
        out.write(number<T>(1));
        ASSERT_TRUE(out.createConnection(in, policy)) << policy;
        expectNumbers<T>(in, 1, policy.init && !refuses() ? 1 : 0);
        in.clear();
        expectNumbers<T>(in, 1, 0);

        int first = 2, last = 1;  // what should be in the storage
        for (int i = 2; i <= 5; ++i) {
            const WriteStatus status = out.write(number<T>(i));
            const bool full = !isData() && last - first + 1 == policy.size;
            if (refuses() || (full && policy.type == ConnPolicy::BUFFER)) {
                EXPECT_EQ(status, refusal()) << policy << " sample " << i;
                continue;
            }
            EXPECT_EQ(status, WriteSuccess) << policy << " sample " << i;
            last = i;
            if (isData()) first = i;
            if (full) ++first;
        }
        expectNumbers<T>(in, first, last);
        T last_written = T();
        EXPECT_TRUE(out.getLastWrittenValue(last_written));
        EXPECT_EQ(last_written, number<T>(5));

        if (!refuses()) {
            out.write(number<T>(6));
            out.setDataSample(number<T>(51));  // starts anew, and is never data itself
            expectNumbers<T>(in, 1, 0);
            EXPECT_EQ(out.write(number<T>(7)), WriteSuccess);
            EXPECT_EQ(in.readNewest(last_written), NewData);
            EXPECT_EQ(last_written, number<T>(7));
        }
        T sizing = T();
        in.getDataSample(sizing);
        EXPECT_EQ(sizing, number<T>(refuses() ? 50 : 51)) << policy;
        in.disconnect();
        EXPECT_FALSE(in.connected());
        EXPECT_EQ(out.connected(), policy.buffer_policy == Shared);  // of which the writer is still a member
    }

    void checkShown() {
        OutputPort<int> out("out");
        InputPort<int> in("in");
        ASSERT_TRUE(out.createConnection(in, policy));
        for (base::PortInterface* port :
             {static_cast<base::PortInterface*>(&out), static_cast<base::PortInterface*>(&in)}) {
            const auto channels = port->getManager()->getChannels();
            ASSERT_EQ(channels.size(), 1u);
            const ConnPolicy& used = channels.front().get<2>();
            EXPECT_EQ(used.type, policy.type);
            EXPECT_EQ(used.size, policy.size);
            EXPECT_EQ(used.lock_policy, policy.lock_policy);
            EXPECT_EQ(used.mandatory, policy.mandatory);
            const int owner = policy.buffer_policy == UnspecifiedBufferPolicy ? PerConnection : policy.buffer_policy;
            EXPECT_EQ(used.buffer_policy, owner);
            EXPECT_EQ(used.pull, owner == PerInputPort ? false : owner == PerOutputPort ? true : policy.pull);
            EXPECT_EQ(used.max_threads, 2 + (owner == PerInputPort || owner == Shared ? 10 : 0) +
                                            (owner == PerOutputPort || owner == Shared ? 10 : 0));
        }
    }

    ConnPolicy policy;
};

TEST_P(EveryPolicy, HoldsForPlainSamples) {
    forEach([this] { check<double>(); });
}
TEST_P(EveryPolicy, HoldsForSamplesThatAllocate) {
    forEach([this] { check<std::string>(); });
}

TEST_P(EveryPolicy, IsShownCompleted) {
    forEach([this] { checkShown(); });
}

INSTANTIATE_TEST_SUITE_P(All, EveryPolicy, testing::Combine(testing::ValuesIn(kTypes), testing::ValuesIn(kLocks)));

}  // namespace
