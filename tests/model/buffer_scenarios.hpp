// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What every lock-free buffer must do. To be included after checker/substitute.hpp and the source of the buffer.
#ifndef OROFORGE_MODEL_BUFFER_SCENARIOS_HPP
#define OROFORGE_MODEL_BUFFER_SCENARIOS_HPP

#include <rtt/internal/flow/sample_store.hpp>

namespace model {

using RTT::internal::SampleStore;
using RTT::internal::StoreSpec;

/** `Sample` is made from an int and has value(), which fails the run if the sample is torn. */
template <class Sample, std::unique_ptr<SampleStore> (*make)(const StoreSpec&)>
struct BufferScenarios {
    static std::unique_ptr<SampleStore> makeStore(StoreSpec::Kind kind, std::size_t size, std::size_t threads,
                                                  bool oldData) {
        StoreSpec spec;
        spec.kind = kind;
        spec.size = size;
        spec.maxThreads = threads;
        spec.oldData = oldData;
        return make(spec);
    }
    static bool write(SampleStore& store, int value) {
        const Sample sample(value);
        return store.write(&sample) == RTT::WriteSuccess;
    }
    /** The value, or 0 if there was nothing new. */
    static int readNew(SampleStore& store) {
        Sample sample(-1);
        return store.read(&sample, true) == RTT::NewData ? sample.get() : 0;
    }

    /** How often each value went in and came out. */
    struct Account {
        std::array<int, 8> in{}, out{};
        bool put(SampleStore& store, int value) {
            const bool done = write(store, value);
            in[static_cast<std::size_t>(value)] += done;
            return done;
        }
        int take(SampleStore& store) {
            const int value = readNew(store);
            require(value >= 0 && value < 8, "a sample that nobody wrote");
            if (value != 0) ++out[static_cast<std::size_t>(value)];
            return value;
        }
        void settle(SampleStore& store) {
            while (take(store) != 0) {
            }
            for (std::size_t value = 1; value < in.size(); ++value) {
                require(out[value] <= in[value], "a sample came out twice, or was refused and came out");
                require(out[value] >= in[value], "a sample is lost");
            }
        }
    };

    static void twoWritersOneReader(Trial& trial) {
        const auto store = makeStore(StoreSpec::Buffer, 1, 3, false);
        Account account;
        std::array<bool, 2> done{};
        trial.thread([&] { done[0] = account.put(*store, 1); });
        trial.thread([&] { done[1] = account.put(*store, 2); });
        trial.thread([&] { account.take(*store); });
        trial.go();
        require(done[0] || done[1], "both were refused by an empty buffer");
        account.settle(*store);
    }

    static void oneWriterTwoReaders(Trial& trial) {
        const auto store = makeStore(StoreSpec::Buffer, 2, 3, false);
        Account account;
        account.put(*store, 1);
        std::array<int, 2> got{};
        trial.thread([&] { account.put(*store, 2); });
        for (int& value : got) trial.thread([&] { value = account.take(*store); });
        trial.go();
        require(got[0] != 0 || got[1] != 0, "there was a sample all the time");
        account.settle(*store);
    }

    /** Goes round the ring, reusing slots; first in, first out. */
    static void oneWriterOneReader(Trial& trial) {
        const auto store = makeStore(StoreSpec::Buffer, 1, 0, false);
        Account account;
        account.put(*store, 1);
        trial.thread([&] {
            for (int value = 2; value <= 4; ++value) account.put(*store, value);
        });
        trial.thread([&] {
            int last = 0;
            for (int i = 0; i < 3; ++i) {
                const int value = account.take(*store);
                require(value == 0 || value > last, "not first in, first out");
                if (value != 0) last = value;
            }
        });
        trial.go();
        account.settle(*store);
    }

    /** A full circular buffer: every write succeeds, the newest stays and readers never find it empty. */
    static void circular(Trial& trial) {
        const auto store = makeStore(StoreSpec::CircularBuffer, 1, 2, false);
        require(write(*store, 1), "refused");
        int got = 0;
        trial.thread([&] { require(write(*store, 2), "a circular buffer refused"); });
        trial.thread([&] { got = readNew(*store); });
        trial.go();
        require(got != 0, "empty though it never is");
        const int left = readNew(*store);
        require(got == 2 ? left == 0 : left == 2, "the newest is lost or came twice");
    }

    static void circularTwoWriters(Trial& trial) {
        const auto store = makeStore(StoreSpec::CircularBuffer, 1, 3, true);
        for (int value = 1; value <= 2; ++value)
            trial.thread([&, value] { require(write(*store, value), "a circular buffer refused"); });
        trial.thread([&] { readNew(*store); });
        trial.go();
        int left = 0;
        while (readNew(*store) != 0) ++left;
        require(left <= 1, "more than it holds");
    }

    /** There are never more than two samples at once. */
    static void refusesOnlyIfFull(Trial& trial) {
        const auto store = makeStore(StoreSpec::Buffer, 2, 3, false);
        require(write(*store, 1), "not set up");
        bool done = false;
        trial.thread([&] {
            readNew(*store);
            write(*store, 2);
        });
        trial.thread([&] { done = write(*store, 3); });
        trial.go();
        require(done, "refused by a buffer that never was full");
    }

    /** An empty buffer gives its last sample again, while another thread writes and takes samples. */
    template <int rounds>
    static void oldData(Trial& trial) {
        const auto store = makeStore(StoreSpec::Buffer, 1, 0, true);
        require(write(*store, 1) && readNew(*store) == 1, "not set up");
        trial.thread([&] {
            for (int value = 2; value < 2 + rounds; ++value) {
                write(*store, value);
                readNew(*store);
            }
        });
        trial.thread([&] {
            Sample sample(-1);
            require(store->read(&sample, true) != RTT::NoData, "there was a sample before");
            require(sample.get() >= 1 && sample.get() < 2 + rounds, "a sample that nobody wrote");
        });
        trial.go();
    }

    /** A reader copies the sample that another thread takes, and whose slot it uses again. */
    template <int last>
    static void slotReused(Trial& trial) {
        const auto store = makeStore(StoreSpec::Buffer, 1, 0, false);
        for (int value = 1; value <= 2; ++value)
            require(write(*store, value) && readNew(*store) == value, "not set up");
        require(write(*store, 3), "not set up");
        trial.thread([&] {
            for (int value = 4; value <= last; ++value) {
                readNew(*store);
                write(*store, value);
            }
        });
        trial.thread([&] { require(readNew(*store) != 1, "taken already"); });
        trial.go();
    }
};

}  // namespace model

#endif
