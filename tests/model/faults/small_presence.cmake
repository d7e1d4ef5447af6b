# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# For scenarios about something else: Presence with few places, and with a record for each thread from the start. How threads
# get their records is in presence_model_test. `depth` is how many uses nest in the scenarios, which have
# `threads` threads with their own.
set(presence rtt/internal/engine/presence.cpp)
set(presence_header rtt/internal/engine/presence.hpp)
under_test(${presence} ${presence_header})
adapt(${presence} [=[ThreadRecords<Record, 64>]=] "ThreadRecords<Record, ${threads}>")
adapt(${presence} [=[asymmetric = detail::offersProcessBarrier();]=]
  [=[asymmetric = detail::offersProcessBarrier(); model::linkAll(records);]=])
adapt(${presence} [=[state.records.take();]=] [=[&state.records.pool_[model::self()];]=])
adapt(${presence_header} [=[kDepth = 11;]=] "kDepth = ${depth};")
