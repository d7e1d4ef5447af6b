// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <console/line_source.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>

#include <unistd.h>

namespace {

using OCL::console::InputLines;
typedef OCL::console::LineSource::Outcome Outcome;

class Lines : public testing::Test {
protected:
    Lines() {
        EXPECT_EQ(0, pipe(input_));
        EXPECT_EQ(0, pipe(end_));
        lines_ = std::make_unique<InputLines>(input_[0], end_[0]);
    }
    ~Lines() override {
        for (const int descriptor : {input_[0], input_[1], end_[0], end_[1]}) close(descriptor);
    }
    void write(const std::string& text) {
        EXPECT_EQ(static_cast<ssize_t>(text.size()), ::write(input_[1], text.data(), text.size()));
    }
    void closeInput() {
        close(input_[1]);
        input_[1] = dup(input_[0]);  // something to close at the end
    }
    Outcome read() { return lines_->read("", line_); }

    int input_[2], end_[2];
    std::string line_;

private:
    std::unique_ptr<InputLines> lines_;
};

TEST_F(Lines, AreReadOneByOne) {
    write("one\n\ntwo\r\n");
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ("one", line_);
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ("", line_);
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ("two", line_);
}

TEST_F(Lines, TheLastNeedsNoEndOfLine) {
    write("one");
    closeInput();
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ("one", line_);
    EXPECT_EQ(Outcome::End, read());
}

TEST_F(Lines, EndWhenTheConsoleIsToEnd) {
    EXPECT_EQ(1, ::write(end_[1], "x", 1));
    EXPECT_EQ(Outcome::End, read());
}

TEST_F(Lines, ThatHaveComeAreNotReadOnceTheConsoleIsToEnd) {
    write("one\ntwo\n");
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ(1, ::write(end_[1], "x", 1));
    EXPECT_EQ(Outcome::End, read());
}

TEST_F(Lines, TheSignalIsSeenWhileTheyAreWaitedFor) {
    std::thread later([this] {
        usleep(20000);
        EXPECT_EQ(1, ::write(end_[1], "x", 1));
    });
    EXPECT_EQ(Outcome::End, read());
    later.join();
}

TEST_F(Lines, OfMoreThanABlockAreWhole) {
    const std::string text(10000, 'a');
    write(text + "\nb\n");
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ(text, line_);
    EXPECT_EQ(Outcome::Line, read());
    EXPECT_EQ("b", line_);
}

}  // namespace
