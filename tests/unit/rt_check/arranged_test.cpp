// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How findings of --rt-check are put for readers.
#include <bin/real_time_findings.hpp>

#include <gmock/gmock.h>

namespace {

using namespace OCL::deploy;
using oroforge::diag::Note;
using testing::HasSubstr;

Note frame(const std::string& message, const std::string& file = "", unsigned line = 0) {
    Note result;
    if (line != 0) result.where.file = file;
    result.where.line = line;
    result.message = message;
    return result;
}

Note user(unsigned line) { return frame("'Average::updateHook()' (/a/libaverage.so+0xcc91)", "/a/average.cpp", line); }

const Note kNew = frame("'operator new(unsigned long)' (/lib/libstdc++.so.6+0xa958b)");
const Note kGrows = frame("'void std::vector<double>::_M_realloc_insert()' (/a/libaverage.so+0xcb25)",
                          "/usr/include/c++/12/bits/vector.tcc", 453);

RealTimeFinding allocation(std::vector<Note> frames) {
    return {"average", "updateHook()", "allocates memory", "RTC001", "malloc", 4, std::move(frames), {}};
}

RealTimeFinding release(std::vector<Note> frames) {
    return {"average", "updateHook()", "frees memory", "RTC002", "free", 1, std::move(frames), {}};
}

TEST(RtCheckArranged, StandsAtTheLineOfTheUser) {
    const auto found = arranged({allocation({kNew, kGrows, user(13)})});
    ASSERT_EQ(1u, found.size());
    EXPECT_EQ("/a/average.cpp", found[0].where.file.str());
    EXPECT_EQ(13u, found[0].where.line);
    EXPECT_EQ("component 'average' allocates memory in updateHook(): malloc(), 4 times", found[0].message);
    EXPECT_FALSE(lacksLines(found[0]));
}

TEST(RtCheckArranged, SkipsTheRuntime) {
    const Note port = frame("'RTT::OutputPort<T>::write()' (/a/libaverage.so+0x1)", "/opt/rtt/OutputPort.hpp", 90);
    EXPECT_EQ(13u, arranged({allocation({kNew, port, user(13)})})[0].where.line);
    EXPECT_EQ(90u, arranged({allocation({kNew, port})})[0].where.line);  // better than none
}

TEST(RtCheckArranged, FoldsTheStandardLibrary) {
    const auto found = arranged({allocation({kNew, kGrows, user(13)})});
    ASSERT_EQ(2u, found[0].notes.size());
    EXPECT_EQ("called by 2 functions of the standard library", found[0].notes[0].message);
    EXPECT_THAT(found[0].notes[1].message, HasSubstr("called by 'Average::updateHook()'"));
    EXPECT_THAT(arranged({allocation({kNew, user(13)})})[0].notes[0].message, HasSubstr("called by 'operator new"));
}

TEST(RtCheckArranged, OneLineIsOneFinding) {
    const auto found = arranged({allocation({kNew, kGrows, user(13)}), release({kGrows, user(13)}),
                                 allocation({kNew, user(13)}), allocation({kNew, user(14)})});
    ASSERT_EQ(2u, found.size());
    EXPECT_THAT(found[0].message, HasSubstr("malloc(), 8 times"));
    EXPECT_EQ("[RTC002] this line also frees memory: free(), 1 time", found[0].notes[0].message);
    EXPECT_EQ(14u, found[1].where.line);
}

TEST(RtCheckArranged, WithoutLinesEachCallIsOne) {
    const Note unknown = user(0);
    const auto found = arranged({allocation({kNew, unknown}), release({unknown})});
    ASSERT_EQ(2u, found.size());
    EXPECT_TRUE(lacksLines(found[0]));
}

}  // namespace
