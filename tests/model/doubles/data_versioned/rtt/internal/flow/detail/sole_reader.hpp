// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: the scenario says whether all of its threads but one leave the store alone.
#ifndef OROFORGE_MODEL_SOLE_READER_HPP
#define OROFORGE_MODEL_SOLE_READER_HPP

namespace model {

inline bool oneReads = false;

/** The scenario with a sole reader. */
template <void (*scenario)(Trial&)>
void alone(Trial& trial) {
    oneReads = true;
    scenario(trial);
    oneReads = false;
}

}  // namespace model

namespace RTT {
namespace internal {
namespace detail {

class SoleReader {
public:
    class Reading {
    public:
        explicit Reading(SoleReader&) {}
        bool alone() const { return model::oneReads; }
        bool late() const { return false; }
    };
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
