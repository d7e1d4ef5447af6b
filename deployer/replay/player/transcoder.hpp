// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_TRANSCODER_HPP
#define OROFORGE_REPLAY_TRANSCODER_HPP

#include <reporting/schema/message_schema.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace OCL::replay {

/** Turns the bytes of a recorded type into those of the loaded one. Fields of the loaded type that are not recorded, or
    are of another kind, get their defaults; recorded fields that it does not have are left out. */
class Transcoder {
public:
    /** The bytes of default values, by the names of structs in the schema. */
    typedef std::map<std::string, std::vector<unsigned char>> Defaults;

    Transcoder(oroforge::schema::MessageSchema recorded, oroforge::schema::MessageSchema loaded, Defaults defaults)
        : recorded_(std::move(recorded)), loaded_(std::move(loaded)), defaults_(std::move(defaults)) {}

    /** Both without the head of CDR, the result in the byte order of this machine. False, with the reason and the byte,
        if the bytes do not fit the recorded type. Allocates. */
    bool convert(const unsigned char* data, std::size_t size, bool swaps, std::vector<unsigned char>& to,
                 std::string& why) const;

private:
    const oroforge::schema::MessageSchema recorded_, loaded_;
    const Defaults defaults_;
};

}  // namespace OCL::replay

#endif
